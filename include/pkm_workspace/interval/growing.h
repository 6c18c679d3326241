// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <vector>

#include "pkm_workspace/interval/interval_vector.h"

namespace pkm_workspace
{
/// What grows with the size h of a region: fixed + h per_size.
template <class T>
struct Growing
{
  T fixed;
  T per_size;

  /// Of doubles in floating point, of intervals an enclosure.
  T at(double size) const { return fixed + size * per_size; }
};

/// A point of a body, as seen from the center of its region [m].
using GrowingVector = Growing<Eigen::Vector3d>;

/// One that is the center where the size is 0.
inline GrowingVector scaling(const Eigen::Vector3d& per_size)
{
  return { Eigen::Vector3d::Zero(), per_size };
}

/// Their places in the region of that center and size, in floating point [m].
inline std::vector<Eigen::Vector3d> pointsOf(const std::vector<GrowingVector>& places, const Eigen::Vector3d& center,
                                             double size)
{
  std::vector<Eigen::Vector3d> points;
  points.reserve(places.size());
  for (const GrowingVector& place : places)
    points.push_back(center + place.at(size));
  return points;
}

/// Most bodies have only one of the two parts: what is 0 costs no rounding.
inline Interval encloseAt(const Growing<double>& x, double size)
{
  const Interval grown = x.per_size == 0.0 ? Interval(0.0) : Interval(size) * Interval(x.per_size);
  return x.fixed == 0.0 ? grown : Interval(x.fixed) + grown;
}

inline IntervalVector encloseAt(const GrowingVector& v, double size)
{
  const auto entry = [&](int k) { return encloseAt(Growing<double>{ v.fixed[k], v.per_size[k] }, size); };
  return { entry(0), entry(1), entry(2) };
}

inline GrowingVector operator+(const GrowingVector& a, const GrowingVector& b)
{
  return { a.fixed + b.fixed, a.per_size + b.per_size };
}

inline GrowingVector operator-(const GrowingVector& a, const GrowingVector& b)
{
  return { a.fixed - b.fixed, a.per_size - b.per_size };
}

inline GrowingVector operator*(double s, const GrowingVector& v)
{
  return { s * v.fixed, s * v.per_size };
}
}  // namespace pkm_workspace
