// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>

#include "pkm_workspace/interval/interval.h"

namespace pkm_workspace
{
/// Three intervals: an enclosure of a vector. Not an Eigen scalar type: pivoting and norms there would not be sound.
using IntervalVector = std::array<Interval, 3>;
/// Rows of an enclosure of a 3x3 matrix.
using IntervalMatrix = std::array<IntervalVector, 3>;

inline IntervalVector enclose(const Eigen::Vector3d& v)
{
  return { v.x(), v.y(), v.z() };
}

inline Eigen::Vector3d mid(const IntervalVector& v)
{
  return { v[0].mid(), v[1].mid(), v[2].mid() };
}

inline IntervalVector operator+(const IntervalVector& a, const IntervalVector& b)
{
  return { a[0] + b[0], a[1] + b[1], a[2] + b[2] };
}

inline IntervalVector operator-(const IntervalVector& a, const IntervalVector& b)
{
  return { a[0] - b[0], a[1] - b[1], a[2] - b[2] };
}

inline IntervalVector operator*(const Interval& s, const IntervalVector& v)
{
  return { s * v[0], s * v[1], s * v[2] };
}

inline Interval dot(const IntervalVector& a, const IntervalVector& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

inline IntervalVector cross(const IntervalVector& a, const IntervalVector& b)
{
  return { a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0] };
}

/// Encloses |v|^2.
inline Interval squaredNorm(const IntervalVector& v)
{
  return sqr(v[0]) + sqr(v[1]) + sqr(v[2]);
}

inline Interval norm(const IntervalVector& v)
{
  return sqrt(squaredNorm(v));
}

inline IntervalVector operator*(const IntervalMatrix& m, const IntervalVector& v)
{
  return { dot(m[0], v), dot(m[1], v), dot(m[2], v) };
}

inline IntervalMatrix operator*(const IntervalMatrix& m, const IntervalMatrix& n)
{
  IntervalMatrix product;
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 3; ++column)
      product[row][column] = dot(m[row], IntervalVector{ n[0][column], n[1][column], n[2][column] });
  return product;
}

inline IntervalMatrix transpose(const IntervalMatrix& m)
{
  return { IntervalVector{ m[0][0], m[1][0], m[2][0] }, IntervalVector{ m[0][1], m[1][1], m[2][1] },
           IntervalVector{ m[0][2], m[1][2], m[2][2] } };
}

/// Encloses the determinant of the matrix with rows a, b, c.
inline Interval determinant(const IntervalVector& a, const IntervalVector& b, const IntervalVector& c)
{
  return dot(a, cross(b, c));
}

/// Encloses M (p - c).
inline void mapOffset(const IntervalMatrix& m, const IntervalVector& c, const IntervalVector& p, IntervalVector& image)
{
  image = m * (p - c);
}

/// Encloses a . (p - c).
inline Interval dotOffset(const IntervalVector& a, const IntervalVector& c, const IntervalVector& p)
{
  return dot(a, p - c);
}

/// Adds f a.
inline void addAlong(IntervalVector& v, const Interval& f, const IntervalVector& a)
{
  v = v + f * a;
}

inline bool intersects(const IntervalVector& a, const IntervalVector& b)
{
  return a[0].intersects(b[0]) && a[1].intersects(b[1]) && a[2].intersects(b[2]);
}
}  // namespace pkm_workspace
