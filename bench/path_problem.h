// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <cstddef>
#include <vector>

#include "pkm_workspace/interval/interval.h"

namespace pkm_workspace
{
namespace bench
{
/// A closed curve well inside of the Orthoglide's set. @param s from 0 to 1
inline Eigen::Vector3d curve(double s)
{
  const double angle = 2.0 * s * pi().mid();
  return { 0.05 + 0.2 * std::cos(angle), 0.05 + 0.2 * std::sin(angle), 0.05 * std::cos(3.0 * angle) };
}

/// Points along the curve, from its start to its end.
inline std::vector<Eigen::Vector3d> pointsOfCurve(std::size_t count)
{
  std::vector<Eigen::Vector3d> points;
  for (std::size_t i = 0; i < count; ++i)
    points.push_back(curve(static_cast<double>(i) / static_cast<double>(count - 1)));
  return points;
}
}  // namespace bench
}  // namespace pkm_workspace
