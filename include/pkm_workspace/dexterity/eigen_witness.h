// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

#include "pkm_workspace/interval/definiteness.h"
#include "pkm_workspace/interval/pack.h"
#include "pkm_workspace/interval/plain_vector.h"

namespace pkm_workspace
{
/// An eigenpair in floating point: a vector v for which v^T M v is likely to be small. A proof never rests on it,
/// only on the enclosure of v^T M v, which holds for any v.
template <class Real>
struct Eigenpair
{
  Real value;
  std::array<Real, 3> vector;  ///< of length 1
};

namespace eigen
{
template <class Real>
using Vector = PlainVector<Real>;
/// Entries 00, 11, 22, 12, 02, 01, as in SymmetricForms.
template <class Real>
using Symmetric = std::array<Real, 6>;

/// u^T M v.
template <class Real>
inline Real product(const Vector<Real>& u, const Symmetric<Real>& m, const Vector<Real>& v)
{
  const Vector<Real> image = { m[0] * v[0] + m[5] * v[1] + m[4] * v[2], m[5] * v[0] + m[1] * v[1] + m[3] * v[2],
                               m[4] * v[0] + m[3] * v[1] + m[2] * v[2] };
  return dot(u, image);
}

/// The longer one.
template <class Real>
inline Vector<Real> longer(const Vector<Real>& a, const Vector<Real>& b)
{
  const auto first = dot(a, a) > dot(b, b);
  return { select(first, a[0], b[0]), select(first, a[1], b[1]), select(first, a[2], b[2]) };
}

/// The least eigenvalue, to about six digits of the spectrum's width: with q the mean and p the spread of the
/// eigenvalues it is q - 2 p cos(acos(-r) / 3), r = det((M - q I) / p) / 2 (Smith 1961). In s = sqrt((1 - r) / 2) the
/// cosine is smooth: a polynomial, fitted to 4e-7.
template <class Real>
inline Real leastEigenvalue(const Symmetric<Real>& m)
{
  using std::max;
  using std::min;
  using std::sqrt;
  const Real mean = (m[0] + m[1] + m[2]) * Real(1.0 / 3.0);
  const Real a = m[0] - mean, b = m[1] - mean, c = m[2] - mean;
  const Real off_diagonal = m[3] * m[3] + m[4] * m[4] + m[5] * m[5];
  const Real spread = sqrt((a * a + b * b + c * c + off_diagonal + off_diagonal) * Real(1.0 / 6.0));
  const Real det = a * (b * c - m[3] * m[3]) - m[5] * (m[5] * c - m[3] * m[4]) + m[4] * (m[5] * m[3] - b * m[4]);
  const Real twice_cubed = Real(2) * spread * spread * spread + Real(1e-300);
  const Real r = max(Real(-1), min(Real(1), det / twice_cubed));
  const Real s = sqrt((Real(1) - r) * Real(0.5));
  Real t(0.0042869370467);
  for (const double coefficient :
       { -0.021246294614, 0.053076758984, -0.103096061450, 0.221646164615, -1.154666932332, -1.000000325904 })
    t = t * s + Real(coefficient);
  return mean + spread * t;
}

/// How often an eigenvector of that type is made more exact: double has enough from the start.
template <class Real>
constexpr int polishings()
{
  return std::is_same<typename rounding::ScalarOf<Real>::Type, double>::value ? 0 : 3;
}

/// A vector across the given one.
template <class Real>
inline Vector<Real> across(const Vector<Real>& v)
{
  const auto first = v[0] * v[0] > v[2] * v[2];
  return { select(first, -v[1], Real(0)), select(first, v[0], -v[2]), select(first, Real(0), v[1]) };
}

/// A unit vector across the rows of M - value I, or, where these are one (a double eigenvalue), any across that.
template <class Real>
inline Vector<Real> eigenvectorNear(const Symmetric<Real>& m, const Real& value)
{
  using std::sqrt;
  const Vector<Real> x = { m[0] - value, m[5], m[4] };
  const Vector<Real> y = { m[5], m[1] - value, m[3] };
  const Vector<Real> z = { m[4], m[3], m[2] - value };
  const Vector<Real> normal = longer(cross(x, y), longer(cross(y, z), cross(z, x)));
  const Vector<Real> row = longer(x, longer(y, z));
  const Vector<Real> any_across = across(row);
  const Real row_squared = dot(row, row);
  const auto is_simple = dot(normal, normal) > Real(1e-20) * row_squared * row_squared;
  const auto is_zero = dot(any_across, any_across) > Real(0);
  Vector<Real> v;
  for (std::size_t k = 0; k < 3; ++k)
    v[k] = select(is_simple, normal[k], select(is_zero, any_across[k], Real(k == 0 ? 1 : 0)));
  const Real scale = Real(1) / sqrt(dot(v, v));
  for (auto& component : v)
    component = component * scale;
  return v;
}

/// The pair of the least eigenvalue, in closed form; the value is the vector's Rayleigh quotient.
template <class Real>
inline Eigenpair<Real> leastEigenpair(const Symmetric<Real>& m)
{
  Vector<Real> v = eigenvectorNear(m, leastEigenvalue(m));
  for (int step = 0; step < polishings<Real>(); ++step)
    v = eigenvectorNear(m, product(v, m, v));
  return { product(v, m, v), v };
}

/// An eigenvalue and its eigenvector for each k, nearly: ascending, orthonormal also where eigenvalues coincide.
template <class Real>
struct Basis
{
  std::array<Real, 3> value;
  std::array<Vector<Real>, 3> vector;
};

/// Swaps two pairs where the first one's value is the larger.
template <class Real>
inline void order(Basis<Real>& basis, std::size_t i, std::size_t j)
{
  const auto wrong = basis.value[j] < basis.value[i];
  const auto swap = [&wrong](Real& a, Real& b) {
    const Real before = a;
    a = select(wrong, b, a);
    b = select(wrong, before, b);
  };
  swap(basis.value[i], basis.value[j]);
  for (std::size_t k = 0; k < 3; ++k)
    swap(basis.vector[i][k], basis.vector[j][k]);
}

template <class Real>
inline Vector<Real> combined(const Real& s, const Vector<Real>& a, const Real& t, const Vector<Real>& b)
{
  return { s * a[0] + t * b[0], s * a[1] + t * b[1], s * a[2] + t * b[2] };
}

/// Turns two vectors in their plane until M has no entry for both (Jacobi), by at most 45 degrees.
template <class Real>
inline void diagonalise(const Symmetric<Real>& m, Vector<Real>& u, Vector<Real>& v)
{
  using std::abs;
  using std::sqrt;
  const Real gap = product(v, m, v) - product(u, m, u);
  const Real off = Real(2) * product(u, m, v);
  const Real size = abs(gap) + sqrt(gap * gap + off * off) + Real(1e-300);
  const Real tangent = select(gap < Real(0), -off, off) / size;
  const Real cosine = Real(1) / sqrt(Real(1) + tangent * tangent);
  const Real sine = cosine * tangent;
  const Vector<Real> before = u;
  u = combined(cosine, before, -sine, v);
  v = combined(sine, before, cosine, v);
}

/// All eigenpairs, to about 1e-13 of the largest one: the vector of the least one and any two across it, turned.
template <class Real>
inline Basis<Real> basisOf(const Symmetric<Real>& m)
{
  using std::sqrt;
  Basis<Real> basis;
  auto& [first, second, third] = basis.vector;
  first = leastEigenpair(m).vector;
  second = across(first);
  const Real scale = Real(1) / sqrt(dot(second, second));
  for (auto& component : second)
    component = component * scale;
  third = cross(first, second);
  diagonalise(m, second, third);
  diagonalise(m, first, third);
  diagonalise(m, first, second);
  diagonalise(m, second, third);
  for (std::size_t k = 0; k < 3; ++k)
    basis.value[k] = product(basis.vector[k], m, basis.vector[k]);
  order(basis, 0, 1);
  order(basis, 1, 2);
  order(basis, 0, 1);
  return basis;
}
}  // namespace eigen

/// The pair of the least eigenvalue of M at one delta.
template <class Real>
inline Eigenpair<Real> leastEigenvector(const SymmetricForms<Real>& m, const std::array<Real, 3>& delta)
{
  eigen::Symmetric<Real> matrix;
  for (std::size_t k = 0; k < 6; ++k)
    matrix[k] = m[k].center + (m[k].gradient[0] * delta[0] + m[k].gradient[1] * delta[1] + m[k].gradient[2] * delta[2]);
  return eigen::leastEigenpair(matrix);
}

/// Whether M - level I is positive definite at one delta, in floating point: far cheaper than the eigenvalue.
inline bool isAbove(const SymmetricForms<double>& m, const std::array<double, 3>& delta, double level)
{
  const auto at = [&](std::size_t k) {
    return m[k].center + (m[k].gradient[0] * delta[0] + m[k].gradient[1] * delta[1] + m[k].gradient[2] * delta[2]);
  };
  const double first = at(0) - level;
  const double off01 = at(5), off02 = at(4);
  const double second = (at(1) - level) * first - off01 * off01;
  const double mixed = at(3) * first - off01 * off02;
  const double third = ((at(2) - level) * first - off02 * off02) * second - mixed * mixed;
  return first > 0.0 && second > 0.0 && third > 0.0;
}

template <class Real>
inline Eigenpair<Real> leastEigenvector(const SymmetricForms<Real>& m)
{
  return eigen::leastEigenpair(
      eigen::Symmetric<Real>{ m[0].center, m[1].center, m[2].center, m[3].center, m[4].center, m[5].center });
}
}  // namespace pkm_workspace
