// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <utility>

#include "pkm_workspace/interval/interval_vector.h"
#include "pkm_workspace/interval/rounding.h"

namespace pkm_workspace
{
/// A closed axis-aligned box of points [m]; a side may have zero width. Its faces are doubles, so that the halves of a
/// bisected box share a face and together cover it without a gap.
struct Box
{
  Eigen::Vector3d lower = Eigen::Vector3d::Zero();
  Eigen::Vector3d upper = Eigen::Vector3d::Zero();

  /// A double near the middle, inside the box.
  Eigen::Vector3d center() const { return (0.5 * lower + 0.5 * upper).cwiseMax(lower).cwiseMin(upper); }
  /// Encloses the set of coordinates along @p axis.
  Interval side(int axis) const { return { lower[axis], upper[axis] }; }
  /// Upper bounds of the distances from center() to the faces.
  Eigen::Vector3d halfWidths() const { return { side(0).radius(), side(1).radius(), side(2).radius() }; }
  double width(int axis) const { return upper[axis] - lower[axis]; }
  /// The axis of the widest side; the first of equals.
  int widestAxis() const
  {
    int axis = 0;
    (upper - lower).maxCoeff(&axis);
    return axis;
  }
  double maxWidth() const { return (upper - lower).maxCoeff(); }
  /// Whether a plane between the two faces of @p axis is still a double of its own.
  bool canBisect(int axis) const
  {
    const double plane = center()[axis];
    return lower[axis] < plane && plane < upper[axis];
  }
  std::pair<Box, Box> splitAt(int axis, double plane) const
  {
    std::pair<Box, Box> halves(*this, *this);
    halves.first.upper[axis] = plane;
    halves.second.lower[axis] = plane;
    return halves;
  }
  std::pair<Box, Box> bisect(int axis) const { return splitAt(axis, center()[axis]); }

  bool contains(const Eigen::Vector3d& p) const
  {
    return (lower.array() <= p.array()).all() && (p.array() <= upper.array()).all();
  }
  bool isValid() const { return (lower.array() <= upper.array()).all(); }
  /// Encloses the volume [m^3].
  Interval volume() const
  {
    const auto length = [this](int axis) { return Interval(upper[axis]) - Interval(lower[axis]); };
    return length(0) * length(1) * length(2);
  }
  /// The same in the box's own dimension: sides without a width do not count [m^dimension]; 1 of a point.
  Interval measure() const
  {
    double measure = 1.0;
    for (int axis = 0; axis < 3; ++axis)
      if (lower[axis] < upper[axis])
        measure *= width(axis);
    const double error = 16.0 * rounding::roundoff<double>() * measure + rounding::underflow<double>();
    return { std::max(0.0, measure - error), measure + error };
  }
};

inline Box intersection(const Box& a, const Box& b)
{
  return { a.lower.cwiseMax(b.lower), a.upper.cwiseMin(b.upper) };
}

/// The smallest box of doubles that contains the set.
inline Box boundingBox(const IntervalVector& v)
{
  return { { v[0].lower(), v[1].lower(), v[2].lower() }, { v[0].upper(), v[1].upper(), v[2].upper() } };
}

inline IntervalVector enclose(const Box& box)
{
  return { box.side(0), box.side(1), box.side(2) };
}
}  // namespace pkm_workspace
