// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "pkm_workspace/dexterity/condition.h"
#include "pkm_workspace/dexterity/criterion.h"
#include "pkm_workspace/interval/enclosed_constants.h"

namespace pkm_workspace
{
/// Each passive hinge keeps within its limits: n . u >= c for each of the stops of a strut (StrutStop).
template <class Real>
class HingeLimits
{
public:
  static constexpr bool BOUNDS_FACTORS = true;
  static std::optional<Interval> steepest(const Machine& /*machine*/, const Criterion& /*criterion*/)
  {
    return std::nullopt;
  }
  template <class At>
  static void tellLimits(At& at)
  {
    for (int leg = 0; at.criterion().hinge_limits && at.hasValues() && leg < 3; ++leg)
    {
      const std::vector<StrutStop>& stops = passiveJoints(at.machine().leg(leg)).stops;
      for (std::size_t k = 0; k < stops.size(); ++k)
      {
        const Interval value = dot(stops[k].direction, at.configuration().strut[static_cast<std::size_t>(leg)]);
        at.tell({ kindOf(stops[k]), leg, value, stops[k].least.mid(), value - stops[k].least, static_cast<int>(k) });
      }
    }
  }

  HingeLimits(const Machine& machine, const Criterion& criterion)
  {
    for (std::size_t leg = 0; criterion.hinge_limits && leg < 3; ++leg)
      for (const StrutStop& stop : passiveJoints(machine.leg(static_cast<int>(leg))).stops)
        stops_.push_back({ { kindOf(stop), leg },
                           EnclosedVector<Real>(stop.direction),
                           Enclosed<Real>(-leastOf(stop, machine.leg(static_cast<int>(leg)))) });
  }
  template <class Other>
  explicit HingeLimits(const HingeLimits<Other>& other)
  {
    for (const auto& stop : other.stops_)
      stops_.push_back({ stop.subject, EnclosedVector<Real>(stop.direction), Enclosed<Real>(stop.minus_least) });
  }

  template <class Place, class Visitor>
  void visit(const Place& place, Visitor& visitor) const
  {
    for (const Stop& stop : stops_)
    {
      const AffineForm<Real> above = dot(stop.direction, place.forms.legs[stop.subject.leg].row) + stop.minus_least;
      visitor.scalar(stop.subject, above, 1);
    }
  }

  Real margin(const NearPlace<Real>& place) const
  {
    using std::min;
    Real least(NO_MARGIN);
    for (const Stop& stop : stops_)
      least = min(least, (dot(stop.direction.value, place.at.legs[stop.subject.leg].row) + stop.minus_least.value) *
                             place.per_length);
    return least;
  }

private:
  template <class>
  friend class HingeLimits;

  struct Stop
  {
    Subject subject;
    EnclosedVector<Real> direction;
    Enclosed<Real> minus_least;
  };

  /// A stop at an angle is as far out as the strut is long; its axes turn with a rail that is not as it was meant.
  static Interval leastOf(const StrutStop& stop, const Leg& leg)
  {
    const StrutTolerance& by = toleranceOf(leg);
    if (by.isZero())
      return stop.least;
    const SlidingStrut& strut = slidingStrut(leg);
    const Interval stretch = Interval(by.length) / strut.length;
    const Interval turn = Interval(by.direction) * (strut.length + Interval(by.length)) * norm(stop.direction);
    const double more = (abs(stop.least) * stretch + turn).upper();
    return by.length > 0.0 || by.direction > 0.0 ? stop.least + Interval(-more, more) : stop.least;
  }

  static ConditionKind kindOf(const StrutStop& stop)
  {
    return stop.is_upper ? ConditionKind::HINGE_UPPER : ConditionKind::HINGE_LOWER;
  }

  std::vector<Stop> stops_;
};
}  // namespace pkm_workspace
