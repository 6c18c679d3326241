// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "pkm_workspace/interval/quadratic_form.h"
#include "pkm_workspace/machine/crank.h"

namespace pkm_workspace
{
// A crank over a box, to second order (docs/theory.md): part of crank_forms.h.

template <class Real>
using CrankOfForms = CrankConstants<Enclosed<Real>, EnclosedVector<Real>, EnclosedMatrix<Real>, EnclosedMatrix<Real>>;

namespace crank
{
/// The directions e and w in the crank's plane, in floating point, of the tip at delta = 0 and across it in the sense
/// of s; any two that are unit vectors across each other would do.
template <class Real>
inline void turnToMiddle(const CrankOfForms<Real>& crank, const AffineVector<Real>& x, EnclosedVector<Real>& e,
                         EnclosedVector<Real>& w)
{
  using std::max;
  using std::sqrt;
  const Real x_u = dot(crank.u.value, x.center), x_v = dot(crank.v.value, x.center);
  const Real m = x_u * x_u + x_v * x_v;
  const Real k = crank.half_per_radius.value * (dot(x.center, x.center) + crank.squares.value);
  const Real beta = crank.sign.value * sqrt(max(m - k * k, Real(0)));
  const Real cosine = k * x_u + beta * x_v, sine = k * x_v - beta * x_u;
  const Real length = sqrt(cosine * cosine + sine * sine);
  const auto is_known = length > Real(1e-290);
  const Real unit = Real(16) * rounding::roundoff<Real>();
  const Enclosed<Real> c(select(is_known, cosine / length, Real(1)), unit);
  const Enclosed<Real> s(select(is_known, sine / length, Real(0)), unit);
  for (std::size_t k = 0; k < 3; ++k)
  {
    const Enclosed<Real> u(crank.u.value[k], crank.u.radius), v(crank.v.value[k], crank.v.radius);
    const Enclosed<Real> e_k = c * u + s * v, w_k = crank.sign * (c * v + -(s * u));
    e.value[k] = e_k.value;
    w.value[k] = w_k.value;
    e.radius = max(e.radius, e_k.radius);
    w.radius = max(w.radius, w_k.radius);
  }
}

/// By how much the tip is behind r e, less r, and beside it, over r: cos phi = 1 - 2 t^2 + 2 t^4 / (1 + t^2) and
/// sin phi = 2 t - 2 t^3 / (1 + t^2) for t = tan(phi / 2). On [-T, T] 2 t^3 is within T^3 / 2 of 3/2 T^2 t.
template <class Real>
struct TipForms
{
  QuadraticForm<Real> minus_cosine;
  QuadraticForm<Real> sine;
  Real most;  ///< T

  explicit TipForms(const QuadraticForm<Real>& t)
  {
    using std::max;
    const AffineForm<Real> tangent = flat(t);
    most = max(tangent.upper(), -tangent.lower());
    const Real most_square = most * most;
    const Real unit = rounding::roundoff<Real>();
    sine = Enclosed<Real>(Real(2) - Real(1.5) * most_square, Real(8) * unit) * t;
    widen(sine, most * most_square * (Real(0.5) + Real(2) * most_square));
    minus_cosine = Enclosed<Real>(Real(2), Real(0)) * squared(t);
    minus_cosine.linear = minus_cosine.linear + Enclosed<Real>(Real(-1), Real(0));
    widen(minus_cosine, Real(2) * most_square * most_square);
  }

private:
  static void widen(QuadraticForm<Real>& form, const Real& by)
  {
    form.linear.radius = affine::widened(form.linear.radius + by, by, 16);
  }
};

/// f r where the mask is set, elsewhere 0.
template <class Real, class Mask>
inline QuadraticForm<Real> scaledWhere(const Mask& mask, const Enclosed<Real>& r, const QuadraticForm<Real>& f)
{
  QuadraticForm<Real> scaled = r * f;
  scaled.linear.center = select(mask, scaled.linear.center, Real(0));
  for (Real& slope : scaled.linear.gradient)
    slope = select(mask, slope, Real(0));
  scaled.linear.radius = select(mask, scaled.linear.radius, Real(0));
  for (Real& coefficient : scaled.second)
    coefficient = select(mask, coefficient, Real(0));
  return scaled;
}
}  // namespace crank

/// Over a box, to second order: with e and w of its middle the tip is r (e cos phi + w sin phi), and tan(phi / 2) =
/// (k - x_e) / (x_w + |beta|) (docs/theory.md). Where phi may be large the tip is anywhere within r of the pivot.
template <class Real, class Points, class Root, class State>
[[gnu::noinline, gnu::flatten]] void evaluate(const CrankOfForms<Real>& crank, const Points& p, const Root& root,
                                              State& state, QuadraticVector<Real>& row)
{
  mapOffset(crank.identity, crank.center, p, row.linear);
  EnclosedVector<Real> e, w;
  crank::turnToMiddle(crank, row.linear, e, w);
  const AffineForm<Real> x_e = dot(e, row.linear), x_w = dot(w, row.linear);
  QuadraticForm<Real> square = product(row.linear, row.linear);
  square.linear = square.linear + crank.squares;
  const QuadraticForm<Real> k = crank.half_per_radius * square;
  state.squared_drive = flat((crank.gear * crank.gear) * ((product(x_e, x_e) + product(x_w, x_w)) - squared(k)));
  const AffineForm<Real> drive = root(state.squared_drive);
  state.drive = crank.sign * drive;
  const AffineForm<Real> sum = x_w + crank.per_gear * drive;
  const crank::TipForms<Real> tip((k - x_e) * inverseOf(sum));
  // far from 0: the error of the chord of an inverse is relative to its lower end
  const auto holds = (sum.lower() > Real(0x1p-20) * sum.upper()) & (tip.most < Real(0.7));
  addAlong(row, crank::scaledWhere(holds, crank.radius, tip.minus_cosine), e);
  addAlong(row, -crank::scaledWhere(holds, crank.radius, tip.sine), w);
  row.linear.radius = row.linear.radius + select(holds, Real(0), affine::widened(crank.radius.magnitude(), Real(0), 0));
  state.row = flat(row);
}
template <class Real, class Points, class Root, class State>
inline void evaluate(const CrankOfForms<Real>& crank, const Points& p, const Root& root, State& state)
{
  QuadraticVector<Real> row;
  evaluate(crank, p, root, state, row);
}
}  // namespace pkm_workspace
