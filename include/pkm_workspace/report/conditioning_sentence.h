// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "pkm_workspace/dexterity/global_conditioning.h"

namespace pkm_workspace
{
/// Says what is proved about the global conditioning index, if anything, and what kept the accuracy from being met.
/// @param budget that the computation was given
std::string describe(const GlobalConditioning& found, const Budget& budget);
}  // namespace pkm_workspace
