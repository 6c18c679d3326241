// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "pkm_workspace/dexterity/condition.h"
#include "pkm_workspace/dexterity/criterion.h"

namespace pkm_workspace
{
/// Each leg reaches the point: b_i^2 >= 0.
template <class Real>
class Reach
{
public:
  static constexpr bool BOUNDS_FACTORS = false;
  static std::optional<Interval> steepest(const Machine& /*machine*/, const Criterion& /*criterion*/)
  {
    return std::nullopt;
  }
  /// At any point.
  template <class At>
  static void tellLimits(At& at)
  {
    for (int leg = 0; leg < 3; ++leg)
    {
      const LegReach reach = reachAt(at.machine().enclosed(leg), at.point());
      at.tell({ ConditionKind::REACH, leg, reach.value, reach.most.mid(), reach.most - reach.value });
    }
  }

  Reach(const Machine& /*machine*/, const Criterion& criterion) : is_implied_(criterion.boundsAbove()) {}
  template <class Other>
  explicit Reach(const Reach<Other>& other) : is_implied_(other.is_implied_)
  {}

  template <class Place, class Visitor>
  void visitScalar(const Place& place, Visitor& visitor) const
  {
    visit(place, visitor);
  }

  template <class Place, class Visitor>
  void visit(const Place& place, Visitor& visitor) const
  {
    for (std::size_t leg = 0; leg < 3 && !is_implied_; ++leg)
      visitor.scalar({ ConditionKind::REACH, leg }, place.forms.legs[leg].squared_drive, 2);
  }

  /// From the floors of b_i^2.
  Real margin(const NearPlace<Real>& place) const
  {
    using std::min;
    const auto above = [&](std::size_t leg) { return place.at.legs[leg].squared_drive - place.legs.floor(leg); };
    return min(min(above(0), above(1)), above(2)) * place.per_square;
  }

private:
  template <class>
  friend class Reach;

  bool is_implied_;  ///< by the diagonal of psi_max^2 B^2 - A A^T
};
}  // namespace pkm_workspace
