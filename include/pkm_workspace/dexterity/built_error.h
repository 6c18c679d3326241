// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "pkm_workspace/dexterity/box_kernel.h"

namespace pkm_workspace
{
/// Of all machines within tolerances the one whose tool is farthest off, to first order, where the controller believes
/// it to be at the point [m]; in floating point. Nothing where the nominal machine does not reach it.
/// @param criterion with position_error_max, and errors of the joints besides
std::optional<WorstMachine> worstOfBuilt(const Machine& machine, const Criterion& criterion,
                                         const Eigen::Vector3d& point);
}  // namespace pkm_workspace
