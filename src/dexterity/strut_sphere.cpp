// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/dexterity/strut_sphere.h"

#include <cmath>

namespace pkm_workspace
{
namespace
{
using Eigen::Vector3d;

const IntervalMatrix IDENTITY = { enclose(Vector3d::UnitX()), enclose(Vector3d::UnitY()), enclose(Vector3d::UnitZ()) };

/// Whether the point is proved to lie on the line c + t e of a leg.
bool isOnLine(const Machine& machine, int leg, const Vector3d& point)
{
  for (const Interval& entry : cross(enclose(point) - machine.center(leg), machine.leg(leg).axis))
    if (entry != Interval(0.0))
      return false;
  return true;
}

/// The point of the first leg's line that is nearest to the second one's; floating point. @pre they are not parallel
Vector3d nearestOf(const Machine& machine, int first, int second)
{
  const Vector3d e = mid(machine.leg(first).axis);
  const Vector3d f = mid(machine.leg(second).axis);
  const Vector3d c = mid(machine.center(first));
  const Vector3d between = mid(machine.center(second)) - c;
  const double cosine = e.dot(f);
  return c + (between.dot(e) - cosine * between.dot(f)) / (1.0 - cosine * cosine) * e;
}
}  // namespace

StrutSphere::StrutSphere(const Vector3d& center, double radius, const IntervalVector& first,
                         const IntervalVector& second)
  : center_(center)
  , radius_(radius)
  , along_(IntervalMatrix{ first, second, IntervalVector{} })
  , identity_(IDENTITY)
  , origin_(enclose(center))
  , per_square_(Interval(1.0) / (Interval(2.0) * sqr(Interval(radius))))
{}

bool StrutSphere::hasInCone(const CenteredBox<double>& box) const
{
  AffineVector<double> along;
  mapOffset(along_, origin_, box, along);
  return component(along, 0).lower() >= 0.0 && component(along, 1).lower() >= 0.0;
}

AffineForm<double> StrutSphere::excess(const CenteredBox<double>& box) const
{
  AffineVector<double> from_center;
  mapOffset(identity_, origin_, box, from_center);
  return per_square_ * squaredNorm(from_center) + Enclosed<double>(Interval(-0.5));
}

std::vector<StrutSphere> strutSpheres(const Machine& machine)
{
  std::vector<StrutSphere> spheres;
  for (const auto& [first, second] : { std::pair(0, 1), std::pair(0, 2), std::pair(1, 2) })
  {
    const Leg& a = machine.leg(first);
    const Leg& b = machine.leg(second);
    if (!a.length.isSingle() || a.length != b.length || parallelSense(a, b) != 0)
      continue;
    const Vector3d meeting = nearestOf(machine, first, second);
    if (meeting.allFinite() && isOnLine(machine, first, meeting) && isOnLine(machine, second, meeting))
      spheres.emplace_back(meeting, a.length.lower(), Interval(a.working_mode) * a.axis,
                           Interval(b.working_mode) * b.axis);
  }
  return spheres;
}
}  // namespace pkm_workspace
