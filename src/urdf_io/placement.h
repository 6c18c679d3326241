// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "pkm_workspace/interval/interval_vector.h"

namespace pkm_workspace
{
namespace urdf_io
{
/// Roll, pitch and yaw as a URDF has them: turns about the fixed axes x, y, z, in this order [rad].
using Angles = std::array<double, 3>;

/// Where a joint stands in its parent link: the numbers of its <origin>, as read.
struct Origin
{
  Eigen::Vector3d xyz = Eigen::Vector3d::Zero();  ///< [m]
  Angles rpy{};                                   ///< [rad]
};

/// Encloses the rotation matrix Rz(yaw) Ry(pitch) Rx(roll).
IntervalMatrix rotation(const Angles& rpy);

/// Encloses |v|; exact for a vector along one of the axes.
Interval lengthOf(const IntervalVector& v);

/// Encloses v / |v| for the exact vector @p v, not 0; of zero width for a vector along one of the axes.
IntervalVector unitVector(const Eigen::Vector3d& v);

/// A frame of the model, seen from another one that its chain of joints starts at, all joints at zero.
struct Frame
{
  std::vector<Angles> turns;  ///< the rotations that lead to it, from the outside in, without those by nothing
  IntervalMatrix rotation{ IntervalVector{ 1.0, 0.0, 0.0 }, IntervalVector{ 0.0, 1.0, 0.0 },
                           IntervalVector{ 0.0, 0.0, 1.0 } };
  IntervalVector position{ 0.0, 0.0, 0.0 };  ///< [m]

  /// The frame at @p origin in this one.
  Frame then(const Origin& origin) const;
  /// Encloses the point that is @p local in this frame, seen from the outer one [m].
  IntervalVector toOuter(const IntervalVector& local) const { return position + rotation * local; }
};

/// The direction of a joint's axis, kept in a form that tells exact parallels apart from near ones: an exact vector and
/// the rotations that still turn it. A rotation that maps the vector exactly (any yaw does, about z) is not among them.
struct Direction
{
  std::vector<Angles> turns;
  Eigen::Vector3d axis;      ///< not 0, of any length
  IntervalVector enclosure;  ///< encloses the unit direction, seen from the outer frame
};
Direction directionIn(const Frame& frame, const Eigen::Vector3d& axis);

/// @return +1 or -1 where the directions are proved to be the same or opposite, else 0 (they may be so nevertheless)
int exactlyParallel(const Direction& a, const Direction& b);
}  // namespace urdf_io
}  // namespace pkm_workspace
