// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "pkm_workspace/dexterity/condition.h"
#include "pkm_workspace/dexterity/workspace_bounds.h"

namespace pkm_workspace
{
/// Each joint keeps within its limits, as far as the other conditions do not imply it.
template <class Real>
class JointLimits
{
public:
  static constexpr bool BOUNDS_FACTORS = false;
  static std::optional<Interval> steepest(const Machine& /*machine*/, const Criterion& /*criterion*/)
  {
    return std::nullopt;
  }
  template <class At>
  static void tellLimits(At& at)
  {
    if (at.criterion().joint_limits && at.hasValues())
      tellLimits(at.machine(), at.values().rho, at);
  }
  /// Whether a criterion asks for them or not. @param rho joint values [m]
  template <class Teller>
  static void tellLimits(const Machine& machine, const std::array<Interval, 3>& rho, Teller& teller)
  {
    for (int leg = 0; leg < 3; ++leg)
    {
      const Interval& limits = machine.leg(leg).limits;
      const Interval& value = rho[static_cast<std::size_t>(leg)];
      if (std::isfinite(limits.lower()))
        teller.atLeast(ConditionKind::JOINT_LOWER, leg, value, limits.lower());
      if (std::isfinite(limits.upper()))
        teller.atMost(ConditionKind::JOINT_UPPER, leg, value, limits.upper());
    }
  }

  JointLimits(const Machine& machine, const Criterion& criterion)
  {
    const std::array<Interval, 3> limits = limitsThatBind(machine, criterion);
    for (std::size_t leg = 0; leg < 3; ++leg)
    {
      const Leg& of = machine.legs()[leg];
      is_either_[leg] = hasAngle(of) && limits[leg].isBounded() && exceedsHalfTurn(limits[leg]);
      const std::array<double, 2> limit = { limits[leg].lower(), limits[leg].upper() };
      for (const std::size_t side : { 0U, 1U })
      {
        limited_[leg][side] = std::isfinite(limit[side]);
        if (limited_[leg][side])
          limit_[leg][side] = limitAt(of, limit[side], side == 1);
      }
    }
  }
  template <class Other>
  explicit JointLimits(const JointLimits<Other>& other) : limited_(other.limited_), is_either_(other.is_either_)
  {
    for (std::size_t leg = 0; leg < 3; ++leg)
      limit_[leg] = { JointLimit<Real>(other.limit_[leg][0]), JointLimit<Real>(other.limit_[leg][1]) };
  }

  /// Whether the leg has a lower (side = 0) or upper (side = 1) limit that binds.
  bool limited(std::size_t leg, int side) const { return limited_[leg][static_cast<std::size_t>(side)]; }

  /// How far the joint is above its lower limit (side = 0) or below its upper one (side = 1) over the box [m]: q -
  /// lower or upper - q, of an angle the way of a crank's tip from where it is at the limit.
  template <class Place>
  AffineForm<Real> form(std::size_t leg, int side, const Place& place) const
  {
    return place.legs.fromLimit(leg, place.forms, place.box, limit_[leg][static_cast<std::size_t>(side)]);
  }

  template <class Place, class Visitor>
  void visitScalar(const Place& place, Visitor& visitor) const
  {
    visit(place, visitor);
  }

  template <class Place, class Visitor>
  void visit(const Place& place, Visitor& visitor) const
  {
    for (std::size_t leg = 0; leg < 3; ++leg)
      if (is_either_[leg])
        visitor.scalar({ ConditionKind::JOINT_LOWER, leg }, maximum(form(leg, 0, place), form(leg, 1, place)), 1);
      else
        visitEach(leg, place, visitor);
  }

  Real margin(const NearPlace<Real>& place) const
  {
    using std::max;
    using std::min;
    Real least(NO_MARGIN);
    for (std::size_t leg = 0; leg < 3; ++leg)
    {
      const auto within = [&](std::size_t side) {
        return limited_[leg][side]
                   ? place.legs.fromLimitNear(leg, place.at, place.p, limit_[leg][side]) * place.per_length
                   : Real(NO_MARGIN);
      };
      least = min(least, is_either_[leg] ? max(within(0), within(1)) : min(within(0), within(1)));
    }
    return least;
  }

private:
  template <class>
  friend class JointLimits;

  /// Limits of an angle that leave more than a half turn hold where it is within a half turn beyond the one, or before
  /// the other; those that leave less, where both is so.
  static bool exceedsHalfTurn(const Interval& limits)
  {
    return (Interval(limits.upper()) - Interval(limits.lower())).lower() >= pi().upper();
  }

  template <class Place, class Visitor>
  void visitEach(std::size_t leg, const Place& place, Visitor& visitor) const
  {
    for (const int side : { 0, 1 })
      if (limited(leg, side))
        visitor.scalar({ side == 0 ? ConditionKind::JOINT_LOWER : ConditionKind::JOINT_UPPER, leg },
                       form(leg, side, place), 1);
  }

  static JointLimit<Real> limitAt(const Leg& leg, double value, bool is_upper)
  {
    JointLimit<Real> limit;
    limit.is_upper = is_upper;
    limit.value = Enclosed<Real>(Interval(is_upper ? value : -value));
    if (!hasAngle(leg))
      return limit;
    const double reference = referenceOf(leg);
    limit.cosine = Enclosed<Real>(cos(value) * cos(reference) + sin(value) * sin(reference));
    limit.sine = Enclosed<Real>(sin(value) * cos(reference) - cos(value) * sin(reference));
    return limit;
  }

  std::array<std::array<bool, 2>, 3> limited_;
  std::array<bool, 3> is_either_ = { false, false, false };
  std::array<std::array<JointLimit<Real>, 2>, 3> limit_;
};
}  // namespace pkm_workspace
