// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>

namespace pkm_workspace
{
/// Vectors of plain numbers, roundings left out: for finding points, not for proving anything. Real is a floating-point
/// type, or a pack of them.
template <class Real>
using PlainVector = std::array<Real, 3>;
template <class Real>
using PlainMatrix = std::array<std::array<Real, 3>, 3>;  ///< rows

template <class Real>
inline Real dot(const PlainVector<Real>& u, const PlainVector<Real>& v)
{
  return u[0] * v[0] + u[1] * v[1] + u[2] * v[2];
}

template <class Real>
inline PlainVector<Real> cross(const PlainVector<Real>& u, const PlainVector<Real>& v)
{
  return { u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0] };
}

template <class Real>
inline Real squaredNorm(const PlainVector<Real>& v)
{
  return dot(v, v);
}

/// M (p - c).
template <class Real>
inline void mapOffset(const PlainMatrix<Real>& m, const PlainVector<Real>& c, const PlainVector<Real>& p,
                      PlainVector<Real>& image)
{
  const PlainVector<Real> x = { p[0] - c[0], p[1] - c[1], p[2] - c[2] };
  for (std::size_t k = 0; k < 3; ++k)
    image[k] = dot(m[k], x);
}

/// a . (p - c).
template <class Real>
inline Real dotOffset(const PlainVector<Real>& a, const PlainVector<Real>& c, const PlainVector<Real>& p)
{
  return dot(a, PlainVector<Real>{ p[0] - c[0], p[1] - c[1], p[2] - c[2] });
}

/// Adds f a.
template <class Real>
inline void addAlong(PlainVector<Real>& v, const Real& f, const PlainVector<Real>& a)
{
  for (std::size_t k = 0; k < 3; ++k)
    v[k] = v[k] + f * a[k];
}
}  // namespace pkm_workspace
