// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cmath>

#include "pkm_workspace/interval/interval.h"
#include "pkm_workspace/interval/rounding.h"
#include "pkm_workspace/interval/symbols.h"

namespace pkm_workspace
{
/// The set of functions f over delta in [-1, 1]^3 with |f(delta) - (center + gradient . delta)| <= radius. Where the
/// type has parameters (symbols.h), delta stands for these as well.
///
/// Guaranteed: if f and g are members of two forms, then f op g is a member of the result of op; rounding errors of any
/// mode are part of the radius (each operation relative to its magnitude, see rounding::roundoff). Overestimation is of
/// second order in the gradients. No branches, no allocation; Real is double or a multi-precision type.
template <class Real>
struct AffineForm
{
  Real center = Real(0);
  Gradient<Real> gradient = {};
  Real radius = Real(0);

  /// Sum of the gradient's magnitudes, rounded: the linear part stays within it, up to the rounding that range() adds.
  Real swing() const
  {
    using std::abs;
    Real sum = abs(gradient[0]);
    for (std::size_t j = 1; j < gradient.size(); ++j)
      sum = sum + abs(gradient[j]);
    return sum;
  }
  /// An approximate bound on |f|: enough for bounding roundings, which are blown up by more than its own error.
  Real magnitude() const
  {
    using std::abs;
    return abs(center) + swing() + radius;
  }
  /// Upper and lower bounds of f over the cube.
  Real upper() const { return center + spread(); }
  Real lower() const { return center - spread(); }
  /// A bound, rounding of the caller's next addition to center included, of |f - center|.
  Real spread() const
  {
    constexpr double roundings = 5 + SYMBOLS<Real>;
    return swing() + radius + Real(roundings) * rounding::roundoff<Real>() * magnitude() + rounding::underflow<Real>();
  }
};

namespace affine
{
/// Adds to a radius what @p operations roundings on numbers of at most @p magnitude can cost, its own summation
/// included.
template <class Real>
[[gnu::always_inline]] inline Real widened(Real radius, Real magnitude, int operations)
{
  const Real unit = rounding::roundoff<Real>();
  return radius * (Real(1) + Real(32) * unit) + Real(operations) * unit * magnitude + rounding::underflow<Real>();
}
}  // namespace affine

/// A number that is known by a double and a bound on its error.
template <class Real>
struct Enclosed
{
  Real value = Real(0);
  Real radius = Real(0);

  Enclosed() = default;
  Enclosed(const Real& v, const Real& r) : value(v), radius(r) {}
  explicit Enclosed(const Interval& x) : value(x.mid()), radius(x.radius()) {}
  template <class Other>
  explicit Enclosed(const Enclosed<Other>& x) : value(x.value), radius(x.radius)
  {}

  Real magnitude() const
  {
    using std::abs;
    return abs(value) + radius;
  }
  Real lower() const { return value - affine::widened(radius, magnitude(), 4); }
  Real upper() const { return value + affine::widened(radius, magnitude(), 4); }
};

template <class Real>
inline Enclosed<Real> operator-(const Enclosed<Real>& a)
{
  return { -a.value, a.radius };
}

template <class Real>
inline Enclosed<Real> operator+(const Enclosed<Real>& a, const Enclosed<Real>& b)
{
  return { a.value + b.value, affine::widened(a.radius + b.radius, a.magnitude() + b.magnitude(), 4) };
}

template <class Real>
inline Enclosed<Real> operator*(const Enclosed<Real>& a, const Enclosed<Real>& b)
{
  using std::abs;
  return { a.value * b.value,
           affine::widened(abs(a.value) * b.radius + a.radius * b.magnitude(), a.magnitude() * b.magnitude(), 4) };
}

template <class Real>
inline AffineForm<Real> operator-(const AffineForm<Real>& a)
{
  AffineForm<Real> minus;
  minus.center = -a.center;
  for (std::size_t j = 0; j < a.gradient.size(); ++j)
    minus.gradient[j] = -a.gradient[j];
  minus.radius = a.radius;
  return minus;
}

template <class Real>
inline AffineForm<Real> operator+(const AffineForm<Real>& a, const AffineForm<Real>& b)
{
  AffineForm<Real> sum;
  sum.center = a.center + b.center;
  for (std::size_t j = 0; j < sum.gradient.size(); ++j)
    sum.gradient[j] = a.gradient[j] + b.gradient[j];
  sum.radius = affine::widened(a.radius + b.radius, a.magnitude() + b.magnitude(), 4);
  return sum;
}

template <class Real>
inline AffineForm<Real> operator-(const AffineForm<Real>& a, const AffineForm<Real>& b)
{
  return a + (-b);
}

/// Encloses f + s.
template <class Real>
inline AffineForm<Real> operator+(AffineForm<Real> a, const Enclosed<Real>& s)
{
  using std::abs;
  a.radius = affine::widened(a.radius + s.radius, abs(a.center) + abs(s.value), 4);
  a.center = a.center + s.value;
  return a;
}

/// Encloses s - f.
template <class Real>
inline AffineForm<Real> operator-(const Enclosed<Real>& s, const AffineForm<Real>& a)
{
  return -a + s;
}

/// Encloses s f.
template <class Real>
inline AffineForm<Real> operator*(const Enclosed<Real>& s, const AffineForm<Real>& a)
{
  using std::abs;
  AffineForm<Real> product;
  product.center = s.value * a.center;
  for (std::size_t j = 0; j < product.gradient.size(); ++j)
    product.gradient[j] = s.value * a.gradient[j];
  const Real magnitude = a.magnitude();
  product.radius = affine::widened(abs(s.value) * a.radius + s.radius * magnitude, abs(s.value) * magnitude, 4);
  return product;
}

namespace affine
{
/// Sum of the magnitudes of a row's slopes that belong to parameters, rounded up; 0 where there are none.
template <class Real>
inline Real parameterSwing(const Gradient<Real>& slopes)
{
  using std::abs;
  Real sum(0);
  for (std::size_t j = 3; j < slopes.size(); ++j)
    sum = sum + abs(slopes[j]);
  return sum * (Real(1) + Real(2.0 * SYMBOLS<Real>) * rounding::roundoff<Real>());
}

/// What products of two slopes can be worth of which one belongs to a parameter, rounded up.
template <class Real>
inline Real parameterProducts(const Gradient<Real>& a, const Gradient<Real>& b)
{
  using std::abs;
  const Real of_a = parameterSwing<Real>(a);
  const Real of_b = parameterSwing<Real>(b);
  const Real deltas_a = abs(a[0]) + abs(a[1]) + abs(a[2]);
  const Real deltas_b = abs(b[0]) + abs(b[1]) + abs(b[2]);
  return (of_a * (deltas_b + of_b) + deltas_a * of_b) * (Real(1) + Real(16) * rounding::roundoff<Real>());
}
}  // namespace affine

/// Encloses f g. The squares delta_j^2 lie in [0, 1], so half of their coefficient moves into the center.
template <class Real>
inline AffineForm<Real> operator*(const AffineForm<Real>& a, const AffineForm<Real>& b)
{
  using std::abs;
  AffineForm<Real> product;
  Real shift = Real(0);
  Real squares = Real(0);
  for (std::size_t j = 0; j < 3; ++j)
  {
    product.gradient[j] = a.center * b.gradient[j] + b.center * a.gradient[j];
    shift = shift + a.gradient[j] * b.gradient[j];
    squares = squares + abs(a.gradient[j] * b.gradient[j]);
  }
  for (std::size_t j = 3; j < product.gradient.size(); ++j)
    product.gradient[j] = a.center * b.gradient[j] + b.center * a.gradient[j];
  Real mixed = Real(0);
  for (std::size_t j = 0; j < 3; ++j)
    for (std::size_t k = j + 1; k < 3; ++k)
      mixed = mixed + abs(a.gradient[j] * b.gradient[k] + a.gradient[k] * b.gradient[j]);
  product.center = a.center * b.center + shift / Real(2);
  const Real magnitude_a = a.magnitude();
  const Real magnitude_b = b.magnitude();
  Real radius = squares / Real(2) + mixed + a.radius * magnitude_b + b.radius * magnitude_a;
  if constexpr (SYMBOLS < Real >> 3)
    radius = radius + affine::parameterProducts<Real>(a.gradient, b.gradient);
  product.radius = affine::widened(radius, magnitude_a * magnitude_b, 16);
  return product;
}

/// Encloses 1 / f for a form that is positive on the whole cube; where it is not, the result has no meaning. The chord
/// of the hyperbola over the range of f, moved to the middle of its error.
template <class Real>
inline AffineForm<Real> inverseOf(const AffineForm<Real>& a)
{
  const Real low = a.lower();
  const Real high = a.upper();
  const Real slope = Real(1) / (low * high);
  const Real gap = high - low;
  // the chord is low + high - f, times the slope; below it the hyperbola reaches (sqrt(high) - sqrt(low))^2 slope,
  // and that is less than this
  const Real half_gap = gap * gap * slope / (Real(8) * low);
  AffineForm<Real> inverse;
  inverse.center = (low + high - a.center) * slope - half_gap;
  for (std::size_t j = 0; j < inverse.gradient.size(); ++j)
    inverse.gradient[j] = -(a.gradient[j] * slope);
  inverse.radius = affine::widened(a.radius * slope + half_gap, (low + high + a.magnitude()) * slope, 32);
  return inverse;
}

/// Encloses sqrt(f) wherever f >= floor; where f < floor nothing is said, and where that is everywhere the result has
/// no meaning. It is the chord of the square root over the range of f, moved to the middle of its error.
/// @param floor >= 0 [unit of f]
template <class Real>
inline AffineForm<Real> sqrtAbove(const AffineForm<Real>& a, const Real& floor)
{
  using std::max;
  using std::sqrt;
  const Real low = sqrt(max(a.lower(), floor));
  const Real high = max(sqrt(max(a.upper(), floor)), low) + rounding::underflow<Real>();
  const Real sum = low + high;
  const Real slope = Real(1) / sum;
  const Real half_gap = (high - low) * (high - low) / (Real(8) * sum);
  AffineForm<Real> root;
  root.center = a.center * slope + (low * high * slope + half_gap);
  for (std::size_t j = 0; j < root.gradient.size(); ++j)
    root.gradient[j] = a.gradient[j] * slope;
  root.radius = affine::widened(a.radius * slope + half_gap, high + a.magnitude() * slope, 32);
  return root;
}

/// Encloses max(f, g) = f + max(0, g - f), by the chord of max(0, x) over the range of x = g - f: for any t in [0, 1]
/// it lies above (1 - t) f + t g by at most max(t (-low), (1 - t) high).
template <class Real>
inline AffineForm<Real> maximum(const AffineForm<Real>& f, const AffineForm<Real>& g)
{
  using std::max;
  using std::min;
  const AffineForm<Real> difference = g - f;
  const Real low = difference.lower();
  const Real high = difference.upper();
  const Real span = max(high - low, rounding::underflow<Real>());
  const Real t = min(max(high / span, Real(0)), Real(1));
  const Enclosed<Real> rest(Real(1) - t, rounding::roundoff<Real>());
  AffineForm<Real> largest = rest * f + Enclosed<Real>(t, Real(0)) * g;
  const Real gap = max(max(t * -low, rest.value * high), Real(0));
  const Real half_gap = gap / Real(2);
  largest.radius = affine::widened(largest.radius + half_gap, max(largest.magnitude(), gap), 16);
  largest.center = largest.center + half_gap;
  return largest;
}
}  // namespace pkm_workspace
