// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>

#include "pkm_workspace/interval/curve.h"

namespace pkm_workspace
{
/// Coordinates beyond this are no machine's [m]; their squares and cubes stay ordinary numbers.
constexpr double FARTHEST = 1e9;
/// How far the given end of an arc may be from the arc [m]; see PathSegment::arc.
constexpr double ARC_MISMATCH = 1e-5;
/// Three points of an arc must not be on a line: the sine of the angle at its start is more than this.
constexpr double ARC_LEAST_SINE = 1e-6;
/// Most turns of one segment [rad].
constexpr double ARC_LARGEST_ANGLE = 1e4;

/// A straight line, an arc of a circle in any plane, or a helix: exactly the curve that its doubles describe, known by
/// enclosures. Its parameter t runs from 0 to 1 with the length of the way.
///
/// Points and directions [m] in the machine's root frame, angles [rad]. Directions may have any length but 0.
/// @throws std::invalid_argument (all makers) with everything that is wrong with the numbers given
class PathSegment
{
public:
  /// From @p start to @p end; a point where these are the same.
  static PathSegment line(const Eigen::Vector3d& start, const Eigen::Vector3d& end);
  /// From @p start about the axis through @p center by @p angle, counter-clockwise where @p axis points to who looks:
  /// the circle has its center where start is projected onto the axis. On the way it climbs by @p lift along the axis.
  static PathSegment arc(const Eigen::Vector3d& start, const Eigen::Vector3d& center, const Eigen::Vector3d& axis,
                         double angle, double lift = 0.0);
  /// The whole circle, from @p start back to it.
  static PathSegment circle(const Eigen::Vector3d& start, const Eigen::Vector3d& center, const Eigen::Vector3d& axis);
  /// From @p start through @p via to @p end.
  static PathSegment arcThrough(const Eigen::Vector3d& start, const Eigen::Vector3d& via, const Eigen::Vector3d& end);
  /// From @p start about the axis to the direction of @p end, as machine tools have it: the whole circle where both are
  /// the same. The arc ends beside @p end by no more than ARC_MISMATCH, or it is refused.
  static PathSegment arcTo(const Eigen::Vector3d& start, const Eigen::Vector3d& center, const Eigen::Vector3d& axis,
                           const Eigen::Vector3d& end);
  /// The same, climbing along the axis to @p end on the way; the whole circle where start and end differ along the axis
  /// only. @param turns from 1 on: 2 is a whole turn more
  static PathSegment helixTo(const Eigen::Vector3d& start, const Eigen::Vector3d& center, const Eigen::Vector3d& axis,
                             const Eigen::Vector3d& end, int turns = 1);

  const Curve& curve() const { return curve_; }
  /// Start and end of what was made as a line, exactly [m].
  const std::optional<std::array<Eigen::Vector3d, 2>>& ends() const { return ends_; }
  /// Nearly the point at t [m]; t from 0 to 1.
  Eigen::Vector3d point(double t) const { return mid(curve_.point(t)); }

private:
  explicit PathSegment(const Curve& curve) : curve_(curve) {}
  /// @param radius of the circle, nearly [m]
  static PathSegment endingAt(const Eigen::Vector3d& end, const Curve& curve, double radius);

  Curve curve_;
  std::optional<std::array<Eigen::Vector3d, 2>> ends_;
};
}  // namespace pkm_workspace
