// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

#include "pkm_workspace/interval/affine_form.h"

namespace pkm_workspace
{
/// A symmetric 3x3 matrix of affine forms over delta in [-1, 1]^3; entries 00, 11, 22, 12, 02, 01 in this order.
template <class Real>
using SymmetricForms = std::array<AffineForm<Real>, 6>;

/// Whether every member of the matrix is proved positive definite on the whole cube.
///
/// A matrix that is affine in delta is positive definite on the cube iff it is at the 8 corners (its quadratic form is affine in
/// delta for every vector). The errors of the entries are met by taking each row's sum of radii off the diagonal (Gershgorin),
/// the roundings of the leading minors (Sylvester) by a bound relative to their products.
/// @return false when it is not, or cannot be proved
template <class Real>
bool isPositiveDefinite(const SymmetricForms<Real>& m)
{
  using std::abs;
  const Real unit = rounding::roundoff<Real>();
  std::array<Real, 6> radius;
  for (std::size_t k = 0; k < 6; ++k)
    radius[k] = affine::widened(m[k].radius, m[k].magnitude(), 8);
  const std::array<Real, 3> row_sum = { radius[0] + (radius[4] + radius[5]), radius[1] + (radius[3] + radius[5]),
                                        radius[2] + (radius[3] + radius[4]) };
  std::array<std::array<Real, 8>, 6> corner;
  for (std::size_t k = 0; k < 6; ++k)
  {
    const Real center = k < 3 ? m[k].center - row_sum[k] * (Real(1) + Real(8) * unit) : m[k].center;
    for (std::size_t c = 0; c < 8; ++c)
      corner[k][c] = center + ((c & 1) ? m[k].gradient[0] : -m[k].gradient[0]) +
                     ((c & 2) ? m[k].gradient[1] : -m[k].gradient[1]) + ((c & 4) ? m[k].gradient[2] : -m[k].gradient[2]);
  }
  bool definite = true;
  for (std::size_t c = 0; c < 8; ++c)
  {
    const Real a = corner[0][c], b = corner[1][c], d = corner[2][c];
    const Real f = corner[3][c], e = corner[4][c], g = corner[5][c];  // 12, 02, 01
    const Real ab = a * b, gg = g * g;
    const Real minor = ab - gg;
    const Real positive = ab * d + Real(2) * f * e * g;
    const Real negative = a * f * f + b * e * e + d * gg;
    const Real sizes = abs(ab * d) + Real(2) * abs(f * e * g) + abs(a) * f * f + abs(b) * e * e + abs(d) * gg;
    definite = definite & (a > Real(0)) & (minor > Real(8) * unit * (abs(ab) + gg) + rounding::underflow<Real>()) &
               (positive - negative > Real(32) * unit * sizes + rounding::underflow<Real>());
  }
  return definite;
}

/// Encloses v^T M v for a constant vector v.
template <class Real>
AffineForm<Real> quadraticForm(const SymmetricForms<Real>& m, const std::array<Real, 3>& v)
{
  using std::abs;
  const Real two(2);
  const std::array<Real, 6> weight = { v[0] * v[0],       v[1] * v[1],       v[2] * v[2],
                                       two * v[1] * v[2], two * v[0] * v[2], two * v[0] * v[1] };
  AffineForm<Real> sum;
  Real magnitude = Real(0);
  for (std::size_t k = 0; k < 6; ++k)
  {
    sum.center = sum.center + weight[k] * m[k].center;
    for (std::size_t j = 0; j < 3; ++j)
      sum.gradient[j] = sum.gradient[j] + weight[k] * m[k].gradient[j];
    sum.radius = sum.radius + abs(weight[k]) * m[k].radius;
    magnitude = magnitude + abs(weight[k]) * m[k].magnitude();
  }
  sum.radius = affine::widened(sum.radius, magnitude, 16);
  return sum;
}
}  // namespace pkm_workspace
