// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Definitions of the templates declared in machine_forms.h that are about the condition number.

#include "pkm_workspace/dexterity/machine_forms.h"

namespace pkm_workspace
{
/// Floating point. With x an eigenvector of B^-1 A A^T B^-1, u = B^-1 x.
template <class Real>
ExtremeFactors<Real> MachineModel<Real>::extremeFactors(const std::array<Real, 3>& squared_drive,
                                                        const std::array<Real, 3>& gram) const
{
  using std::max;
  using std::sqrt;
  std::array<Real, 3> per_drive;
  for (std::size_t i = 0; i < 3; ++i)
    per_drive[i] = Real(1) / sqrt(max(squared_drive[i], Real(1e-12) * squaredRow(i).value));
  eigen::Symmetric<Real> matrix;
  eigen::Symmetric<Real> opposite;
  for (std::size_t i = 0; i < 3; ++i)
  {
    matrix[i] = squaredRow(i).value * per_drive[i] * per_drive[i];
    matrix[3 + i] = gram[i] * per_drive[(i + 1) % 3] * per_drive[(i + 2) % 3];
    opposite[i] = -matrix[i];
    opposite[3 + i] = -matrix[3 + i];
  }
  ExtremeFactors<Real> factors{ eigen::leastEigenpair(matrix), {}, eigen::leastEigenpair(opposite) };
  factors.largest.value = -factors.largest.value;
  factors.middle = cross(factors.least.vector, factors.largest.vector);
  for (std::size_t i = 0; i < 3; ++i)
    for (auto* u : { &factors.least.vector, &factors.middle, &factors.largest.vector })
      (*u)[i] = (*u)[i] * per_drive[i];
  return factors;
}

/// The geometric middle of psi_1^2 and psi_3^2 / kappa^2 at delta = 0, and how it changes to first order. Any affine
/// function would be sound: it has no error of its own.
template <class Real>
AffineForm<Real> MachineModel<Real>::level(const MachineForms<Real>& forms, const ExtremeFactors<Real>& factors) const
{
  using std::max;
  using std::sqrt;
  const Real largest = factors.largest.value;
  const Real least = max(factors.least.value, Real(1e-12) * largest);
  AffineForm<Real> level;
  level.center = sqrt(least * largest * per_kappa_squared_);
  const auto relativeSlope = [&](const std::array<Real, 3>& u, const Real& value, std::size_t j) {
    Real slope(0);
    for (std::size_t i = 0; i < 3; ++i)
      slope = slope + Real(2) * u[(i + 1) % 3] * u[(i + 2) % 3] * forms.gram[i].gradient[j] -
              value * u[i] * u[i] * forms.legs[i].squared_drive.gradient[j];
    return slope / value;
  };
  for (std::size_t j = 0; j < 3; ++j)
    level.gradient[j] =
        Real(0.5) * level.center *
        (relativeSlope(factors.least.vector, least, j) + relativeSlope(factors.largest.vector, largest, j));
  return level;
}

template <class Real>
ExtremeFactors<Real> MachineModel<Real>::extremeFactors(const MachineForms<Real>& forms) const
{
  const auto& legs = forms.legs;
  return extremeFactors({ legs[0].squared_drive.center, legs[1].squared_drive.center, legs[2].squared_drive.center },
                        { forms.gram[0].center, forms.gram[1].center, forms.gram[2].center });
}

template <class Real>
SymmetricForms<Real> MachineModel<Real>::gramMatrix(const MachineForms<Real>& forms) const
{
  SymmetricForms<Real> matrix;
  for (std::size_t i = 0; i < 3; ++i)
  {
    matrix[i] = matrix[i] + squaredRow(i);
    matrix[3 + i] = forms.gram[i];
  }
  return matrix;
}

template <class Real>
void MachineModel<Real>::conditionForms(const MachineForms<Real>& forms, ConditionForms<Real>& condition) const
{
  const SymmetricForms<Real> a_a = gramMatrix(forms);
  const SymmetricForms<Real> b_b = diagonal(forms.squaredDrives());
  const ExtremeFactors<Real> factors = extremeFactors(forms);
  const AffineForm<Real> t = level(forms, factors);
  for (std::size_t i = 0; i < 3; ++i)
  {
    const AffineForm<Real> scaled = t * forms.legs[i].squared_drive;
    condition.lower[i] = a_a[i] - scaled;
    condition.upper[i] = kappa_squared_ * scaled - a_a[i];
    condition.lower[3 + i] = a_a[3 + i];
    condition.upper[3 + i] = -a_a[3 + i];
  }
  const auto balance = [&](const std::array<Real, 3>& u, const std::array<Real, 3>& v) {
    const AffineForm<Real> difference = kappa_squared_ * (quadraticForm(a_a, u) * quadraticForm(b_b, v)) -
                                        quadraticForm(a_a, v) * quadraticForm(b_b, u);
    return Enclosed<Real>(per_kappa_squared_, Real(0)) * difference;
  };
  condition.necessary = { balance(factors.least.vector, factors.largest.vector),
                          balance(factors.least.vector, factors.middle),
                          balance(factors.middle, factors.largest.vector) };
}
}  // namespace pkm_workspace
