// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <optional>

#include "pkm_workspace/machine/machine.h"

namespace pkm_workspace
{
/// Forward kinematics in floating point, in either aspect: forwardKinematics() is that for Machine::aspect().
/// @param rho joint values [m] @param aspect sign of det A, 1 or -1
/// @return the tool point [m] with the machine's working mode in every leg, or nothing where there is no such assembly
std::optional<Eigen::Vector3d> assemble(const Machine& machine, const Eigen::Vector3d& rho, int aspect);
}  // namespace pkm_workspace
