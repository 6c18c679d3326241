// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <vector>

#include "pkm_workspace/dexterity/condition.h"
#include "pkm_workspace/dexterity/criterion.h"
#include "pkm_workspace/interval/enclosed_constants.h"

namespace pkm_workspace
{
/// Each ball joint tilts by no more than the angle phi from its axis a: n . a >= |n| |a| cos phi, for each axis of
/// Machine::ballAxes() and Criterion::tiltOf() its strut.
template <class Real>
class BallTilt
{
public:
  static constexpr bool BOUNDS_FACTORS = true;
  static std::optional<Interval> steepest(const Machine& /*machine*/, const Criterion& /*criterion*/)
  {
    return std::nullopt;
  }
  /// The angle between strut and axis, of the worse end.
  template <class At>
  static void tellLimits(At& at)
  {
    for (int leg = 0; at.criterion().ball_tilt_max > 0.0 && at.hasValues() && leg < 3; ++leg)
    {
      const IntervalVector& row = at.configuration().strut[static_cast<std::size_t>(leg)];
      Interval largest(0.0);
      for (const IntervalVector& axis : at.machine().ballAxes(leg))
      {
        const Interval tilt = acos(dot(row, axis) / (norm(row) * norm(axis)));
        largest = { std::max(largest.lower(), tilt.lower()), std::max(largest.upper(), tilt.upper()) };
      }
      at.atMost(ConditionKind::BALL_TILT_MAX, leg, largest, at.criterion().tiltOf(static_cast<std::size_t>(leg)));
    }
  }

  BallTilt(const Machine& machine, const Criterion& criterion)
  {
    for (std::size_t leg = 0; criterion.ball_tilt_max > 0.0 && leg < 3; ++leg)
    {
      const Interval cosine = leastCosine(criterion.tiltOf(leg), machine, leg);
      // of a telescopic strut |n| = b
      const Interval length = sqrtAboveZero(squaredRow(machine.enclosed(static_cast<int>(leg)), Interval(0.0)));
      const bool is_fixed = length != Interval(0.0);
      for (const IntervalVector& axis : machine.ballAxes(static_cast<int>(leg)))
        cones_.push_back({ leg, EnclosedVector<Real>(axis), Enclosed<Real>(-(length * norm(axis) * cosine)),
                           is_fixed ? Enclosed<Real>() : Enclosed<Real>(-(norm(axis) * cosine)), is_fixed });
    }
  }
  template <class Other>
  explicit BallTilt(const BallTilt<Other>& other)
  {
    for (const auto& cone : other.cones_)
      cones_.push_back({ cone.leg, EnclosedVector<Real>(cone.axis), Enclosed<Real>(cone.minus_least),
                         Enclosed<Real>(cone.minus_share), cone.is_fixed });
  }

  template <class Place, class Visitor>
  void visit(const Place& place, Visitor& visitor) const
  {
    for (const Cone& cone : cones_)
    {
      const auto& leg = place.forms.legs[cone.leg];
      const AffineForm<Real> along = dot(cone.axis, leg.row);
      visitor.scalar({ ConditionKind::BALL_TILT_MAX, cone.leg },
                     cone.is_fixed ? along + cone.minus_least : along + cone.minus_share * leg.drive, 1);
    }
  }

  Real margin(const NearPlace<Real>& place) const
  {
    using std::min;
    Real least(NO_MARGIN);
    for (const Cone& cone : cones_)
    {
      const auto& leg = place.at.legs[cone.leg];
      const Real most = cone.is_fixed ? cone.minus_least.value : cone.minus_share.value * leg.drive;
      least = min(least, (dot(cone.axis.value, leg.row) + most) * place.per_length);
    }
    return least;
  }

private:
  template <class>
  friend class BallTilt;

  struct Cone
  {
    std::size_t leg;
    EnclosedVector<Real> axis;
    Enclosed<Real> minus_least;  ///< -|n| |a| cos phi
    Enclosed<Real> minus_share;  ///< -|a| cos phi, where |n| is not the same everywhere
    bool is_fixed;               ///< |n| is
  };

  /// Where axes turn with a rail that is not as it was meant, or do not: what is enough for all, and what one needs.
  static Interval leastCosine(double tilt, const Machine& machine, std::size_t leg)
  {
    const double turn = toleranceOf(machine.leg(static_cast<int>(leg))).direction;
    if (!(turn > 0.0))
      return cos(tilt);
    return { cos((tilt + turn) * (1.0 + 0x1p-48)).lower(),
             cos(std::max((tilt - turn) * (1.0 - 0x1p-48), 0.0)).upper() };
  }

  std::vector<Cone> cones_;
};
}  // namespace pkm_workspace
