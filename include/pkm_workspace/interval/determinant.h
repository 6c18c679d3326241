// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "pkm_workspace/interval/affine_vector.h"

namespace pkm_workspace
{
namespace affine
{
/// The determinant of the matrix of which row(i)[k] is an entry.
template <class Entry>
inline Entry determinant(const std::array<Entry, 3>& u, const std::array<Entry, 3>& v, const std::array<Entry, 3>& w)
{
  const auto minor = [&](std::size_t i, std::size_t j) { return v[i] * w[j] + -(v[j] * w[i]); };
  return u[0] * minor(1, 2) + u[1] * minor(2, 0) + u[2] * minor(0, 1);
}
}  // namespace affine

/// Encloses det [u; v; w].
template <class Real>
inline AffineForm<Real> determinant(const AffineVector<Real>& u, const AffineVector<Real>& v,
                                    const AffineVector<Real>& w)
{
  const auto row = [](const AffineVector<Real>& r) {
    return std::array<AffineForm<Real>, 3>{ component(r, 0), component(r, 1), component(r, 2) };
  };
  return affine::determinant(row(u), row(v), row(w));
}

/// Encloses det [u; v; w] at delta = 0.
template <class Real>
[[gnu::flatten]] inline Enclosed<Real> determinantAtCenter(const AffineVector<Real>& u, const AffineVector<Real>& v,
                                                           const AffineVector<Real>& w)
{
  const auto row = [](const AffineVector<Real>& r) {
    return std::array<Enclosed<Real>, 3>{ componentAtCenter(r, 0), componentAtCenter(r, 1), componentAtCenter(r, 2) };
  };
  return affine::determinant(row(u), row(v), row(w));
}
}  // namespace pkm_workspace
