// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/dexterity/sphere_crossing.h"

namespace pkm_workspace
{
namespace
{
using Eigen::Vector3d;

/// Encloses |p - o|^2 - L^2 [m^2].
Interval excessAt(const StrutSphere& sphere, const IntervalVector& point)
{
  return squaredNorm(point - enclose(sphere.center())) - sqr(Interval(sphere.radius()));
}

/// Encloses a point on the sphere between a point within it and one beyond it, by bisection.
NearPoint pointBetween(const StrutSphere& sphere, const Vector3d& within, const Vector3d& beyond)
{
  const auto pointsAt = [&](const Interval& t) { return enclose(within) + t * (enclose(beyond) - enclose(within)); };
  Interval t(0.0, 1.0);
  for (bool is_narrower = true; is_narrower && t.lower() < t.mid() && t.mid() < t.upper();)
  {
    const Interval excess = excessAt(sphere, pointsAt(t.mid()));
    is_narrower = excess.upper() <= 0.0 || excess.lower() >= 0.0;
    if (is_narrower)
      t = excess.upper() <= 0.0 ? Interval(t.mid(), t.upper()) : Interval(t.lower(), t.mid());
  }
  const IntervalVector points = pointsAt(t);
  const Vector3d point = mid(points);
  return { point, norm(points - enclose(point)).upper() };
}
}  // namespace

std::optional<NearPoint> SphereCrossing::add(const Vector3d& point)
{
  const CenteredBox<double> box(Box{ point, point });
  for (std::size_t k = 0; k < spheres_.size(); ++k)
  {
    const StrutSphere& sphere = spheres_[k];
    if (point != sphere.center() && !sphere.hasInCone(box))
      continue;
    const Interval excess = excessAt(sphere, enclose(point));
    if (excess.certainlyNegative())
      sides_[k].within = point;
    else if (excess.certainlyPositive())
      sides_[k].beyond = point;
    if (sides_[k].within && sides_[k].beyond)
      return pointBetween(sphere, *sides_[k].within, *sides_[k].beyond);
  }
  return std::nullopt;
}
}  // namespace pkm_workspace
