// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "leg_range.h"

namespace pkm_workspace
{
/// How far the points of a region are from a point.
class RegionDistance
{
public:
  explicit RegionDistance(const PlacedShape& region);

  /// Encloses the largest distance: that of a vertex, of a point of an extreme circle, or across a ball [m].
  Interval largest(const IntervalVector& from) const;
  /// Encloses the least distance, by a plane that keeps the region off [m].
  Interval least(const IntervalVector& from) const;
  /// Points of the region, enclosed, that are nearly the farthest and the nearest one; floating point.
  IntervalVector farthestPoint(const Eigen::Vector3d& from) const;
  IntervalVector nearestPoint(const Eigen::Vector3d& from) const;

private:
  const PlacedShape& region_;
  std::optional<Interval> ball_radius_;
  std::vector<Circle> circles_;
  std::vector<IntervalVector> vertices_;
};
}  // namespace pkm_workspace
