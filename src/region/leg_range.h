// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "pkm_workspace/machine/leg.h"
#include "pkm_workspace/region/joint_ranges.h"

namespace pkm_workspace
{
/// A region c + K(h).
struct PlacedShape
{
  const Shape& shape;
  Eigen::Vector3d center;
  double size;

  IntervalVector vertex(const GrowingVector& k) const { return enclose(center) + encloseAt(k, size); }
  Eigen::Vector3d nearest(const Eigen::Vector3d& point) const { return shape.nearest(point, center, size); }
  /// Encloses a point of the region: given by its place in the family, which rounds less than a point far from the
  /// origin.
  IntervalVector pointNear(const Eigen::Vector3d& point) const
  {
    return vertex(shape.placeOf(point - center, size).value_or(scaling(Eigen::Vector3d::Zero())));
  }
  /// Encloses the least n . (p - c) over the region.
  Interval leastAlong(const IntervalVector& n, const IntervalVector& c) const
  {
    return dot(n, enclose(center) - c) - shape.support({ -n[0], -n[1], -n[2] }).at(size);
  }
};

// One for each kind of leg; a file each.

/// Encloses what the leg's joint does over the region. @throws std::domain_error as jointRanges()
JointRange rangeOver(const EnclosedStrut& leg, const PlacedShape& region);
JointRange rangeOver(const EnclosedTelescope& leg, const PlacedShape& region);
JointRange rangeOver(const EnclosedCrank& leg, const PlacedShape& region);
}  // namespace pkm_workspace
