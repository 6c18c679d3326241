// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/region/bad_point.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace pkm_workspace
{
namespace
{
/// How many extreme points are started from, and the steps from each.
constexpr std::size_t FAR_STARTS = 4;
constexpr int FAR_STEPS = 100;
}  // namespace

BadPointSearch::BadPointSearch(const BoxTest& test, const Shape& shape, const Eigen::Vector3d& center, double size)
  : test_(test), shape_(shape), center_(center), size_(size), step_(shape.halfExtents().at(size).maxCoeff())
{}

Eigen::Vector3d BadPointSearch::gradientAt(const Eigen::Vector3d& point, double margin) const
{
  const double difference = 1e-6 * step_;
  Eigen::Vector3d beside[] = { point, point, point };
  for (int axis = 0; axis < 3; ++axis)
    beside[axis][axis] += difference;
  Eigen::Vector3d margins;
  test_.kernel().margins(beside, 3, margins.data());
  return (margins.array() - margin) / difference;
}

Eigen::Vector3d BadPointSearch::descend(const Eigen::Vector3d& start, int steps) const
{
  Eigen::Vector3d point = shape_.nearest(start, center_, size_);
  double margin = test_.margin(point);
  double length = 0.5 * step_;
  Eigen::Vector3d gradient = gradientAt(point, margin);
  for (int step = 0; step < steps && gradient.norm() > 0.0; ++step)
  {
    const Eigen::Vector3d next = shape_.nearest(point - length * gradient.normalized(), center_, size_);
    const double next_margin = test_.margin(next);
    if (next_margin < margin)
    {
      point = next;
      margin = next_margin;
      gradient = gradientAt(point, margin);
    }
    else
      length *= 0.25;
  }
  return point;
}

Eigen::Vector3d BadPointSearch::worstFromFar() const
{
  std::vector<std::pair<double, Eigen::Vector3d>> points;
  const auto isWorse = [](const auto& a, const auto& b) { return a.first < b.first; };
  for (const Eigen::Vector3d& extreme : pointsOf(shape_.extremePoints(), center_, size_))
    points.emplace_back(test_.margin(extreme), extreme);
  std::sort(points.begin(), points.end(), isWorse);
  points.resize(std::min(points.size(), FAR_STARTS));
  for (auto& [margin, point] : points)
  {
    point = descend(point, FAR_STEPS);
    margin = test_.margin(point);
  }
  return std::min_element(points.begin(), points.end(), isWorse)->second;
}

std::optional<Eigen::Vector3d> BadPointSearch::proveBad(const Eigen::Vector3d& point) const
{
  const auto inside = nearestInside(shape_, point, center_, size_);
  return inside && test_.classify(*inside) == BoxVerdict::OUTSIDE ? inside : std::nullopt;
}
}  // namespace pkm_workspace
