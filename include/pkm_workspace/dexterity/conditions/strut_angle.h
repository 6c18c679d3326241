// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>

#include "pkm_workspace/dexterity/condition.h"
#include "pkm_workspace/dexterity/criterion.h"
#include "pkm_workspace/interval/enclosed_constants.h"

namespace pkm_workspace
{
/// The angle phi between each strut and its rail, cos phi = |b| / |n|, lies in [phi_min, phi_max]; of a crank that
/// between forearm and the way of its tip, of a telescopic strut it is 0: n^2 cos^2 phi_max <= b^2 <= n^2 cos^2
/// phi_min.
template <class Real>
class StrutAngle
{
public:
  static constexpr bool BOUNDS_FACTORS = true;
  static std::optional<Interval> steepest(const Machine& machine, const Criterion& criterion)
  {
    Interval cosine = criterion.strut_angle_max > 0.0 ? cos(criterion.strut_angle_max) : Interval(0.0);
    for (const Leg& leg : machine.legs())
      cosine = { std::min(cosine.lower(), (cosine * gearOf(leg)).lower()), cosine.upper() };
    return cosine.certainlyPositive() ? std::make_optional(Interval(1.0) / cosine) : std::nullopt;
  }
  template <class At>
  static void tellLimits(At& at)
  {
    const Criterion& criterion = at.criterion();
    for (std::size_t leg = 0; at.hasValues() && leg < 3; ++leg)
    {
      const auto angle = [&] {
        return acos(abs(at.configuration().eta[leg]) /
                    (norm(at.configuration().strut[leg]) * gearOf(at.machine().legs()[leg])));
      };
      if (criterion.strut_angle_min > 0.0)
        at.atLeast(ConditionKind::STRUT_ANGLE_MIN, static_cast<int>(leg), angle(), criterion.strut_angle_min);
      if (criterion.strut_angle_max > 0.0)
        at.atMost(ConditionKind::STRUT_ANGLE_MAX, static_cast<int>(leg), angle(), criterion.strut_angle_max);
    }
  }

  StrutAngle(const Machine& machine, const Criterion& criterion)
    : is_asked_{ criterion.strut_angle_min > 0.0, criterion.strut_angle_max > 0.0 }
  {
    for (std::size_t leg = 0; leg < 3; ++leg)
    {
      const Interval gear = sqr(gearOf(machine.legs()[leg]));
      squared_[leg] = { scaled(squared<Real>(cos(criterion.strut_angle_min)), gear),
                        scaled(squared<Real>(cos(criterion.strut_angle_max)), gear) };
    }
  }
  template <class Other>
  explicit StrutAngle(const StrutAngle<Other>& other) : is_asked_(other.is_asked_)
  {
    for (std::size_t leg = 0; leg < 3; ++leg)
      squared_[leg] = { Enclosed<Real>(other.squared_[leg][0]), Enclosed<Real>(other.squared_[leg][1]) };
  }

  template <class Place, class Visitor>
  void visit(const Place& place, Visitor& visitor) const
  {
    for (std::size_t leg = 0; leg < 3; ++leg)
      for (const std::size_t side : { 0U, 1U })
        if (is_asked_[side])
        {
          const AffineForm<Real> above = place.legs.weighed(leg, place.forms, One(), -squared_[leg][side]);
          visitor.scalar({ side == 0 ? ConditionKind::STRUT_ANGLE_MIN : ConditionKind::STRUT_ANGLE_MAX, leg },
                         side == 0 ? -above : above, 2);
        }
  }

  Real margin(const NearPlace<Real>& place) const
  {
    using std::min;
    Real least(NO_MARGIN);
    for (std::size_t leg = 0; leg < 3; ++leg)
      for (const std::size_t side : { 0U, 1U })
        if (is_asked_[side])
        {
          const Real above =
              place.at.legs[leg].squared_drive -
              squared_[leg][side].value * place.legs.squaredRowNear(leg, place.at.legs[leg].squared_drive);
          least = min(least, (side == 0 ? -above : above) * place.per_square);
        }
    return least;
  }

private:
  template <class>
  friend class StrutAngle;

  std::array<bool, 2> is_asked_;
  /// cos^2 of phi_min and of phi_max, times the square of what the leg's b has for each |n| cos phi.
  std::array<std::array<Enclosed<Real>, 2>, 3> squared_;
};
}  // namespace pkm_workspace
