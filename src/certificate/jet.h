// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

#include "pkm_workspace/interval/ball.h"

namespace pkm_workspace
{
namespace checking
{
using Vector = std::array<Ball, 3>;

/// A function f of delta in [-1, 1]^3: f(0), and slopes for which f(delta) = f(0) + slope . delta all over the cube.
/// Slopes of products and roots are those of their chords from delta = 0 (Krawczyk and Neumaier, 1985).
struct Jet
{
  Ball value;
  Vector slope = {};

  Jet() = default;
  Jet(const Ball& x) : value(x) {}  // NOLINT: numbers are functions
  Jet(const Ball& v, const Vector& s) : value(v), slope(s) {}

  /// Its values all over the cube.
  Ball range() const { return value.widenedBy(slope[0].most() + slope[1].most() + slope[2].most()); }
};

using JetVector = std::array<Jet, 3>;

inline Jet operator+(const Jet& f, const Jet& g)
{
  return { f.value + g.value, { f.slope[0] + g.slope[0], f.slope[1] + g.slope[1], f.slope[2] + g.slope[2] } };
}
inline Jet operator-(const Jet& f)
{
  return { -f.value, { -f.slope[0], -f.slope[1], -f.slope[2] } };
}
inline Jet operator-(const Jet& f, const Jet& g)
{
  return f + -g;
}
inline Jet operator*(const Ball& s, const Jet& f)
{
  return { s * f.value, { s * f.slope[0], s * f.slope[1], s * f.slope[2] } };
}
inline Jet operator*(const Jet& f, const Jet& g)
{
  const Ball all = f.range();
  const auto slope = [&](std::size_t j) { return all * g.slope[j] + g.value * f.slope[j]; };
  return { f.value * g.value, { slope(0), slope(1), slope(2) } };
}

/// @pre g has no zero. By f / g - f(0) / g(0) = (f - f(0) - f(0) / g(0) (g - g(0))) / g.
inline Jet operator/(const Jet& f, const Jet& g)
{
  const Ball quotient = f.value / g.value;
  const Ball all = g.range();
  const auto slope = [&](std::size_t j) { return (f.slope[j] - quotient * g.slope[j]) / all; };
  return { quotient, { slope(0), slope(1), slope(2) } };
}

/// sqrt(x) where x >= least; below, its tangent there goes on. Where there is none, the whole range of the root.
inline Jet rootAbove(const Jet& x, const Ball::Middle& least)
{
  using std::max;
  const Ball range = x.range();
  const Ball::Middle high = max(range.upper(), Ball::Middle(0));
  if (!(max(range.lower(), least) > 0))
    return sqrt(Ball::between(0, high));
  const auto per_root = [&](const Ball::Middle& y) { return Ball(0.5) / sqrt(Ball(max(y, least), 0.0)); };
  const auto at = [&](const Ball::Middle& y) {
    return y >= least ? sqrt(Ball(y, 0.0)) : sqrt(Ball(least, 0.0)) + (Ball(y, 0.0) - Ball(least, 0.0)) * per_root(y);
  };
  Jet root;
  root.value = Ball::between(at(x.value.lower()).lower(), at(x.value.upper()).upper());
  const Ball chord = range.lower() >= least && x.value.lower() >= least
                         ? Ball(1.0) / (sqrt(range) + root.value)
                         : Ball::between(per_root(range.upper()).lower(), per_root(range.lower()).upper());
  for (std::size_t j = 0; j < 3; ++j)
    root.slope[j] = chord * x.slope[j];
  return root;
}

template <class T, class U>
auto scalarProduct(const std::array<T, 3>& a, const std::array<U, 3>& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
template <class T>
std::array<T, 3> vectorProduct(const std::array<T, 3>& a, const std::array<T, 3>& b)
{
  return { a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0] };
}
}  // namespace checking
}  // namespace pkm_workspace
