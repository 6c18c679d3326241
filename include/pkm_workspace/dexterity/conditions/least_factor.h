// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "pkm_workspace/dexterity/condition.h"
#include "pkm_workspace/dexterity/criterion.h"
#include "pkm_workspace/dexterity/pencil_forms.h"

namespace pkm_workspace
{
/// psi_1 >= psi_min, for the larger of psi_min and 1 / force_max: S_min = A A^T - psi_min^2 B^2 is semidefinite.
template <class Real>
class LeastFactor
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

  LeastFactor(const Machine& /*machine*/, const Criterion& criterion)
    : is_asked_(criterion.boundsBelow())
    , minus_squared_(is_asked_ ? -squared<Real>(criterion.leastFactor()) : Enclosed<Real>())
  {}
  template <class Other>
  explicit LeastFactor(const LeastFactor<Other>& other)
    : is_asked_(other.is_asked_), minus_squared_(other.minus_squared_)
  {}

  template <class Place, class Visitor>
  void visit(const Place& place, Visitor& visitor) const
  {
    if (is_asked_)
      visitor.matrix({ ConditionKind::PSI_MIN }, pencilForms(place.legs, place.forms, minus_squared_));
  }

  Real margin(const NearPlace<Real>& place) const
  {
    if (!is_asked_)
      return Real(NO_MARGIN);
    return eigen::leastEigenpair(pencilNear(place.legs, place.at, -minus_squared_.value, Real(1))).value *
           place.per_square;
  }

private:
  template <class>
  friend class LeastFactor;

  bool is_asked_;
  Enclosed<Real> minus_squared_;  ///< -psi_min^2
};
}  // namespace pkm_workspace
