// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "pkm_workspace/dexterity/eigen_witness.h"
#include "pkm_workspace/dexterity/machine_forms.h"
#include "pkm_workspace/interval/pencil_bounds.h"

namespace pkm_workspace
{
// The pencil of the transmission factors: A A^T u = psi^2 B^2 u (docs/theory.md). Matrices have the entries 00, 11, 22,
// 12, 02, 01, as SymmetricForms and eigen::Symmetric have them.

/// A A^T - mu B^2 [m^2] over a box. @param minus_mu - mu
template <class Real>
SymmetricForms<Real> pencilForms(const LegModels<Real>& legs, const MachineForms<Real>& forms,
                                 const Enclosed<Real>& minus_mu)
{
  SymmetricForms<Real> matrix;
  for (std::size_t i = 0; i < 3; ++i)
  {
    matrix[i] = legs.weighed(i, forms, minus_mu, One());
    matrix[3 + i] = forms.gram[i];
  }
  return matrix;
}

/// mu B^2 - A A^T [m^2] over a box.
template <class Real>
SymmetricForms<Real> oppositePencilForms(const LegModels<Real>& legs, const MachineForms<Real>& forms,
                                         const Enclosed<Real>& mu)
{
  SymmetricForms<Real> matrix;
  for (std::size_t i = 0; i < 3; ++i)
  {
    matrix[i] = legs.weighed(i, forms, mu, MinusOne());
    matrix[3 + i] = -forms.gram[i];
  }
  return matrix;
}

/// sign (A A^T - mu B^2) [m^2] at a point, in floating point.
template <class Real>
eigen::Symmetric<Real> pencilNear(const LegModels<Real>& legs, const MachineNumbers<Real>& at, const Real& mu,
                                  const Real& sign)
{
  eigen::Symmetric<Real> matrix;
  for (std::size_t i = 0; i < 3; ++i)
  {
    matrix[i] = sign * (legs.squaredRowNear(i, at.legs[i].squared_drive) - mu * at.legs[i].squared_drive);
    matrix[3 + i] = sign * at.gram[i];
  }
  return matrix;
}

/// A A^T [m^2] over a box.
template <class Real>
SymmetricForms<Real> gramMatrix(const LegModels<Real>& legs, const MachineForms<Real>& forms)
{
  SymmetricForms<Real> matrix;
  for (std::size_t i = 0; i < 3; ++i)
  {
    matrix[i] = legs.weighed(i, forms, Zero(), One());
    matrix[3 + i] = forms.gram[i];
  }
  return matrix;
}

/// Encloses the eigenvalues, ascending, of the pencil M - sigma D over a box, for the matrix D with these positive
/// forms on its diagonal and nothing else. @param inverse near to 1 over the roots of their middles
template <class Real>
std::array<Span<Real>, 3> pencilEigenvalues(const SymmetricForms<Real>& m, const std::array<AffineForm<Real>, 3>& d,
                                            const std::array<Real, 3>& inverse)
{
  eigen::Symmetric<Real> matrix;
  for (std::size_t i = 0; i < 3; ++i)
  {
    matrix[i] = m[i].center * inverse[i] * inverse[i];
    matrix[3 + i] = m[3 + i].center * inverse[(i + 1) % 3] * inverse[(i + 2) % 3];
  }
  eigen::Basis<Real> basis = eigen::basisOf(matrix);
  for (auto& vector : basis.vector)
    for (std::size_t i = 0; i < 3; ++i)
      vector[i] = vector[i] * inverse[i];
  return pencilEigenvalues(m, diagonal(d), basis.vector, basis.value);
}

/// The eigenvalues psi_1^2 and psi_3^2 of (J J^T)^-1 at one point, in floating point, and vectors u with
/// A A^T u = psi^2 B^2 u and u^T B^2 u = 1 [1/m].
template <class Real>
struct ExtremeFactors
{
  Eigenpair<Real> least;
  std::array<Real, 3> middle;
  Eigenpair<Real> largest;
};

/// With x an eigenvector of B^-1 A A^T B^-1, u = B^-1 x.
/// @pre no b_i^2 is much smaller than n_i^2
template <class Real>
ExtremeFactors<Real> extremeFactors(const LegModels<Real>& legs, const std::array<Real, 3>& squared_drives,
                                    const std::array<Real, 3>& gram)
{
  using std::max;
  using std::sqrt;
  std::array<Real, 3> per_drive;
  for (std::size_t i = 0; i < 3; ++i)
    per_drive[i] = Real(1) / sqrt(max(squared_drives[i], Real(1e-12) * legs.squaredRowNear(i, squared_drives[i])));
  eigen::Symmetric<Real> matrix;
  eigen::Symmetric<Real> opposite;
  for (std::size_t i = 0; i < 3; ++i)
  {
    matrix[i] = legs.squaredRowNear(i, squared_drives[i]) * per_drive[i] * per_drive[i];
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

/// The same at delta = 0 of a box.
template <class Real>
ExtremeFactors<Real> extremeFactors(const LegModels<Real>& legs, const MachineForms<Real>& forms)
{
  const std::array<AffineForm<Real>, 3> b_b = forms.squaredDrives();
  return extremeFactors(legs, { b_b[0].center, b_b[1].center, b_b[2].center },
                        { forms.gram[0].center, forms.gram[1].center, forms.gram[2].center });
}
}  // namespace pkm_workspace
