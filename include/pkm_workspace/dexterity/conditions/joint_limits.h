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
  static std::optional<Interval> steepest(const Criterion& /*criterion*/) { return std::nullopt; }
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
      const std::array<double, 2> limit = { -limits[leg].lower(), limits[leg].upper() };
      for (const std::size_t side : { 0U, 1U })
      {
        limited_[leg][side] = std::isfinite(limit[side]);
        limit_[leg][side] = limited_[leg][side] ? Enclosed<Real>(Interval(limit[side])) : Enclosed<Real>();
      }
    }
  }
  template <class Other>
  explicit JointLimits(const JointLimits<Other>& other) : limited_(other.limited_)
  {
    for (std::size_t leg = 0; leg < 3; ++leg)
      limit_[leg] = { Enclosed<Real>(other.limit_[leg][0]), Enclosed<Real>(other.limit_[leg][1]) };
  }

  /// Whether the leg has a lower (side = 0) or upper (side = 1) limit that binds.
  bool limited(std::size_t leg, int side) const { return limited_[leg][static_cast<std::size_t>(side)]; }

  /// q - lower (side = 0) or upper - q (side = 1) [m] over the box.
  template <class Place>
  AffineForm<Real> form(std::size_t leg, int side, const Place& place) const
  {
    const AffineForm<Real> q = place.legs.joint(leg, place.forms, place.box);
    return (side == 0 ? q : -q) + limit_[leg][static_cast<std::size_t>(side)];
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
      for (const int side : { 0, 1 })
        if (limited(leg, side))
          visitor.scalar({ side == 0 ? ConditionKind::JOINT_LOWER : ConditionKind::JOINT_UPPER, leg },
                         form(leg, side, place), 1);
  }

  Real margin(const NearPlace<Real>& place) const
  {
    using std::min;
    Real least(NO_MARGIN);
    for (std::size_t leg = 0; leg < 3; ++leg)
    {
      if (!limited_[leg][0] && !limited_[leg][1])
        continue;
      const Real q = place.legs.jointNear(leg, place.at, place.p);
      if (limited_[leg][0])
        least = min(least, (q + limit_[leg][0].value) * place.per_length);
      if (limited_[leg][1])
        least = min(least, (limit_[leg][1].value - q) * place.per_length);
    }
    return least;
  }

private:
  template <class>
  friend class JointLimits;

  std::array<std::array<bool, 2>, 3> limited_;
  std::array<std::array<Enclosed<Real>, 2>, 3> limit_;  ///< -lower and upper [m]
};
}  // namespace pkm_workspace
