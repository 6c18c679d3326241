// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "pkm_workspace/dexterity/condition.h"
#include "pkm_workspace/dexterity/criterion.h"
#include "pkm_workspace/dexterity/pencil_forms.h"

namespace pkm_workspace
{
/// psi_3 <= psi_max, for the smaller of psi_max and 1 / force_min: S_max = psi_max^2 B^2 - A A^T is semidefinite.
template <class Real>
class LargestFactor
{
public:
  static constexpr bool BOUNDS_FACTORS = true;
  static std::optional<Interval> steepest(const Machine& /*machine*/, const Criterion& criterion)
  {
    return criterion.boundsAbove() ? std::make_optional(criterion.largestFactor()) : std::nullopt;
  }
  template <class At>
  static void tellLimits(At& /*at*/)
  {}

  LargestFactor(const Machine& /*machine*/, const Criterion& criterion)
    : is_asked_(criterion.boundsAbove())
    , squared_(is_asked_ ? squared<Real>(criterion.largestFactor()) : Enclosed<Real>())
  {}
  template <class Other>
  explicit LargestFactor(const LargestFactor<Other>& other) : is_asked_(other.is_asked_), squared_(other.squared_)
  {}

  template <class Place, class Visitor>
  void visit(const Place& place, Visitor& visitor) const
  {
    if (is_asked_)
      visitor.matrix({ ConditionKind::PSI_MAX }, oppositePencilForms(place.legs, place.forms, squared_));
  }

  Real margin(const NearPlace<Real>& place) const
  {
    if (!is_asked_)
      return Real(NO_MARGIN);
    return eigen::leastEigenpair(pencilNear(place.legs, place.at, squared_.value, Real(-1))).value * place.per_square;
  }

private:
  template <class>
  friend class LargestFactor;

  bool is_asked_;
  Enclosed<Real> squared_;  ///< psi_max^2
};
}  // namespace pkm_workspace
