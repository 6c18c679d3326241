// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>

#include "pkm_workspace/machine/machine.h"

namespace pkm_workspace
{
/// Where a machine's root frame stands in another frame: a point p of the root frame is R p + t there.
struct Pose
{
  std::array<double, 4> orientation = { 0.0, 0.0, 0.0, 1.0 };  ///< quaternion x, y, z, w; R is that of its direction
  Eigen::Vector3d translation = Eigen::Vector3d::Zero();       ///< t [m]
};

/// All p -> R p + t for R and t of the enclosures [m].
struct EnclosedMotion
{
  IntervalMatrix rotation;
  IntervalVector translation;
};

/// The norm of a quaternion may be this far from 1: decimals of four digits pass, other things that are not rotations
/// hardly do.
constexpr double NORM_TOLERANCE = 1e-3;

/// Encloses R, for the quaternion over its norm; of zero width for the identity.
/// @throws std::invalid_argument naming each number that is not finite, or the norm where it is not nearly 1
IntervalMatrix rotationOf(const Pose& pose);

/// Encloses R p + t [m]. @throws std::invalid_argument as rotationOf
IntervalVector transformed(const Pose& pose, const IntervalVector& p);

/// Expresses the machine in the frame that @p pose is given in, all roundings enclosed: the same machine, so that what
/// is proved of it holds there for regions along that frame's axes. Joint values, limits, working modes and the aspect
/// stay; the zero configuration's point is rounded. The geometry hash is that of the new numbers; the identity gives
/// the machine itself. Rails count as parallel iff they did before.
/// @throws std::invalid_argument as rotationOf, and where rounding loses the machine: far away from the frame's origin
Machine machineInFrame(const Machine& machine, const Pose& pose);
/// The same for all of these motions: what is proved of it holds for each of them.
Machine machineInFrame(const Machine& machine, const EnclosedMotion& motion);
}  // namespace pkm_workspace
