// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "pkm_workspace/region/tolerable_factor.h"

namespace pkm_workspace
{
/// What is proved about the factor, where the region fails beyond it, and which machine does.
std::string describe(const TolerableFactor& found, const Machine& machine, const FactorQuery& query);

/// One machine by what it differs in from what was meant, leg by leg: "rail_x: slider off by (..) m, strut 0.1 m".
std::vector<std::string> differencesInWords(const Machine& built, const Machine& meant);
}  // namespace pkm_workspace
