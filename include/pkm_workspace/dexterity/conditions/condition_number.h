// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "pkm_workspace/dexterity/condition.h"
#include "pkm_workspace/dexterity/criterion.h"
#include "pkm_workspace/dexterity/pencil_forms.h"

namespace pkm_workspace
{
/// psi_3 / psi_1 <= kappa. With one affine level t for psi_1^2 it holds wherever A A^T - t B^2 and
/// kappa^2 t B^2 - A A^T are both definite; and for any two vectors u and v it makes
/// kappa^2 (u^T A A^T u)(v^T B^2 v) - (v^T A A^T v)(u^T B^2 u) >= 0, by the quotients of Rayleigh.
template <class Real>
class ConditionNumber
{
public:
  static constexpr bool BOUNDS_FACTORS = true;
  static std::optional<Interval> steepest(const Machine& /*machine*/, const Criterion& /*criterion*/)
  {
    return std::nullopt;
  }
  template <class At>
  static void tellLimits(At& /*at*/)
  {}

  ConditionNumber(const Machine& /*machine*/, const Criterion& criterion)
    : is_asked_(criterion.boundsCondition())
    , squared_(squared<Real>(criterion.kappa_max))
    , per_squared_(is_asked_ ? Real(1) / (Real(criterion.kappa_max) * Real(criterion.kappa_max)) : Real(0))
  {}
  template <class Other>
  explicit ConditionNumber(const ConditionNumber<Other>& other)
    : is_asked_(other.is_asked_), squared_(other.squared_), per_squared_(other.per_squared_)
  {}

  template <class Place, class Visitor>
  void visit(const Place& place, Visitor& visitor) const
  {
    if (!is_asked_)
      return;
    const ExtremeFactors<Real> factors = extremeFactors(place.legs, place.forms);
    const SymmetricForms<Real> a_a = gramMatrix(place.legs, place.forms);
    visitNecessary(factors, a_a, diagonal(place.forms.squaredDrives()), visitor);
    const AffineForm<Real> t = level(place.forms, factors);
    SymmetricForms<Real> lower = a_a;
    SymmetricForms<Real> upper;
    for (std::size_t i = 0; i < 3; ++i)
    {
      const AffineForm<Real> scaled = t * place.forms.legs[i].squared_drive;
      lower[i] = a_a[i] - scaled;
      upper[i] = squared_ * scaled - a_a[i];
      upper[3 + i] = -a_a[3 + i];
    }
    visitor.sufficient(upper);
    visitor.sufficient(lower);
  }

  /// psi_1^2 - psi_3^2 / kappa^2.
  Real margin(const NearPlace<Real>& place) const
  {
    if (!is_asked_)
      return Real(NO_MARGIN);
    const ExtremeFactors<Real> factors = extremeFactors(place.legs, place.at.squaredDrives(), place.at.gram);
    return factors.least.value - per_squared_ * factors.largest.value;
  }

private:
  template <class>
  friend class ConditionNumber;

  /// For three pairs of eigenvectors, the extreme ones first; without unit.
  template <class Visitor>
  void visitNecessary(const ExtremeFactors<Real>& factors, const SymmetricForms<Real>& a_a,
                      const SymmetricForms<Real>& b_b, Visitor& visitor) const
  {
    const auto tell = [&](const std::array<Real, 3>& u, const std::array<Real, 3>& v) {
      const AffineForm<Real> difference =
          squared_ * (quadraticForm(a_a, u) * quadraticForm(b_b, v)) - quadraticForm(a_a, v) * quadraticForm(b_b, u);
      visitor.necessary({ ConditionKind::KAPPA_MAX }, u, v, Enclosed<Real>(per_squared_, Real(0)) * difference, 0);
    };
    tell(factors.least.vector, factors.largest.vector);
    tell(factors.least.vector, factors.middle);
    tell(factors.middle, factors.largest.vector);
  }

  /// The geometric middle of psi_1^2 and psi_3^2 / kappa^2 at delta = 0, and how it changes to first order. Any affine
  /// function would be sound: it has no error of its own.
  AffineForm<Real> level(const MachineForms<Real>& forms, const ExtremeFactors<Real>& factors) const
  {
    using std::max;
    using std::sqrt;
    const Real largest = factors.largest.value;
    const Real least = max(factors.least.value, Real(1e-12) * largest);
    AffineForm<Real> level;
    level.center = sqrt(least * largest * per_squared_);
    const auto relativeSlope = [&](const std::array<Real, 3>& u, const Real& value, std::size_t j) {
      Real slope(0);
      for (std::size_t i = 0; i < 3; ++i)
        slope = slope + Real(2) * u[(i + 1) % 3] * u[(i + 2) % 3] * forms.gram[i].gradient[j] -
                value * u[i] * u[i] * forms.legs[i].squared_drive.gradient[j];
      return slope / value;
    };
    for (std::size_t j = 0; j < level.gradient.size(); ++j)
      level.gradient[j] =
          Real(0.5) * level.center *
          (relativeSlope(factors.least.vector, least, j) + relativeSlope(factors.largest.vector, largest, j));
    return level;
  }

  bool is_asked_;
  Enclosed<Real> squared_;  ///< kappa^2
  Real per_squared_;        ///< nearly its inverse: only scales
};
}  // namespace pkm_workspace
