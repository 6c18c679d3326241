// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "pkm_workspace/dexterity/singularity.h"

namespace pkm_workspace
{
/// Says which kinds of singularities are proved to exist where the question looked, which are not, and what left the
/// others open.
/// @param machine whose legs the answers count @param budget that the search was given
std::string describe(const Singularities& found, const Machine& machine, const Budget& budget);
}  // namespace pkm_workspace
