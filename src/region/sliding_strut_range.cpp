// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "circle_maximum.h"
#include "leg_range.h"
#include "pkm_workspace/machine/leg_forms.h"

namespace pkm_workspace
{
namespace
{
using Eigen::Vector3d;

/// Most steps of Newton's method, and of halving: both end much sooner, or where doubles end.
constexpr int NEWTON_STEPS = 100;
/// Where the search for the largest value over a circle ends: relative to the size, and to the strut.
constexpr double GAP = 1e-12;
constexpr double ROUNDING = 1e-14;

/// The convex functions that a strut gives.
enum class Function
{
  SIGNED_JOINT,    ///< s rho
  NEGATIVE_HEIGHT  ///< -|eta|
};

/// One strut. With w = s e, s rho = w . (p - c) - height, where height = |eta| = sqrt(L^2 - |q|^2) is a concave
/// function of p (a sphere swept along the rail): s rho and -height are convex.
class Strut
{
public:
  explicit Strut(const EnclosedStrut& strut) : strut_(strut), weight_(strut.sign * strut.axis) {}

  const Interval& length() const { return strut_.length; }
  Interval height(const IntervalVector& p) const { return strut_.sign * stateAt(p).drive; }
  Interval signedJoint(const IntervalVector& p) const { return strut_.sign * jointOf(strut_, p, stateAt(p)); }

  /// Encloses the largest value over a circle.
  Interval largest(Function function, const Circle& circle, double gap) const
  {
    LegState<Trigonometric, TrigonometricVector> state;
    evaluateAcross(strut_, circle, state);
    const Trigonometric linear =
        function == Function::SIGNED_JOINT ? dotOffset(weight_, strut_.center, circle) : Trigonometric();
    return largestOnCircle(linear, state.squared_drive, gap);
  }

  /// Encloses the least height over a ball: that at its point farthest from the rail.
  Interval leastHeight(const IntervalVector& center, const Interval& radius) const
  {
    return heightAt(strut_.length, distance(center) + radius);
  }
  /// Encloses the largest s rho over a ball: {s rho <= t} is a ball of radius L swept along a ray, and a smaller ball
  /// lies in it exactly when its center lies in one of radius L - r swept along that ray.
  Interval largestJoint(const IntervalVector& center, const Interval& radius) const
  {
    return dot(weight_, center - strut_.center) - heightAt(strut_.length - radius, distance(center));
  }

  /// Encloses the least s rho: the least t at which the region comes within the strut's length of c + t w. That
  /// distance is a convex function of t, whose value and slope the nearest point gives: Newton's method goes up to t.
  Interval leastJoint(const PlacedShape& region) const
  {
    const Vector3d w = mid(weight_);
    const Vector3d c = mid(strut_.center);
    const double length = strut_.length.mid();
    double t = region.leastAlong(enclose(w), strut_.center).lower() - length;
    double bound = -INF;
    Vector3d nearest = region.center;
    for (int k = 0; k < NEWTON_STEPS; ++k)
    {
      nearest = region.nearest(c + t * w);
      const Vector3d strut = nearest - (c + t * w);
      bound = std::max(bound, jointBound(strut, region));
      const double next = t + (strut.norm() - length) * strut.norm() / w.dot(strut);
      if (!(next > t))
        break;
      t = next;
    }
    const double value = signedJoint(region.pointNear(nearest)).upper();
    return { std::min(bound, value), value };
  }

  /// Encloses the largest height: that of the point nearest to the rail's line c + t w.
  Interval largestHeight(const PlacedShape& region) const
  {
    const Vector3d w = mid(weight_);
    const Vector3d c = mid(strut_.center);
    double low = region.leastAlong(enclose(w), strut_.center).lower();
    double high = -region.leastAlong(enclose(Vector3d(-w)), strut_.center).lower();
    const auto strutAt = [&](double t) { return Vector3d(region.nearest(c + t * w) - (c + t * w)); };
    for (int k = 0; k < NEWTON_STEPS; ++k)
    {
      const double t = 0.5 * low + 0.5 * high;
      (w.dot(strutAt(t)) > 0.0 ? low : high) = t;
    }
    const Vector3d strut = strutAt(high);
    const double value = height(region.pointNear(c + high * w + strut)).lower();
    const double bound = heightAt(strut_.length, Interval(distanceBound(strut, region))).upper();
    return { value, std::max(bound, value) };
  }

private:
  LegState<Interval, IntervalVector> stateAt(const IntervalVector& p) const
  {
    LegState<Interval, IntervalVector> state;
    evaluate(strut_, p, rootOf, state);
    return state;
  }
  /// |q|.
  Interval distance(const IntervalVector& p) const
  {
    LegState<Interval, IntervalVector> state;
    evaluateAcross(strut_, p, state);
    return norm(state.row);
  }

  /// @throws std::domain_error where the radicand is negative
  static Interval rootOf(const Interval& radicand)
  {
    if (radicand.upper() < 0.0)
      throw std::domain_error("joint ranges: a strut does not reach part of the region");
    return sqrtAboveZero(radicand);
  }
  /// Encloses sqrt(length^2 - distance^2).
  static Interval heightAt(const Interval& length, const Interval& distance)
  {
    return rootOf((length - distance) * (length + distance));
  }

  /// Bounds s rho from below. A strut d has n . d <= |n| L for any n, and d = (p - c) - s rho w: so
  /// s rho (n . w) >= n . (p - c) - |n| L, which is sharp for the n along the strut at the least s rho.
  double jointBound(const Vector3d& n, const PlacedShape& region) const
  {
    const Interval along = dot(enclose(n), weight_);
    if (!along.certainlyPositive())
      return -INF;
    return ((region.leastAlong(enclose(n), strut_.center) - norm(enclose(n)) * strut_.length) / along).lower();
  }
  /// Bounds the distance of the region from the rail's line from below: |Pn| |q| >= n . q = (Pn) . (p - c).
  double distanceBound(const Vector3d& n, const PlacedShape& region) const
  {
    const IntervalVector direction = strut_.projector * enclose(n);
    const double along = region.leastAlong(direction, strut_.center).lower();
    return along > 0.0 ? (Interval(along) / Interval(norm(direction).upper())).lower() : 0.0;
  }

  EnclosedStrut strut_;
  IntervalVector weight_;
};

/// Encloses the larger of two numbers.
Interval larger(const Interval& a, const Interval& b)
{
  return { std::max(a.lower(), b.lower()), std::max(a.upper(), b.upper()) };
}

/// Encloses the largest value over a polytope: a convex function takes it at a vertex.
Interval largestAtVertices(const Strut& strut, Function function, const PlacedShape& region)
{
  const auto at = [&](const IntervalVector& p) {
    return function == Function::SIGNED_JOINT ? strut.signedJoint(p) : -strut.height(p);
  };
  Interval most = at(enclose(region.center));
  for (const GrowingVector& k : region.shape.extremePoints())
    most = larger(most, at(region.vertex(k)));
  return most;
}

Interval largest(const Strut& strut, Function function, const PlacedShape& region)
{
  if (const auto radius = region.shape.ballRadius(region.size))
    return function == Function::SIGNED_JOINT ? strut.largestJoint(enclose(region.center), *radius)
                                              : -strut.leastHeight(enclose(region.center), *radius);
  const std::vector<Circle> circles = region.shape.extremeCircles(region.center, region.size);
  if (circles.empty())
    return largestAtVertices(strut, function, region);
  const double gap = GAP * region.size + ROUNDING * strut.length().upper();
  Interval most = strut.largest(function, circles.front(), gap);
  for (const Circle& circle : circles)
    most = larger(most, strut.largest(function, circle, gap));
  return most;
}

}  // namespace

JointRange rangeOver(const EnclosedStrut& leg, const PlacedShape& region)
{
  const Strut strut(leg);
  const Interval first = strut.leastJoint(region);
  const Interval last = largest(strut, Function::SIGNED_JOINT, region);
  const Interval least_height = -largest(strut, Function::NEGATIVE_HEIGHT, region);
  const bool positive = leg.sign.lower() > 0.0;
  const Interval not_negative(0.0, INF);
  JointRange range;
  range.lower = positive ? first : -last;
  range.upper = positive ? last : -first;
  range.stroke = intersection(range.upper - range.lower, not_negative);
  range.across = intersection(strut.largestHeight(region) - least_height, not_negative);
  return range;
}
}  // namespace pkm_workspace
