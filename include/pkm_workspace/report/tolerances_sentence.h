// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "pkm_workspace/machine/tolerances.h"

namespace pkm_workspace
{
/// What an answer about all machines within tolerances means: " This is about every machine within ...: ..."; "" for a
/// machine that is taken for exact.
std::string tolerancesSentence(const Machine& machine);
}  // namespace pkm_workspace
