// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "pkm_workspace/dexterity/zone_forms.h"
#include "pkm_workspace/interval/affine_vector.h"
#include "pkm_workspace/interval/pack.h"

namespace pkm_workspace
{
/// A plane between a box of points and a zone to keep out of (docs/theory.md, zones): touching bodies are told apart by
/// one plane, however near they are, where forms of the distance are not.
namespace separation
{
/// Passes over the three directions of a box that look for its point nearest to the zone: one is enough for zones along
/// the axes of the box.
constexpr int PASSES = 3;

/// How far u is beyond [-half, half].
template <class Real>
inline Real excess(const Real& u, const Real& half)
{
  using std::max;
  using std::min;
  return u - max(min(u, half), -half);
}

/// From the point of the zone nearest to u, in its own axes, towards u; of any length, 0 within the zone.
template <class Real>
PlainVector<Real> outward(const PlainZone<Real>& zone, const PlainVector<Real>& u)
{
  using std::max;
  using std::sqrt;
  const Real zero(0.0);
  switch (zone.kind)
  {
    case Zone::Kind::BOX:
      return { excess(u[0], zone.half[0]), excess(u[1], zone.half[1]), excess(u[2], zone.half[2]) };
    case Zone::Kind::SPHERE:
      return u;
    case Zone::Kind::CYLINDER:
    {
      if (!zone.has_ends)
        return { u[0], u[1], zero };
      const Real along = excess(u[2], zone.half[2]);
      const Real radius = sqrt(u[0] * u[0] + u[1] * u[1]);
      const Real share = max(radius - zone.half[0], zero) / max(radius, Real(1e-300));
      const Real across = select(along * along > zero, share, Real(1.0));  // beside the wall its length does not matter
      return { across * u[0], across * u[1], along };
    }
    case Zone::Kind::HALF_SPACE:
      break;
  }
  return { zero, zero, zero };
}

/// The largest n . u over the zone, at the most [m].
template <class Real>
Enclosed<Real> support(const ZoneOfForms<Real>& zone, const PlainVector<Real>& n)
{
  using std::abs;
  const auto exactly = [](const Real& x) { return Enclosed<Real>(x, Real(0.0)); };
  switch (zone.kind)
  {
    case Zone::Kind::BOX:
      return zone.half[0] * exactly(abs(n[0])) + zone.half[1] * exactly(abs(n[1])) + zone.half[2] * exactly(abs(n[2]));
    case Zone::Kind::SPHERE:
      return zone.half[0] * enclosedNorm(n);
    case Zone::Kind::CYLINDER:
      return zone.half[0] * enclosedNorm(PlainVector<Real>{ n[0], n[1], Real(0.0) }) +
             zone.half[2] * exactly(abs(n[2]));
    case Zone::Kind::HALF_SPACE:
      break;
  }
  return exactly(Real(0.0));
}
}  // namespace separation

/// A form that is positive only beyond the zone: how far the box's points are beyond a plane that touches it, the one
/// across the way from the zone to the nearest point of the box; 0 for a half-space, which is one itself.
/// @param near the zone, rounded @param u the box in the zone's own axes [m]
template <class Real>
AffineForm<Real> separatingForm(const ZoneOfForms<Real>& zone, const PlainZone<Real>& near,
                                const std::array<AffineForm<Real>, 3>& u)
{
  using std::max;
  using std::min;
  PlainVector<Real> point = { u[0].center, u[1].center, u[2].center };
  PlainVector<Real> delta = { Real(0.0), Real(0.0), Real(0.0) };
  for (int pass = 0; pass < separation::PASSES; ++pass)
    for (std::size_t j = 0; j < 3; ++j)
    {
      const PlainVector<Real> edge = { u[0].gradient[j], u[1].gradient[j], u[2].gradient[j] };
      const Real step = dot(edge, separation::outward(near, point)) / max(squaredNorm(edge), Real(1e-300));
      const Real next = min(max(delta[j] - step, Real(-1.0)), Real(1.0));
      addAlong(point, next - delta[j], edge);
      delta[j] = next;
    }
  const PlainVector<Real> n = separation::outward(near, point);
  AffineForm<Real> beyond;
  for (std::size_t k = 0; k < 3; ++k)
    beyond = beyond + Enclosed<Real>(n[k], Real(0.0)) * u[k];
  return beyond + -separation::support(zone, n);
}
}  // namespace pkm_workspace
