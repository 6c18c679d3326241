// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

#include "support/exact.h"

namespace pkm_workspace
{
namespace test
{
using ExactVector = std::array<Exact, 3>;

inline ExactVector operator+(const ExactVector& a, const ExactVector& b)
{
  return { a[0] + b[0], a[1] + b[1], a[2] + b[2] };
}

inline ExactVector operator-(const ExactVector& a, const ExactVector& b)
{
  return { a[0] - b[0], a[1] - b[1], a[2] - b[2] };
}

inline ExactVector operator*(const Exact& s, const ExactVector& v)
{
  return { s * v[0], s * v[1], s * v[2] };
}

inline Exact dot(const ExactVector& a, const ExactVector& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// The determinant of the matrix with rows a, b, c.
inline Exact determinant(const ExactVector& a, const ExactVector& b, const ExactVector& c)
{
  const auto minor = [&](std::size_t i, std::size_t j) { return b[i] * c[j] - b[j] * c[i]; };
  return a[0] * minor(1, 2) + a[1] * minor(2, 0) + a[2] * minor(0, 1);
}
}  // namespace test
}  // namespace pkm_workspace
