// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>

#include "pkm_workspace/interval/definiteness.h"
#include "pkm_workspace/interval/pack.h"

namespace pkm_workspace
{
/// Two numbers that what is meant lies between.
template <class Real>
struct Span
{
  Real lower;
  Real upper;
};

namespace pencil
{
/// Largest rounding error of what is computed here from numbers of that magnitude, some dozens of operations.
template <class Real>
inline Real noise(const Real& magnitude)
{
  return Real(64) * rounding::roundoff<Real>() * magnitude + rounding::underflow<Real>();
}

/// The rows' sums of what lies off the diagonal.
template <class Real>
inline std::array<Real, 3> rowSums(const Real& off12, const Real& off02, const Real& off01)
{
  return { off02 + off01, off12 + off01, off12 + off02 };
}

template <class Real>
inline Real sumOfMagnitudes(const SymmetricForms<Real>& m)
{
  Real sum = m[0].magnitude();
  for (std::size_t k = 1; k < 6; ++k)
    sum = sum + m[k].magnitude();
  return sum;
}

/// A lower bound of all eigenvalues of all members (Gershgorin).
template <class Real>
inline Real belowByRows(const SymmetricForms<Real>& m)
{
  using std::min;
  const auto off = rowSums(m[3].magnitude(), m[4].magnitude(), m[5].magnitude());
  Real least = m[0].lower() - off[0];
  for (std::size_t k = 1; k < 3; ++k)
    least = min(least, m[k].lower() - off[k]);
  return least - noise(sumOfMagnitudes(m));
}

template <class Real>
inline Real atCorner(const AffineForm<Real>& f, std::size_t corner)
{
  Real value = f.center;
  for (std::size_t j = 0; j < 3; ++j)
    value = (corner >> j) & 1U ? value + f.gradient[j] : value - f.gradient[j];
  return value;
}

/// Near the least eigenvalue of a symmetric matrix, seldom above it: two steps of Laguerre's method from Gershgorin's
/// bound. The characteristic polynomial has real roots only, and from the left of all of them the steps stay there.
template <class Real>
inline Real leastEigenvalueNearly(const std::array<Real, 6>& m)
{
  using std::abs;
  using std::max;
  using std::min;
  using std::sqrt;
  const auto off = rowSums(abs(m[3]), abs(m[4]), abs(m[5]));
  Real x = min(m[0] - off[0], min(m[1] - off[1], m[2] - off[2]));
  for (int step = 0; step < 2; ++step)
  {
    const Real a = m[0] - x, b = m[1] - x, c = m[2] - x;
    const Real minor = b * c - m[3] * m[3];
    const Real minors = minor + (a * c - m[4] * m[4]) + (a * b - m[5] * m[5]);
    const Real det = a * minor - m[5] * (m[5] * c - m[3] * m[4]) + m[4] * (m[5] * m[3] - b * m[4]);
    const Real root = sqrt(max(minors * minors - Real(3) * (a + b + c) * det, Real(0)));
    x = x + max(Real(3) * det / (minors + Real(2) * root + Real(1e-300)), Real(0));
  }
  return x;
}

/// A lower bound of all eigenvalues of all members: for affine members the least eigenvalue is least at a corner of the
/// cube. A value near it is guessed and proved.
template <class Real>
inline Real below(const SymmetricForms<Real>& m)
{
  using std::max;
  using std::min;
  const auto errors = rowSums(m[3].radius, m[4].radius, m[5].radius);
  const Real error = max(m[0].radius + errors[0], max(m[1].radius + errors[1], m[2].radius + errors[2]));
  Real guess(0);
  for (std::size_t corner = 0; corner < 8; ++corner)
  {
    std::array<Real, 6> at;
    for (std::size_t k = 0; k < 6; ++k)
      at[k] = atCorner(m[k], corner);
    const Real least = leastEigenvalueNearly(at);
    guess = corner == 0 ? least : min(guess, least);
  }
  guess = guess - error - Real(8) * noise(sumOfMagnitudes(m));
  SymmetricForms<Real> shifted = m;
  for (std::size_t k = 0; k < 3; ++k)
    shifted[k] = shifted[k] + Enclosed<Real>(-guess, Real(0));
  const Real plain = belowByRows(m);
  return select(isPositiveDefinite(shifted), max(guess, plain), plain);
}

/// The same for the matrix of rows and columns i and j, with m_k off its diagonal, in closed form.
template <class Real>
inline Real below(const SymmetricForms<Real>& m, std::size_t i, std::size_t j, std::size_t k)
{
  using std::max;
  using std::min;
  using std::sqrt;
  const Real half(0.5);
  Real least(0);
  for (std::size_t corner = 0; corner < 8; ++corner)
  {
    const Real a = atCorner(m[i], corner), b = atCorner(m[j], corner), c = atCorner(m[k], corner);
    const Real gap = half * (a - b);
    const Real value = half * (a + b) - sqrt(gap * gap + c * c);
    least = corner == 0 ? value : min(least, value);
  }
  const Real magnitude = m[i].magnitude() + m[j].magnitude() + m[k].magnitude();
  return least - (max(m[i].radius, m[j].radius) + m[k].radius) - noise(magnitude);
}

template <class Real>
inline SymmetricForms<Real> negated(SymmetricForms<Real> m)
{
  for (auto& entry : m)
    entry = -entry;
  return m;
}
}  // namespace pencil

/// Bounds of the eigenvalues sigma_1 <= sigma_2 <= sigma_3 of the pencil K - sigma D over the cube, D positive
/// definite.
///
/// Courant and Fischer: sigma_k >= mu where K - mu D is positive semidefinite on some space of dimension 4 - k, and
/// sigma_k <= mu where it is negative semidefinite on one of dimension k. With W^T D W near I, and W^T K W near a
/// diagonal matrix with the entries mu_k, the spaces of the last and first columns of W make the bounds good to second
/// order in the gradients; sound they are for any W and mu.
/// @return where D is not proved definite, and for a mu that is no number, all numbers
template <class Real>
std::array<Span<Real>, 3> pencilEigenvalues(const SymmetricForms<Real>& k, const SymmetricForms<Real>& d,
                                            const std::array<std::array<Real, 3>, 3>& w, const std::array<Real, 3>& mu)
{
  using std::abs;
  const SymmetricForms<Real> kw = congruent(affine::withoutParameters(k), w);
  const SymmetricForms<Real> dw = congruent(affine::withoutParameters(d), w);
  const Real least = pencil::belowByRows(dw);
  const Real largest = -pencil::belowByRows(pencil::negated(dw));
  const auto definite = least > Real(0);
  const Real infinite(std::numeric_limits<double>::infinity());
  // W^T (K - mu D) W >= bound I >= step W^T D W
  const auto step = [&](const Real& bound) {
    const Real quotient = bound / select(bound > Real(0), largest, least);
    return quotient - pencil::noise(abs(quotient));
  };
  std::array<Span<Real>, 3> result;
  for (std::size_t n = 0; n < 3; ++n)
  {
    SymmetricForms<Real> m;
    for (std::size_t entry = 0; entry < 6; ++entry)
      m[entry] = kw[entry] + Enclosed<Real>(-mu[n], Real(0)) * dw[entry];
    const SymmetricForms<Real> minus = pencil::negated(m);
    const Real up = step(n == 0 ? pencil::below(m) : n == 1 ? pencil::below(m, 1, 2, 3) : m[2].lower());
    const Real down = step(n == 2 ? pencil::below(minus) : n == 1 ? pencil::below(minus, 0, 1, 5) : minus[0].lower());
    const Real lower = mu[n] + up - pencil::noise(abs(mu[n]) + abs(up));
    const Real upper = mu[n] - down + pencil::noise(abs(mu[n]) + abs(down));
    const auto proved = definite & (upper >= lower);  // false for numbers that are none
    result[n] = { select(proved, lower, -infinite), select(proved, upper, infinite) };
  }
  return result;
}
}  // namespace pkm_workspace
