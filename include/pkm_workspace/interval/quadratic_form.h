// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "pkm_workspace/interval/affine_vector.h"

namespace pkm_workspace
{
/// The set of functions within the radius of center + gradient . delta + sum of second_jl delta_j delta_l: an affine
/// form that keeps what is of second order in the deltas until a sum is complete, where much of it cancels. Members
/// keep to operations as those of affine forms do; what is of third order goes into the radius.
template <class Real>
struct QuadraticForm
{
  AffineForm<Real> linear;
  std::array<Real, 6> second = {};  ///< of delta_0^2, delta_1^2, delta_2^2, then of the pairs 12, 02, 01

  QuadraticForm() = default;
  QuadraticForm(const AffineForm<Real>& f) : linear(f) {}

  /// Sum of the magnitudes of the second order, rounded.
  Real bend() const
  {
    using std::abs;
    return abs(second[0]) + abs(second[1]) + abs(second[2]) + abs(second[3]) + abs(second[4]) + abs(second[5]);
  }
  /// As that of an affine form.
  Real magnitude() const { return linear.magnitude() + bend(); }
};

/// The affine form of the same functions: squares of deltas lie in [0, 1], so that half of their coefficients moves
/// into the center.
template <class Real>
inline AffineForm<Real> flat(const QuadraticForm<Real>& q)
{
  using std::abs;
  const Real half(0.5);
  const auto& s = q.second;
  AffineForm<Real> form = q.linear;
  form.center = form.center + half * (s[0] + s[1] + s[2]);
  form.radius =
      affine::widened(form.radius + half * (abs(s[0]) + abs(s[1]) + abs(s[2])) + (abs(s[3]) + abs(s[4]) + abs(s[5])),
                      abs(q.linear.center) + q.bend(), 16);
  return form;
}

template <class Real>
inline QuadraticForm<Real> operator+(const QuadraticForm<Real>& a, const QuadraticForm<Real>& b)
{
  QuadraticForm<Real> sum = a.linear + b.linear;
  for (std::size_t k = 0; k < 6; ++k)
    sum.second[k] = a.second[k] + b.second[k];
  sum.linear.radius = affine::widened(sum.linear.radius, a.bend() + b.bend(), 4);
  return sum;
}

template <class Real>
inline QuadraticForm<Real> operator-(QuadraticForm<Real> a)
{
  a.linear = -a.linear;
  for (Real& coefficient : a.second)
    coefficient = -coefficient;
  return a;
}
template <class Real>
inline QuadraticForm<Real> operator-(const QuadraticForm<Real>& a, const QuadraticForm<Real>& b)
{
  return a + -b;
}

template <class Real>
inline QuadraticForm<Real> operator+(QuadraticForm<Real> a, const AffineForm<Real>& b)
{
  a.linear = a.linear + b;
  return a;
}
template <class Real>
inline QuadraticForm<Real> operator-(QuadraticForm<Real> a, const AffineForm<Real>& b)
{
  a.linear = a.linear - b;
  return a;
}

template <class Real>
inline QuadraticForm<Real> operator*(const Enclosed<Real>& s, const QuadraticForm<Real>& q)
{
  QuadraticForm<Real> product = s * q.linear;
  for (std::size_t k = 0; k < 6; ++k)
    product.second[k] = s.value * q.second[k];
  const Real bend = q.bend();
  product.linear.radius = affine::widened(product.linear.radius + s.radius * bend, s.magnitude() * bend, 4);
  return product;
}

namespace affine
{
/// Adds f g as far as it is of second order in the deltas, for two affine forms.
template <class Real>
inline void addProduct(const Gradient<Real>& a, const Gradient<Real>& b, std::array<Real, 6>& second)
{
  for (std::size_t j = 0; j < 3; ++j)
  {
    const std::size_t k = (j + 1) % 3, l = (j + 2) % 3;
    second[j] = second[j] + a[j] * b[j];
    second[3 + j] = second[3 + j] + (a[k] * b[l] + a[l] * b[k]);
  }
}

/// What the second order is at most off the middle of its squares, which is told as well.
template <class Real>
struct Bend
{
  Real middle;
  Real off;

  explicit Bend(const std::array<Real, 6>& s)
  {
    using std::abs;
    const Real half(0.5);
    middle = half * (s[0] + s[1] + s[2]);
    off = half * (abs(s[0]) + abs(s[1]) + abs(s[2])) + (abs(s[3]) + abs(s[4]) + abs(s[5]));
  }
};
}  // namespace affine

/// Encloses f g.
template <class Real>
inline QuadraticForm<Real> product(const AffineForm<Real>& a, const AffineForm<Real>& b)
{
  QuadraticForm<Real> result;
  result.linear.center = a.center * b.center;
  for (std::size_t j = 0; j < a.gradient.size(); ++j)
    result.linear.gradient[j] = a.center * b.gradient[j] + b.center * a.gradient[j];
  affine::addProduct<Real>(a.gradient, b.gradient, result.second);
  const Real magnitude_a = a.magnitude(), magnitude_b = b.magnitude();
  Real radius = a.radius * magnitude_b + b.radius * magnitude_a;
  if constexpr (SYMBOLS < Real >> 3)
    radius = radius + affine::parameterProducts<Real>(a.gradient, b.gradient);
  result.linear.radius = affine::widened(radius, magnitude_a * magnitude_b, 16);
  return result;
}

template <class Real>
inline QuadraticForm<Real> operator*(const QuadraticForm<Real>& a, const AffineForm<Real>& b)
{
  QuadraticForm<Real> result = product(a.linear, b);
  const affine::Bend<Real> bend(a.second);
  for (std::size_t k = 0; k < 6; ++k)
    result.second[k] = result.second[k] + b.center * a.second[k];
  for (std::size_t j = 0; j < b.gradient.size(); ++j)
    result.linear.gradient[j] = result.linear.gradient[j] + bend.middle * b.gradient[j];
  const Real most = a.bend();
  result.linear.radius =
      affine::widened(result.linear.radius + bend.off * b.swing() + b.radius * most, most * b.magnitude(), 16);
  return result;
}

template <class Real>
inline QuadraticForm<Real> squared(const QuadraticForm<Real>& a)
{
  QuadraticForm<Real> result = product(a.linear, a.linear);
  const affine::Bend<Real> bend(a.second);
  for (std::size_t k = 0; k < 6; ++k)
    result.second[k] = result.second[k] + Real(2) * a.linear.center * a.second[k];
  for (std::size_t j = 0; j < a.linear.gradient.size(); ++j)
    result.linear.gradient[j] = result.linear.gradient[j] + Real(2) * bend.middle * a.linear.gradient[j];
  const Real most = a.bend();
  const Real half = Real(0.5) * most * most;  // of the square of the second order
  result.linear.center = result.linear.center + half;
  const Real beyond = Real(2) * (bend.off * a.linear.swing() + a.linear.radius * most) + half;
  result.linear.radius = affine::widened(result.linear.radius + beyond, most * (most + a.linear.magnitude()), 24);
  return result;
}

/// A vector-valued quadratic form.
template <class Real>
struct QuadraticVector
{
  AffineVector<Real> linear;
  std::array<std::array<Real, 6>, 3> second = {};  ///< [component]

  /// Sum of the magnitudes of the components' second order, rounded.
  Real bend() const
  {
    Real sum(0);
    for (const auto& s : second)
    {
      using std::abs;
      for (const Real& coefficient : s)
        sum = sum + abs(coefficient);
    }
    return sum;
  }
};

/// The affine vector of the same functions.
template <class Real>
inline AffineVector<Real> flat(const QuadraticVector<Real>& v)
{
  using std::abs;
  using std::max;
  AffineVector<Real> result = v.linear;
  Real radius(0), size(0);
  for (std::size_t k = 0; k < 3; ++k)
  {
    const affine::Bend<Real> bend(v.second[k]);
    size = size + abs(result.center[k]);
    result.center[k] = result.center[k] + bend.middle;
    radius = max(radius, bend.off);
  }
  result.radius = affine::widened(result.radius + radius, size + v.bend(), 16);
  return result;
}

/// Adds f a for a constant vector a.
template <class Real>
inline void addAlong(QuadraticVector<Real>& v, const QuadraticForm<Real>& f, const EnclosedVector<Real>& a)
{
  affine::spreadError(v.linear);
  addAlong(v.linear, f.linear, a);
  const Real bend = f.bend();
  for (std::size_t k = 0; k < 3; ++k)
    for (std::size_t l = 0; l < 6; ++l)
      v.second[k][l] = v.second[k][l] + f.second[l] * a.value[k];
  v.linear.radius =
      affine::widened(v.linear.radius + a.radius * bend, v.bend() + bend * affine::sumOfMagnitudes(a.value), 4);
}

/// Encloses u . v.
template <class Real>
inline QuadraticForm<Real> product(const AffineVector<Real>& u, const AffineVector<Real>& v)
{
  QuadraticForm<Real> result;
  for (std::size_t k = 0; k < 3; ++k)
  {
    result.linear.center = result.linear.center + u.center[k] * v.center[k];
    for (std::size_t j = 0; j < u.linear[k].size(); ++j)
      result.linear.gradient[j] =
          result.linear.gradient[j] + (u.center[k] * v.linear[k][j] + v.center[k] * u.linear[k][j]);
    affine::addProduct<Real>(u.linear[k], v.linear[k], result.second);
  }
  const Real blown_up = Real(1) + Real(32) * rounding::roundoff<Real>();
  const Real size_u = u.magnitude() * blown_up, size_v = v.magnitude() * blown_up;
  Real error = affine::dotError(u, v, size_u, size_v);
  for (std::size_t k = 0; k < 3 && SYMBOLS < Real >> 3; ++k)
    error = error + affine::parameterProducts<Real>(u.linear[k], v.linear[k]);
  const Real along_u = u.along * affine::sumOfMagnitudes(u.axis), along_v = v.along * affine::sumOfMagnitudes(v.axis);
  result.linear.radius = affine::widened(error, (size_u + along_u) * (size_v + along_v), 32);
  return result;
}
template <class Real>
inline QuadraticForm<Real> product(const QuadraticVector<Real>& u, const QuadraticVector<Real>& v)
{
  QuadraticForm<Real> result = product(u.linear, v.linear);
  Real beyond(0), size(0);
  for (std::size_t k = 0; k < 3; ++k)
  {
    const affine::Bend<Real> bend_u(u.second[k]), bend_v(v.second[k]);
    for (std::size_t l = 0; l < 6; ++l)
      result.second[l] = result.second[l] + (u.linear.center[k] * v.second[k][l] + v.linear.center[k] * u.second[k][l]);
    for (std::size_t j = 0; j < u.linear.linear[k].size(); ++j)
      result.linear.gradient[j] =
          result.linear.gradient[j] + (bend_v.middle * u.linear.linear[k][j] + bend_u.middle * v.linear.linear[k][j]);
    beyond = beyond + bend_u.off * v.linear.swing(k) + bend_v.off * u.linear.swing(k);
  }
  const Real bend_u = u.bend(), bend_v = v.bend();
  const Real error_u = u.linear.radius + u.linear.along * affine::sumOfMagnitudes(u.linear.axis);
  const Real error_v = v.linear.radius + v.linear.along * affine::sumOfMagnitudes(v.linear.axis);
  size = (u.linear.magnitude() + bend_u) * (v.linear.magnitude() + bend_v);
  result.linear.radius =
      affine::widened(result.linear.radius + beyond + bend_u * bend_v + error_u * bend_v + error_v * bend_u, size, 64);
  return result;
}
}  // namespace pkm_workspace
