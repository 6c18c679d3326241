// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/dexterity/strut_sphere.h"

#include <cmath>

#include "pkm_workspace/machine/rails.h"

namespace pkm_workspace
{
namespace
{
using Eigen::Vector3d;

const IntervalMatrix IDENTITY = { enclose(Vector3d::UnitX()), enclose(Vector3d::UnitY()), enclose(Vector3d::UnitZ()) };

/// Whether the point is proved to lie on the line c + t e of a leg.
bool isOnLine(const EnclosedStrut& strut, const Vector3d& point)
{
  for (const Interval& entry : cross(enclose(point) - strut.center, strut.axis))
    if (entry != Interval(0.0))
      return false;
  return true;
}

/// The point of the first leg's line that is nearest to the second one's; floating point. @pre they are not parallel
Vector3d nearestOf(const EnclosedStrut& first, const EnclosedStrut& second)
{
  const Vector3d e = mid(first.axis);
  const Vector3d f = mid(second.axis);
  const Vector3d c = mid(first.center);
  const Vector3d between = mid(second.center) - c;
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
    const auto* const a = std::get_if<EnclosedStrut>(&machine.enclosed(first));
    const auto* const b = std::get_if<EnclosedStrut>(&machine.enclosed(second));
    if (a == nullptr || b == nullptr || !a->length.isSingle() || a->length != b->length ||
        parallelSense(machine.leg(first), machine.leg(second)) != 0)
      continue;
    const Vector3d meeting = nearestOf(*a, *b);
    if (meeting.allFinite() && isOnLine(*a, meeting) && isOnLine(*b, meeting))
      spheres.emplace_back(meeting, a->length.lower(), a->sign * a->axis, b->sign * b->axis);
  }
  return spheres;
}
}  // namespace pkm_workspace
