// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <type_traits>

#include "pkm_workspace/interval/affine_form.h"
#include "pkm_workspace/interval/interval_vector.h"

namespace pkm_workspace
{
/// Encloses x^2 as closely as the type allows.
template <class Real>
inline Enclosed<Real> squared(const Interval& x)
{
  if constexpr (std::is_same<typename rounding::ScalarOf<Real>::Type, double>::value)
    return Enclosed<Real>(sqr(x));
  else
    return Enclosed<Real>(x) * Enclosed<Real>(x);
}

/// Encloses x / y for y > 0 as closely as the type allows.
template <class Real>
inline Enclosed<Real> quotient(double x, double y)
{
  using std::abs;
  if constexpr (std::is_same<typename rounding::ScalarOf<Real>::Type, double>::value)
    return Enclosed<Real>(Interval(x) / Interval(y));
  else
  {
    const Real value = Real(x) / Real(y);
    return { value, affine::widened(Real(0), abs(value), 4) };
  }
}

/// Encloses |v|. Squares that underflow are worth less than 1e-139 of it.
template <class Real>
inline Enclosed<Real> enclosedNorm(const std::array<Real, 3>& v)
{
  using std::sqrt;
  const Real norm = sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
  return { norm, affine::widened(Real(1e-139), norm, 8) };
}

/// A constant vector or matrix in doubles with one bound on the error of every entry.
template <class Real>
struct EnclosedVector
{
  std::array<Real, 3> value;
  Real radius = Real(0);

  EnclosedVector() = default;
  template <class Other>
  explicit EnclosedVector(const EnclosedVector<Other>& v)
    : value{ Real(v.value[0]), Real(v.value[1]), Real(v.value[2]) }, radius(v.radius)
  {}
  explicit EnclosedVector(const IntervalVector& v)
  {
    for (std::size_t k = 0; k < 3; ++k)
    {
      value[k] = Real(v[k].mid());
      radius = std::max(radius, Real(v[k].radius()));
    }
  }
};

template <class Real>
struct EnclosedMatrix
{
  std::array<std::array<Real, 3>, 3> value;
  Real radius = Real(0);
  Real magnitude = Real(0);  ///< a bound on every entry

  EnclosedMatrix() = default;
  template <class Other>
  explicit EnclosedMatrix(const EnclosedMatrix<Other>& m) : radius(m.radius), magnitude(m.magnitude)
  {
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t k = 0; k < 3; ++k)
        value[i][k] = Real(m.value[i][k]);
  }
  explicit EnclosedMatrix(const IntervalMatrix& m)
  {
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t k = 0; k < 3; ++k)
      {
        value[i][k] = Real(m[i][k].mid());
        radius = std::max(radius, Real(m[i][k].radius()));
        magnitude = std::max(magnitude, Real(m[i][k].magnitude()));
      }
  }
};
}  // namespace pkm_workspace
