// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "pkm_workspace/dexterity/condition.h"
#include "pkm_workspace/dexterity/criterion.h"
#include "pkm_workspace/dexterity/pencil_forms.h"
#include "pkm_workspace/interval/enclosed_constants.h"

namespace pkm_workspace
{
/// The tool can push with the force F in every direction, at rest, while no joint needs more than its T_i: tau = B A^-T
/// f, so that the most that joint i ever needs is F |b_i| sqrt((G^-1)_ii), G = A A^T, and for each i G - (F / T_i)^2
/// b_i^2 e_i e_i^T is semidefinite.
template <class Real>
class ToolForce
{
public:
  static constexpr bool BOUNDS_FACTORS = true;
  static std::optional<Interval> steepest(const Machine& /*machine*/, const Criterion& /*criterion*/)
  {
    return std::nullopt;
  }
  /// T_i |det A| / (|b_i| |n_j x n_k|) for each leg.
  template <class At>
  static void tellLimits(At& at)
  {
    const Criterion& criterion = at.criterion();
    for (std::size_t leg = 0; criterion.tool_force_min > 0.0 && at.hasValues() && leg < 3; ++leg)
    {
      const Configuration& there = at.configuration();
      const Interval needed = abs(there.eta[leg]) * norm(cross(there.strut[(leg + 1) % 3], there.strut[(leg + 2) % 3]));
      const Interval most =
          Interval(criterion.joint_effort_max[leg]) / driveScale(at.machine().legs()[leg]) * abs(there.det_a);
      at.atLeast(ConditionKind::TOOL_FORCE_MIN, static_cast<int>(leg),
                 needed.certainlyPositive() ? most / needed : Interval(0.0, INF), criterion.tool_force_min);
    }
  }

  ToolForce(const Machine& machine, const Criterion& criterion) : is_asked_(criterion.tool_force_min > 0.0)
  {
    for (std::size_t leg = 0; is_asked_ && leg < 3; ++leg)
    {
      const Enclosed<Real> ratio = scaled(quotient<Real>(criterion.tool_force_min, criterion.joint_effort_max[leg]),
                                          driveScale(machine.legs()[leg]));
      minus_squared_[leg] = -(ratio * ratio);
    }
  }
  template <class Other>
  explicit ToolForce(const ToolForce<Other>& other) : is_asked_(other.is_asked_)
  {
    for (std::size_t leg = 0; leg < 3; ++leg)
      minus_squared_[leg] = Enclosed<Real>(other.minus_squared_[leg]);
  }

  template <class Place, class Visitor>
  void visit(const Place& place, Visitor& visitor) const
  {
    if (!is_asked_)
      return;
    const SymmetricForms<Real> gram = gramMatrix(place.legs, place.forms);
    for (std::size_t leg = 0; leg < 3; ++leg)
    {
      SymmetricForms<Real> matrix = gram;
      matrix[leg] = place.legs.weighed(leg, place.forms, minus_squared_[leg], One());
      visitor.matrix({ ConditionKind::TOOL_FORCE_MIN, leg }, matrix);
    }
  }

  Real margin(const NearPlace<Real>& place) const
  {
    using std::min;
    Real least(NO_MARGIN);
    for (std::size_t leg = 0; is_asked_ && leg < 3; ++leg)
    {
      eigen::Symmetric<Real> matrix = pencilNear(place.legs, place.at, Real(0), Real(1));
      matrix[leg] = matrix[leg] + minus_squared_[leg].value * place.at.legs[leg].squared_drive;
      least = min(least, eigen::leastEigenpair(matrix).value * place.per_square);
    }
    return least;
  }

private:
  template <class>
  friend class ToolForce;

  bool is_asked_;
  std::array<Enclosed<Real>, 3> minus_squared_;  ///< -(F / T_i)^2
};
}  // namespace pkm_workspace
