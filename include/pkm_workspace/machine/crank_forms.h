// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "pkm_workspace/interval/angle_form.h"
#include "pkm_workspace/interval/plain_vector.h"
#include "pkm_workspace/machine/crank_over_box.h"
#include "pkm_workspace/machine/leg_state.h"
#include "pkm_workspace/machine/limit_forms.h"

namespace pkm_workspace
{
// The formulas of a crank, in every arithmetic (docs/theory.md). With x = p - c, x_u = u . x, x_v = v . x,
// m = x_u^2 + x_v^2 and k = (x^2 + r^2 - L^2) / (2 r), which the part of x along the crank is equal to:
//   beta = s sqrt(m - k^2),  r cos th = r (k x_u + beta x_v) / m,  r sin th = r (k x_v - beta x_u) / m.
// The row n is the forearm, x less the tip (r cos th, r sin th), and b = beta r over the drive scale.

template <class Real>
using PlainCrank = CrankConstants<Real, PlainVector<Real>, PlainMatrix<Real>, PlainVector<Real>>;

template <class Real>
EnclosedMatrix<Real> asFirstRow(const IntervalVector& row)
{
  return EnclosedMatrix<Real>(IntervalMatrix{ row, IntervalVector{}, IntervalVector{} });
}
template <class Real, class Other>
EnclosedMatrix<Real> asFirstRow(const EnclosedMatrix<Other>& row)
{
  return EnclosedMatrix<Real>(row);
}

/// For affine forms in a type Real, of an EnclosedCrank or of the same in another type.
template <class Real, class... Constants>
CrankOfForms<Real> ofForms(const CrankConstants<Constants...>& crank)
{
  return { EnclosedMatrix<Real>(crank.identity), asFirstRow<Real>(crank.row_u),
           asFirstRow<Real>(crank.row_v),        EnclosedVector<Real>(crank.center),
           EnclosedVector<Real>(crank.u),        EnclosedVector<Real>(crank.v),
           Enclosed<Real>(crank.radius),         Enclosed<Real>(crank.half_per_radius),
           Enclosed<Real>(crank.squares),        Enclosed<Real>(crank.squared_length),
           Enclosed<Real>(crank.sign),           Enclosed<Real>(crank.gear),
           Enclosed<Real>(crank.per_gear),       Enclosed<Real>(crank.per_scale),
           Enclosed<Real>(crank.reference) };
}

/// Rounded: for finding points, not for proving anything.
template <class Real>
PlainCrank<Real> plain(const CrankOfForms<Real>& crank)
{
  return { crank.identity.value, crank.row_u.value[0],
           crank.row_v.value[0], crank.center.value,
           crank.u.value,        crank.v.value,
           crank.radius.value,   crank.half_per_radius.value,
           crank.squares.value,  crank.squared_length.value,
           crank.sign.value,     crank.gear.value,
           crank.per_gear.value, crank.per_scale.value,
           crank.reference.value };
}

namespace crank
{
inline Interval square(const Interval& x)
{
  return sqr(x);
}
template <class Number>
inline Number square(const Number& x)
{
  return x * x;
}

/// One coordinate of the tip, r f / m: from -r to r where m may be 0.
inline Interval tip(const Interval& f, const Interval& m, const Interval& radius)
{
  const Interval all(-radius.upper(), radius.upper());
  if (!m.certainlyPositive())
    return all;
  const Interval found = intersection(radius * f / m, all);
  return found.isEmpty() ? all : found;  // where the leg does not reach, which says nothing
}
template <class Real>
inline Real tip(const Real& f, const Real& m, const Real& radius)
{
  using std::max;
  return radius * f / max(m, Real(1e-300));
}

/// Takes f a from the vector, and once more.
inline void subtract(IntervalVector& v, const Interval& f, const IntervalVector& a)
{
  addAlong(v, -f, a);
}
template <class Real>
inline void subtract(PlainVector<Real>& v, const Real& f, const PlainVector<Real>& a)
{
  addAlong(v, -f, a);
}
}  // namespace crank

/// The leg as far as it goes without a root: x, which becomes the row, b^2 and what else follows from x.
template <class Number>
struct CrankOffsets
{
  Number u, v;  ///< x_u, x_v [m]
  Number m;     ///< [m^2]
  Number k;     ///< [m]
};

template <class... Constants, class Points, class State>
inline auto evaluateAcross(const CrankConstants<Constants...>& crank, const Points& p, State& state)
{
  CrankOffsets<std::decay_t<decltype(state.drive)>> x;
  mapOffset(crank.identity, crank.center, p, state.row);
  x.u = dotOffset(crank.row_u, crank.center, p);
  x.v = dotOffset(crank.row_v, crank.center, p);
  x.m = crank::square(x.u) + crank::square(x.v);
  x.k = crank.half_per_radius * (squaredNorm(state.row) + crank.squares);
  state.squared_drive = (crank.gear * crank.gear) * (x.m - crank::square(x.k));
  return x;
}

template <class... Constants, class Points, class Root, class State>
[[gnu::noinline]] void evaluate(const CrankConstants<Constants...>& crank, const Points& p, const Root& root,
                                State& state)
{
  const auto x = evaluateAcross(crank, p, state);
  state.drive = crank.sign * root(state.squared_drive);
  const auto beta = crank.per_gear * state.drive;
  crank::subtract(state.row, crank::tip(x.k * x.u + beta * x.v, x.m, crank.radius), crank.u);
  crank::subtract(state.row, crank::tip(x.k * x.v - beta * x.u, x.m, crank.radius), crank.v);
}

/// drive b^2 + row n^2, where n^2 = L^2.
template <class... Constants, class State, class Drive, class Row>
inline auto weighed(const CrankConstants<Constants...>& crank, const State& state, const Drive& drive, const Row& row)
{
  return drive * state.squared_drive + row * crank.squared_length;
}

template <class Number, class... Constants>
inline const Number& squaredRow(const CrankConstants<Number, Constants...>& crank, const Number& /*squared_drive*/)
{
  return crank.squared_length;
}

/// The tip [m]: r cos th and r sin th, th counted from the reference.
template <class... Constants, class Points, class State>
inline auto tipOf(const CrankConstants<Constants...>& crank, const Points& p, const State& state)
{
  return std::make_pair(dotOffset(crank.row_u, crank.center, p) - dot(crank.u, state.row),
                        dotOffset(crank.row_v, crank.center, p) - dot(crank.v, state.row));
}

/// The joint value th [rad].
template <class... Constants, class Points, class State>
inline auto jointOf(const CrankConstants<Constants...>& crank, const Points& p, const State& state)
{
  const auto [along, across] = tipOf(crank, p, state);
  return angleOf(along, across) + crank.reference;
}

/// r sin of the angle from the limit to th, or from th to the limit: the tip, x less n, along the way that it has
/// there.
template <class Real, class Points, class State>
inline AffineForm<Real> limitForm(const CrankOfForms<Real>& crank, const Points& p, const State& state,
                                  const JointLimit<Real>& limit)
{
  EnclosedVector<Real> way;
  for (std::size_t k = 0; k < 3; ++k)
  {
    using std::max;
    const Enclosed<Real> u(crank.u.value[k], crank.u.radius), v(crank.v.value[k], crank.v.radius);
    const Enclosed<Real> component = limit.cosine * v + -(limit.sine * u);
    way.value[k] = limit.is_upper ? -component.value : component.value;
    way.radius = max(way.radius, component.radius);
  }
  AffineVector<Real> x;
  mapOffset(crank.identity, crank.center, p, x);
  return dot(way, x) - dot(way, state.row);
}
template <class Real, class Points, class State>
inline Real limitForm(const PlainCrank<Real>& crank, const Points& p, const State& state, const JointLimit<Real>& limit)
{
  const auto [along, across] = tipOf(crank, p, state);
  const Real beyond = limit.cosine.value * across - limit.sine.value * along;
  return limit.is_upper ? -beyond : beyond;
}

/// With the tip's direction e and w across it, n' = t - r th' w, and n . n' = 0 once more derived:
/// n' . t - b' q' = t^2 - 2 th' (r w . t) + r k th'^2.
template <class Real, class Points, class State>
inline AffineForm<Real> turningOf(const CrankOfForms<Real>& crank, const Points& p, const State& state,
                                  const AffineVector<Real>& tangent, const AffineForm<Real>& speed)
{
  const auto [along, across] = tipOf(crank, p, state);
  State other;
  const auto x = evaluateAcross(crank, p, other);
  const AffineForm<Real> turn = crank.per_scale * speed;
  const AffineForm<Real> aside = along * dot(crank.v, tangent) - across * dot(crank.u, tangent);
  const AffineForm<Real> pull = crank.radius * x.k;
  return dot(tangent, tangent) + turn * (pull * turn - (aside + aside));
}

/// The leg in floating point. @param p tool point [m] @return whether the leg reaches it
bool evaluateNear(const EnclosedCrank& crank, const Eigen::Vector3d& p, LegAtPoint& leg);
}  // namespace pkm_workspace
