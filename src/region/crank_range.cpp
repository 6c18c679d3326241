// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "leg_range.h"
#include "pkm_workspace/machine/crank_forms.h"
#include "region_distance.h"

namespace pkm_workspace
{
namespace
{
using Eigen::Vector3d;

/// By how much the crank is turned at a time until it is past the region [rad], and how often an end is halved.
constexpr double STEP = 0.02;
constexpr int HALVINGS = 60;
constexpr double NEXT = 1e-6;  ///< to where the crank was turned [rad]

/// One crank over one region. As the crank turns towards s (its way along the forearm), the distance from its tip to a
/// point p falls through L at the angle th(p) of p, and rises through L at that of the other working mode. So for an
/// angle t between the two of every p:
///   th(p) <= t for all p (in the sense of s) where no point of the region is farther than L from the tip at t,
///   th(p) >= t for all p                     where none is nearer.
/// The distances' extremes over a convex region are known in closed form (RegionDistance).
class CrankOverRegion
{
public:
  CrankOverRegion(const EnclosedCrank& crank, const PlacedShape& region)
    : crank_(crank), distance_(region), sense_(crank.sign.mid()), start_(angleAt(enclose(region.center)))
  {}

  /// Encloses the last angle in the sense of s.
  Interval last() const
  {
    const double t = settle(
        sense_, [this](double angle) { return crank_.length.lower() - distance_.largest(tipAt(angle)).upper(); });
    return between(t, distance_.farthestPoint(mid(tipAt(inRange(t)))));
  }
  /// Encloses the first one.
  Interval first() const
  {
    const double t =
        settle(-sense_, [this](double angle) { return distance_.least(tipAt(angle)).lower() - crank_.length.upper(); });
    return between(t, distance_.nearestPoint(mid(tipAt(inRange(t)))));
  }

private:
  /// The tip at an angle from the reference, less the platform point.
  IntervalVector tipAt(double angle) const
  {
    return crank_.center + crank_.radius * (cos(angle) * crank_.u + sin(angle) * crank_.v);
  }

  /// The angle at p, from the reference.
  Interval angleAt(const IntervalVector& p) const
  {
    LegState<Interval, IntervalVector> state;
    evaluate(crank_, p, sqrtAboveZero, state);
    if (state.squared_drive.upper() < 0.0)
      throw std::domain_error("joint ranges: a forearm does not reach part of the region");
    const auto [along, across] = tipOf(crank_, p, state);
    return angleOf(along, across);
  }

  double inRange(double t) const { return std::isfinite(t) ? t : start_.mid(); }

  /// An angle in this direction from the start where the excess is proved not to be negative, near to where it begins
  /// to be; infinite where there is none within a half turn.
  template <class Excess>
  double settle(double direction, const Excess& excess) const
  {
    double before = start_.mid();
    double past = before;
    while (excess(past) < 0.0)
    {
      before = past;
      past += direction * STEP;
      if (std::abs(past - start_.mid()) > pi().lower())
        return direction * INF;
    }
    for (int k = 0; k < HALVINGS; ++k)
    {
      const double middle = 0.5 * (before + past);
      (excess(middle) < 0.0 ? before : past) = middle;
    }
    return past;
  }

  /// From the angle at a point of the region to t, which is beyond. Where the region is on both sides of the angle pi,
  /// angles go on over it: the point's is the one next to t. Where it has none there, the middle's is one that is
  /// taken.
  Interval between(double t, const IntervalVector& point) const
  {
    // a convex region that the leg reaches is on one side of the crank's axis, as seen from there within half a turn,
    // and the crank is within half a turn of that
    if (!std::isfinite(t))
      return crank_.reference + hull(start_, start_ + Interval(t > 0.0 ? 2.0 : -2.0) * pi());
    const Interval angle = angleAt(point);
    const double turns = std::round((t - angle.mid()) / (2.0 * pi().mid()));
    const Interval attained = angle + Interval(2.0 * turns) * pi();
    const bool is_next = (attained - Interval(t)).magnitude() < NEXT;
    return crank_.reference + hull(is_next ? attained : start_, t);
  }

  EnclosedCrank crank_;
  RegionDistance distance_;
  double sense_;
  Interval start_;
};
}  // namespace

JointRange rangeOver(const EnclosedCrank& leg, const PlacedShape& region)
{
  const CrankOverRegion over(leg, region);
  const bool positive = leg.sign.lower() > 0.0;
  JointRange range;
  range.lower = positive ? over.first() : over.last();
  range.upper = positive ? over.last() : over.first();
  range.stroke = intersection(range.upper - range.lower, Interval(0.0, INF));
  range.across = Interval(0.0);
  return range;
}
}  // namespace pkm_workspace
