// SPDX-License-Identifier: BSD-3-Clause
#include "list_test.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <limits>

namespace pkm_workspace
{
namespace bench
{
namespace upward
{
namespace
{
/// A number within x, and a bound on the distance of all others from it.
double split(const Real& x, double& radius)
{
  const double middle = 0.5 * (x.lower() + x.upper());
  radius = std::max(x.upper() - middle, middle - x.lower());
  return middle;
}

/// A bound on the spectral radius of the symmetric matrix r >= 0: (r v)_i / v_i <= bound for one positive v
/// (Collatz, Wielandt), after two steps of the power method.
double spectralRadius(const std::array<double, 3>& diagonal, const std::array<double, 3>& off)
{
  const auto times = [&](const std::array<double, 3>& v) {
    return std::array<double, 3>{ diagonal[0] * v[0] + off[2] * v[1] + off[1] * v[2],
                                  off[2] * v[0] + diagonal[1] * v[1] + off[0] * v[2],
                                  off[1] * v[0] + off[0] * v[1] + diagonal[2] * v[2] };
  };
  std::array<double, 3> v = times({ 1.0, 1.0, 1.0 });
  for (double& entry : v)
    entry += 1e-300;
  const std::array<double, 3> w = times(v);
  return std::max({ w[0] / v[0], w[1] / v[1], w[2] / v[2] });
}

/// Whether the least eigenvalue of the middle is above rho or below -rho: by the principal minors of middle - rho and
/// of middle + rho.
BoxVerdict definitenessByMinors(const Symmetric& middle, double rho)
{
  Symmetric moved = middle;
  for (Real& entry : moved.diagonal)
    entry -= rho;
  if (moved.diagonal[0].lower() > 0.0 && minorOf(moved, 2).lower() > 0.0 && determinant(moved).lower() > 0.0)
    return BoxVerdict::INSIDE;
  for (std::size_t i = 0; i < 3; ++i)
    moved.diagonal[i] = middle.diagonal[i] + rho;
  for (std::size_t i = 0; i < 3; ++i)
    if (moved.diagonal[i].upper() < 0.0 || minorOf(moved, i).upper() < 0.0)
      return BoxVerdict::OUTSIDE;
  return determinant(moved).upper() < 0.0 ? BoxVerdict::OUTSIDE : BoxVerdict::UNDECIDED;
}

/// The same by the least eigenvalue, to whose error the QR iteration gives a few roundoffs times the norm.
BoxVerdict definitenessByEigenvalues(const Symmetric& middle, double rho)
{
  const auto entry = [](const Real& x) { return x.lower(); };  // single numbers
  Eigen::Matrix3d m;
  m.diagonal() << entry(middle.diagonal[0]), entry(middle.diagonal[1]), entry(middle.diagonal[2]);
  m(2, 1) = m(1, 2) = entry(middle.off[0]);
  m(0, 2) = m(2, 0) = entry(middle.off[1]);
  m(1, 0) = m(0, 1) = entry(middle.off[2]);
  const double least = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(m, Eigen::EigenvaluesOnly).eigenvalues()[0];
  const double bound = rho + 100 * std::numeric_limits<double>::epsilon() * m.norm();
  return least > bound ? BoxVerdict::INSIDE : least < -bound ? BoxVerdict::OUTSIDE : BoxVerdict::UNDECIDED;
}
}  // namespace

BoxVerdict definiteness(const Symmetric& m, ListWay way)
{
  Symmetric middle;
  std::array<double, 3> diagonal_radius, off_radius;
  for (std::size_t i = 0; i < 3; ++i)
  {
    middle.diagonal[i] = split(m.diagonal[i], diagonal_radius[i]);
    middle.off[i] = split(m.off[i], off_radius[i]);
  }
  const double rho = spectralRadius(diagonal_radius, off_radius);
  return way == ListWay::MINORS ? definitenessByMinors(middle, rho) : definitenessByEigenvalues(middle, rho);
}

// Where S_max is positive definite, so is eta^2: nothing below the root was left out.
BoxVerdict verdict(const Forms& forms, ListWay way)
{
  if (forms.is_outside)
    return BoxVerdict::OUTSIDE;
  const BoxVerdict above_min = definiteness(forms.s_min, way);
  if (above_min == BoxVerdict::OUTSIDE)
    return above_min;
  const BoxVerdict below_max = definiteness(forms.s_max, way);
  return below_max == BoxVerdict::INSIDE ? above_min : below_max;
}
}  // namespace upward
}  // namespace bench
}  // namespace pkm_workspace
