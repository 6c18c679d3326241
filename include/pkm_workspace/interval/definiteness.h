// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <type_traits>

#include "pkm_workspace/interval/affine_form.h"

namespace pkm_workspace
{
/// A symmetric 3x3 matrix of affine forms over delta in [-1, 1]^3; entries 00, 11, 22, 12, 02, 01 in this order.
template <class Real>
using SymmetricForms = std::array<AffineForm<Real>, 6>;

/// A matrix without anything off its diagonal.
template <class Real>
SymmetricForms<Real> diagonal(const std::array<AffineForm<Real>, 3>& entries)
{
  SymmetricForms<Real> matrix;
  for (std::size_t k = 0; k < 3; ++k)
    matrix[k] = entries[k];
  return matrix;
}

/// Encloses s M.
template <class Real>
SymmetricForms<Real> operator*(const Enclosed<Real>& s, SymmetricForms<Real> m)
{
  for (auto& entry : m)
    entry = s * entry;
  return m;
}

namespace affine
{
/// The form for all parameters that it depends on: they become a part of its error.
template <class Real>
inline AffineForm<Real> withoutParameters(AffineForm<Real> form)
{
  form.radius = widened(form.radius + parameterSwing<Real>(form.gradient), form.magnitude(), 0);
  for (std::size_t j = 3; j < form.gradient.size(); ++j)
    form.gradient[j] = Real(0);
  return form;
}
template <class Real, std::enable_if_t<(SYMBOLS<Real> > 3), int> = 0>
inline SymmetricForms<Real> withoutParameters(SymmetricForms<Real> m)
{
  for (AffineForm<Real>& entry : m)
    entry = withoutParameters(entry);
  return m;
}
template <class Real, std::enable_if_t<SYMBOLS<Real> == 3, int> = 0>
inline const SymmetricForms<Real>& withoutParameters(const SymmetricForms<Real>& m)
{
  return m;
}

/// What goes off the diagonal for the errors of the entries (Gershgorin), and for the roundings of what follows.
template <class Real>
inline std::array<Real, 3> diagonalLosses(const SymmetricForms<Real>& m)
{
  const Real trace = m[0].magnitude() + m[1].magnitude() + m[2].magnitude();
  std::array<Real, 6> radius;
  for (std::size_t k = 0; k < 6; ++k)
    radius[k] = widened(m[k].radius, m[k].magnitude(), 8);
  const std::array<Real, 3> row_sum = { radius[0] + (radius[4] + radius[5]), radius[1] + (radius[3] + radius[5]),
                                        radius[2] + (radius[3] + radius[4]) };
  return { widened(row_sum[0], trace, 32), widened(row_sum[1], trace, 32), widened(row_sum[2], trace, 32) };
}

/// Whether all of these matrices have positive pivots.
template <class Real, std::size_t N>
inline auto havePositivePivots(const std::array<std::array<Real, N>, 6>& entries)
{
  auto definite = Real(1) > Real(0);
  for (std::size_t c = 0; c < N; ++c)
  {
    const Real first = entries[0][c];
    const Real inverse = Real(1) / first;
    const Real l10 = entries[5][c] * inverse;
    const Real l20 = entries[4][c] * inverse;
    const Real second = entries[1][c] - l10 * entries[5][c];
    const Real rest = entries[3][c] - l20 * entries[5][c];
    const Real third = entries[2][c] - l20 * entries[4][c] - rest * (rest / second);
    definite = definite & (first > Real(0)) & (second > Real(0)) & (third > Real(0));
  }
  return definite;
}
}  // namespace affine

/// Whether every member of the matrix is proved positive definite on the whole cube.
///
/// A matrix that is affine in delta is positive definite on the cube iff it is at the 8 corners (its quadratic form is
/// affine in delta for every vector). The errors of the entries are met by taking each row's sum of radii off the
/// diagonal (Gershgorin). At a corner the factorisation L D L^T in floating point is the exact one of a matrix that
/// differs by less than a few roundoffs times the trace (Higham 2002, section 10.1; Rump 2006), which is taken off the
/// diagonal too: positive pivots are a proof, without the loss of digits that minors suffer at multiple eigenvalues.
/// @return false (for a Pack: in each lane) when it is not, or cannot be proved
template <class Real>
auto isPositiveDefinite(const SymmetricForms<Real>& matrix)
{
  const SymmetricForms<Real>& m = affine::withoutParameters(matrix);
  const std::array<Real, 3> losses = affine::diagonalLosses(m);
  std::array<std::array<Real, 8>, 6> corner;
  for (std::size_t k = 0; k < 6; ++k)
  {
    const Real center = k < 3 ? m[k].center - losses[k] : m[k].center;
    for (std::size_t x = 0; x < 2; ++x)
      for (std::size_t y = 0; y < 2; ++y)
      {
        const Real along_x = x ? center + m[k].gradient[0] : center - m[k].gradient[0];
        const Real along_xy = y ? along_x + m[k].gradient[1] : along_x - m[k].gradient[1];
        corner[k][4 * x + 2 * y] = along_xy - m[k].gradient[2];
        corner[k][4 * x + 2 * y + 1] = along_xy + m[k].gradient[2];
      }
  }
  return affine::havePositivePivots(corner);
}

/// The same on the convex hull of points delta of the cube.
template <class Real, std::size_t N>
auto isPositiveDefinite(const SymmetricForms<Real>& matrix, const std::array<std::array<Real, 3>, N>& points)
{
  const SymmetricForms<Real>& m = affine::withoutParameters(matrix);
  const std::array<Real, 3> losses = affine::diagonalLosses(m);
  std::array<std::array<Real, N>, 6> corner;
  for (std::size_t k = 0; k < 6; ++k)
    for (std::size_t c = 0; c < N; ++c)
      corner[k][c] =
          (k < 3 ? m[k].center - losses[k] : m[k].center) +
          (m[k].gradient[0] * points[c][0] + m[k].gradient[1] * points[c][1] + m[k].gradient[2] * points[c][2]);
  return affine::havePositivePivots(corner);
}

/// Whether the matrix at delta = 0 has positive leading minors: floating point, no proof.
template <class Real>
auto isDefiniteAtCenter(const SymmetricForms<Real>& m)
{
  const Real first = m[0].center;
  const Real second = first * m[1].center - m[5].center * m[5].center;
  const Real mixed = first * m[3].center - m[5].center * m[4].center;
  const Real third = (first * m[2].center - m[4].center * m[4].center) * second - mixed * mixed;
  return (first > Real(0)) & (second > Real(0)) & (third > Real(0));
}

namespace affine
{
/// Encloses the sum of weight_k m_k. @param size a bound on each weight and on the terms that it was rounded from
template <class Real>
inline AffineForm<Real> weightedSum(const SymmetricForms<Real>& m, const std::array<Real, 6>& weight,
                                    const std::array<Real, 6>& size)
{
  AffineForm<Real> sum;
  Real magnitude = Real(0);
  for (std::size_t k = 0; k < 6; ++k)
  {
    sum.center = sum.center + weight[k] * m[k].center;
    for (std::size_t j = 0; j < sum.gradient.size(); ++j)
      sum.gradient[j] = sum.gradient[j] + weight[k] * m[k].gradient[j];
    sum.radius = sum.radius + size[k] * m[k].radius;
    magnitude = magnitude + size[k] * m[k].magnitude();
  }
  sum.radius = widened(sum.radius, magnitude, 16);
  return sum;
}
}  // namespace affine

/// Encloses v^T M v for a constant vector v.
template <class Real>
AffineForm<Real> quadraticForm(const SymmetricForms<Real>& m, const std::array<Real, 3>& v)
{
  using std::abs;
  const Real two(2);
  const std::array<Real, 6> weight = { v[0] * v[0],       v[1] * v[1],       v[2] * v[2],
                                       two * v[1] * v[2], two * v[0] * v[2], two * v[0] * v[1] };
  std::array<Real, 6> size;
  for (std::size_t k = 0; k < 6; ++k)
    size[k] = abs(weight[k]);
  return affine::weightedSum(m, weight, size);
}

/// Encloses u^T M v for constant vectors u, v.
template <class Real>
AffineForm<Real> bilinearForm(const SymmetricForms<Real>& m, const std::array<Real, 3>& u, const std::array<Real, 3>& v)
{
  using std::abs;
  std::array<Real, 6> weight;
  std::array<Real, 6> size;
  for (std::size_t k = 0; k < 3; ++k)
  {
    const std::size_t i = (k + 1) % 3;
    const std::size_t j = (k + 2) % 3;
    weight[k] = u[k] * v[k];
    size[k] = abs(weight[k]);
    weight[3 + k] = u[i] * v[j] + u[j] * v[i];
    size[3 + k] = abs(u[i] * v[j]) + abs(u[j] * v[i]);
  }
  return affine::weightedSum(m, weight, size);
}

/// Encloses W^T M W for the constant matrix with columns w_k.
template <class Real>
SymmetricForms<Real> congruent(const SymmetricForms<Real>& m, const std::array<std::array<Real, 3>, 3>& w)
{
  SymmetricForms<Real> result;
  for (std::size_t k = 0; k < 3; ++k)
  {
    result[k] = quadraticForm(m, w[k]);
    result[3 + k] = bilinearForm(m, w[(k + 1) % 3], w[(k + 2) % 3]);
  }
  return result;
}
}  // namespace pkm_workspace
