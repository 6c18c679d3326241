// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "pkm_workspace/region/placement.h"

namespace pkm_workspace
{
/// Says what is proved: where the workpiece is good and with which margin, that no translation leaves it a larger one,
/// and how large it may be.
std::string describe(const Placement& placement, const Machine& machine, const PlacementQuery& query);
}  // namespace pkm_workspace
