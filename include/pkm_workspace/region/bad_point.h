// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <optional>

#include "pkm_workspace/dexterity/verdict.h"
#include "pkm_workspace/region/shape.h"

namespace pkm_workspace
{
/// Local search for a point of c + K(h) at which the criterion fails.
class BadPointSearch
{
public:
  BadPointSearch(const BoxTest& test, const Shape& shape, const Eigen::Vector3d& center, double size);

  /// Goes down the margin within the region, by projected steepest descent; floating point.
  /// @param steps at the most @return the worst point found [m]
  Eigen::Vector3d descend(const Eigen::Vector3d& start, int steps) const;

  /// The worst point that many steps lead to from the worst extreme points [m]: where the surface is near to the border
  /// all along a curve, the margin hardly changes on the way to its least.
  Eigen::Vector3d worstFromFar() const;

  /// A point within rounding of the given one that is proved to lie in the region and to violate the criterion, if any.
  std::optional<Eigen::Vector3d> proveBad(const Eigen::Vector3d& point) const;

private:
  Eigen::Vector3d gradientAt(const Eigen::Vector3d& point, double margin) const;

  const BoxTest& test_;
  const Shape& shape_;
  Eigen::Vector3d center_;
  double size_;
  double step_;  ///< first step length and difference quotients' base [m]
};
}  // namespace pkm_workspace
