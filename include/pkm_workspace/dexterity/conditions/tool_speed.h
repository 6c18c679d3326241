// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>

#include "pkm_workspace/dexterity/condition.h"
#include "pkm_workspace/dexterity/criterion.h"
#include "pkm_workspace/interval/enclosed_constants.h"

namespace pkm_workspace
{
/// The tool can move at the speed v in every direction while no joint is faster than its V_i: as qdot = B^-1 A pdot,
/// the fastest that joint i ever is at that speed is v |n_i| / |b_i|, so b_i^2 - (v / V_i)^2 n_i^2 >= 0.
template <class Real>
class ToolSpeed
{
public:
  static constexpr bool BOUNDS_FACTORS = true;
  static std::optional<Interval> steepest(const Machine& machine, const Criterion& criterion)
  {
    if (!(criterion.tool_speed_min > 0.0))
      return std::nullopt;
    double fastest = 0.0;
    for (std::size_t leg = 0; leg < 3; ++leg)
      fastest = std::max(fastest, (Interval(criterion.joint_speed_max[leg]) * driveScale(machine.legs()[leg])).upper());
    // |n| is not below |b|: of less than 1 the set is empty, and more bounds it no less rightly
    return Interval(std::max(fastest, 1e-3 * criterion.tool_speed_min)) / Interval(criterion.tool_speed_min);
  }
  /// V_i |b_i| / |n_i| for each leg.
  template <class At>
  static void tellLimits(At& at)
  {
    const Criterion& criterion = at.criterion();
    for (std::size_t leg = 0; criterion.tool_speed_min > 0.0 && at.hasValues() && leg < 3; ++leg)
      at.atLeast(ConditionKind::TOOL_SPEED_MIN, static_cast<int>(leg),
                 Interval(criterion.joint_speed_max[leg]) * driveScale(at.machine().legs()[leg]) *
                     abs(at.configuration().eta[leg]) / norm(at.configuration().strut[leg]),
                 criterion.tool_speed_min);
  }

  ToolSpeed(const Machine& machine, const Criterion& criterion) : is_asked_(criterion.tool_speed_min > 0.0)
  {
    for (std::size_t leg = 0; is_asked_ && leg < 3; ++leg)
    {
      const Enclosed<Real> ratio = scaled(quotient<Real>(criterion.tool_speed_min, criterion.joint_speed_max[leg]),
                                          Interval(1.0) / driveScale(machine.legs()[leg]));
      minus_squared_[leg] = -(ratio * ratio);
    }
  }
  template <class Other>
  explicit ToolSpeed(const ToolSpeed<Other>& other) : is_asked_(other.is_asked_)
  {
    for (std::size_t leg = 0; leg < 3; ++leg)
      minus_squared_[leg] = Enclosed<Real>(other.minus_squared_[leg]);
  }

  template <class Place, class Visitor>
  void visit(const Place& place, Visitor& visitor) const
  {
    for (std::size_t leg = 0; is_asked_ && leg < 3; ++leg)
      visitor.scalar({ ConditionKind::TOOL_SPEED_MIN, leg },
                     place.legs.weighed(leg, place.forms, One(), minus_squared_[leg]), 2);
  }

  Real margin(const NearPlace<Real>& place) const
  {
    using std::min;
    Real least(NO_MARGIN);
    for (std::size_t leg = 0; is_asked_ && leg < 3; ++leg)
      least =
          min(least, (place.at.legs[leg].squared_drive +
                      minus_squared_[leg].value * place.legs.squaredRowNear(leg, place.at.legs[leg].squared_drive)) *
                         place.per_square);
    return least;
  }

private:
  template <class>
  friend class ToolSpeed;

  bool is_asked_;
  std::array<Enclosed<Real>, 3> minus_squared_;  ///< -(v / V_i)^2
};
}  // namespace pkm_workspace
