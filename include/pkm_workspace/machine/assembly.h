// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>

#include "pkm_workspace/machine/machine.h"

namespace pkm_workspace
{
/// Forward kinematics in floating point, in either aspect: forwardKinematics() is that for Machine::aspect().
/// @param rho joint values [m] @param aspect sign of det A, 1 or -1
/// @return the tool point [m] with the machine's working mode in every leg, or nothing where there is no such assembly
std::optional<Eigen::Vector3d> assemble(const Machine& machine, const Eigen::Vector3d& rho, int aspect);

/// Both tool points at which the struts meet [m], whatever the working modes; nothing where they do not.
std::optional<std::array<Eigen::Vector3d, 2>> assemblies(const Machine& machine, const Eigen::Vector3d& rho);

/// Where three spheres meet, in floating point (trilateration).
/// @param centers one a column [m] @param radii [m] @return the two points [m], or nothing
std::optional<std::array<Eigen::Vector3d, 2>> meetingPoints(const Eigen::Matrix3d& centers,
                                                            const Eigen::Vector3d& radii);
}  // namespace pkm_workspace
