// SPDX-License-Identifier: BSD-3-Clause
#include "region_distance.h"

#include <algorithm>

namespace pkm_workspace
{
using Eigen::Vector3d;

namespace
{
/// The farthest point of a circle about the direction z.
Vector3d farthestOn(const Circle& circle, const Vector3d& from)
{
  Vector3d out = mid(circle.center) - from;
  out.z() = 0.0;
  const double length = out.norm();
  return mid(circle.center) + circle.radius.mid() * (length > 0.0 ? Vector3d(out / length) : Vector3d::UnitX());
}

Interval largestDistance(const Circle& circle, const IntervalVector& from)
{
  const IntervalVector offset = circle.center - from;
  const Interval in_plane = sqrtAboveZero(sqr(offset[0]) + sqr(offset[1])) + circle.radius;
  return sqrtAboveZero(sqr(in_plane) + sqr(offset[2]));
}
}  // namespace

RegionDistance::RegionDistance(const PlacedShape& region)
  : region_(region)
  , ball_radius_(region.shape.ballRadius(region.size))
  , circles_(region.shape.extremeCircles(region.center, region.size))
{
  if (!ball_radius_ && circles_.empty())
    for (const GrowingVector& k : region.shape.extremePoints())
      vertices_.push_back(region.vertex(k));
}

Interval RegionDistance::largest(const IntervalVector& from) const
{
  if (ball_radius_)
    return norm(enclose(region_.center) - from) + *ball_radius_;
  Interval most = norm(enclose(region_.center) - from);
  const auto take = [&most](const Interval& x) {
    most = { std::max(most.lower(), x.lower()), std::max(most.upper(), x.upper()) };
  };
  for (const Circle& circle : circles_)
    take(largestDistance(circle, from));
  for (const IntervalVector& vertex : vertices_)
    take(norm(vertex - from));
  return most;
}

Interval RegionDistance::least(const IntervalVector& from) const
{
  const Vector3d middle = mid(from);
  const IntervalVector n = enclose(Vector3d(region_.nearest(middle) - middle));
  const double attained = norm(nearestPoint(middle) - from).upper();
  const Interval length = norm(n);
  if (!length.certainlyPositive())
    return { 0.0, attained };
  const double bound = (region_.leastAlong(n, from) / length).lower();
  return { std::clamp(bound, 0.0, attained), attained };
}

IntervalVector RegionDistance::farthestPoint(const Vector3d& from) const
{
  if (ball_radius_)
  {
    const Vector3d out = region_.center - from;
    return region_.pointNear(region_.center + ball_radius_->mid() / std::max(out.norm(), 1e-300) * out);
  }
  Vector3d best = region_.center;
  const auto take = [&](const Vector3d& point) {
    if ((point - from).squaredNorm() > (best - from).squaredNorm())
      best = point;
  };
  for (const Circle& circle : circles_)
    take(farthestOn(circle, from));
  IntervalVector farthest = region_.pointNear(best);
  for (const IntervalVector& vertex : vertices_)
  {
    take(mid(vertex));
    if (best == mid(vertex))
      farthest = vertex;
  }
  return farthest;
}

IntervalVector RegionDistance::nearestPoint(const Vector3d& from) const
{
  return region_.pointNear(region_.nearest(from));
}
}  // namespace pkm_workspace
