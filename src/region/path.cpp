// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/region/path.h"

#include <Eigen/Geometry>
#include <cmath>
#include <optional>
#include <stdexcept>

#include "pkm_workspace/interval/decimal.h"
#include "pkm_workspace/interval/text_stream.h"

namespace pkm_workspace
{
namespace
{
using Eigen::Vector3d;

/// A point to be told of.
struct Named
{
  const char* name;
  Vector3d point;
};

std::ostream& operator<<(std::ostream& stream, const Named& p)
{
  return stream << p.name << " (" << p.point.x() << ", " << p.point.y() << ", " << p.point.z() << ") m";
}

/// Collects what is wrong with the numbers of a segment.
class Checks
{
public:
  explicit Checks(const char* kind) : kind_(kind) {}

  Checks& point(const char* name, const Vector3d& p)
  {
    if (!(p.cwiseAbs().maxCoeff() <= FARTHEST) || !p.allFinite())
      add() << Named{ name, p } << " must be finite, within 1e9 m";
    return *this;
  }
  Checks& direction(const char* name, const Vector3d& v)
  {
    if (!v.allFinite() || !(v.cwiseAbs().maxCoeff() >= 1e-100) || !(v.cwiseAbs().maxCoeff() <= 1e100))
      add() << name << " (" << v.x() << ", " << v.y() << ", " << v.z() << ") must be finite and not 0";
    return *this;
  }
  Checks& number(const char* name, double value, double most, const char* unit)
  {
    if (!(std::abs(value) <= most))
      add() << name << " = " << value << ' ' << unit << " must be from " << -most << " to " << most << ' ' << unit;
    return *this;
  }
  std::ostream& add()
  {
    if (text_)
      return *text_ << '\n' << kind_ << ": ";
    text_.emplace();
    return *text_ << kind_ << ": ";
  }
  void throwIfAny() const
  {
    if (text_)
      throw std::invalid_argument(text_->str());
  }

private:
  const char* kind_;
  std::optional<TextStream> text_;  ///< a stream takes longer to make than a line: only for what is wrong
};

/// A circle about an axis, with the point that it starts at.
struct GivenCircle
{
  IntervalVector center;  ///< [m]
  IntervalVector axis;    ///< of length 1
  IntervalVector u;       ///< from the center to the start [m]
  IntervalVector w;       ///< a quarter on [m]

  Curve curve(const Interval& angle, const Interval& lift = Interval(0.0)) const
  {
    return Curve(center, lift == Interval(0.0) ? IntervalVector{} : lift * axis, u, w, angle);
  }
};

IntervalVector unit(const IntervalVector& v)
{
  return (Interval(1.0) / norm(v)) * v;
}

GivenCircle circleAbout(const Vector3d& start, const Vector3d& center, const Vector3d& axis, Checks& checks)
{
  GivenCircle circle;
  const double scale = std::ldexp(1.0, -std::ilogb(axis.cwiseAbs().maxCoeff()));  // a power of two rounds nothing
  circle.axis = unit(enclose(Vector3d(axis * scale)));
  const IntervalVector offset = enclose(start) - enclose(center);
  const Interval along = dot(offset, circle.axis);
  circle.center = enclose(center) + along * circle.axis;
  circle.u = offset - along * circle.axis;
  circle.w = cross(circle.axis, circle.u);
  if (!(norm(circle.u).lower() > 1e-12 * norm(offset).upper()))
    checks.add() << Named{ "start", start } << " lies on the axis";
  checks.throwIfAny();
  return circle;
}

/// The circle through three points (circumcenter of the triangle).
GivenCircle circleThrough(const Vector3d& start, const Vector3d& via, const Vector3d& end, Checks& checks)
{
  const IntervalVector b = enclose(via) - enclose(start);
  const IntervalVector c = enclose(end) - enclose(start);
  const IntervalVector normal = cross(b, c);
  const Interval square = squaredNorm(normal);
  const Interval square_b = squaredNorm(b);
  const Interval square_c = squaredNorm(c);
  const Interval least = sqr(Interval(ARC_LEAST_SINE)) * square_b * square_c;
  if (!(square.lower() > least.upper()))
    checks.add() << Named{ "start", start } << ", " << Named{ "via", via } << " and " << Named{ "end", end }
                 << " must be farther off a line: the sine of the angle at the start has to be more than "
                 << exact(ARC_LEAST_SINE);
  checks.throwIfAny();
  const IntervalVector to_center = cross(normal, square_c * b - square_b * c);
  const IntervalVector offset = (Interval(0.5) / square) * to_center;
  const IntervalVector axis = (Interval(1.0) / sqrt(square)) * normal;
  const IntervalVector u = { -offset[0], -offset[1], -offset[2] };
  return { enclose(start) + offset, axis, u, cross(axis, u) };
}

Interval asInterval(const Enclosed<double>& number)
{
  return Interval(number.value) + Interval(-number.radius, number.radius);
}

/// Encloses the angle in (0, 2 pi) from the start to the direction of the point: a guess, and the arc sine of what is
/// left.
Interval angleTo(const GivenCircle& circle, const Vector3d& end, Checks& checks)
{
  const IntervalVector offset = enclose(end) - circle.center;
  const Interval x = dot(offset, circle.u);
  const Interval y = dot(offset, circle.w);
  const Interval square = sqr(x) + sqr(y);
  if (!square.certainlyPositive() || (y.contains(0.0) && x.upper() > 0.0))
    checks.add() << Named{ "end", end } << " must be in another direction from the axis than the start";
  checks.throwIfAny();
  double guess = std::atan2(y.mid(), x.mid());
  guess += guess < 0.0 ? 2.0 * pi().mid() : 0.0;
  const SineCosine turn{ Interval(guess) };
  const double rest = ((y * asInterval(turn.cosine) - x * asInterval(turn.sine)) / sqrt(square)).magnitude();
  if (!(rest < 0.5))
    checks.add() << "the circle is too small beside its coordinates for doubles";
  checks.throwIfAny();
  return Interval(guess) + Interval(-2.0 * rest, 2.0 * rest);  // |asin x| <= 2 |x| for |x| < 0.9
}
}  // namespace

PathSegment PathSegment::line(const Vector3d& start, const Vector3d& end)
{
  Checks("line").point("start", start).point("end", end).throwIfAny();
  PathSegment segment(Curve::line(start, end));
  segment.ends_ = { start, end };
  return segment;
}

PathSegment PathSegment::arc(const Vector3d& start, const Vector3d& center, const Vector3d& axis, double angle,
                             double lift)
{
  Checks checks("arc");
  checks.point("start", start).point("center", center).direction("axis", axis);
  checks.number("angle", angle, ARC_LARGEST_ANGLE, "rad").number("lift", lift, FARTHEST, "m").throwIfAny();
  return PathSegment(circleAbout(start, center, axis, checks).curve(Interval(angle), Interval(lift)));
}

PathSegment PathSegment::circle(const Vector3d& start, const Vector3d& center, const Vector3d& axis)
{
  Checks checks("circle");
  checks.point("start", start).point("center", center).direction("axis", axis).throwIfAny();
  return PathSegment(circleAbout(start, center, axis, checks).curve(Interval(2.0) * pi()));
}

PathSegment PathSegment::arcThrough(const Vector3d& start, const Vector3d& via, const Vector3d& end)
{
  Checks checks("arc");
  checks.point("start", start).point("via", via).point("end", end).throwIfAny();
  const GivenCircle circle = circleThrough(start, via, end, checks);
  return PathSegment(circle.curve(angleTo(circle, end, checks)));
}

PathSegment PathSegment::arcTo(const Vector3d& start, const Vector3d& center, const Vector3d& axis, const Vector3d& end)
{
  if (start == end)
    return circle(start, center, axis);
  Checks checks("arc");
  checks.point("start", start).point("center", center).direction("axis", axis).point("end", end).throwIfAny();
  const GivenCircle circle = circleAbout(start, center, axis, checks);
  return endingAt(end, circle.curve(angleTo(circle, end, checks)), norm(circle.u).mid());
}

PathSegment PathSegment::helixTo(const Vector3d& start, const Vector3d& center, const Vector3d& axis,
                                 const Vector3d& end, int turns)
{
  Checks checks("arc");
  checks.point("start", start).point("center", center).direction("axis", axis).point("end", end);
  checks.number("turns", turns, ARC_LARGEST_ANGLE / 7.0, "").throwIfAny();
  const GivenCircle circle = circleAbout(start, center, axis, checks);
  const bool is_whole = Vector3d(end - start).cross(axis) == Vector3d::Zero();
  const Interval part = is_whole ? Interval(2.0) * pi() : angleTo(circle, end, checks);
  const Interval lift = dot(enclose(end) - enclose(start), circle.axis);
  const Interval angle = part + Interval(2.0 * (turns - 1)) * pi();
  return endingAt(end, circle.curve(angle, lift), norm(circle.u).mid());
}

PathSegment PathSegment::endingAt(const Vector3d& end, const Curve& curve, double radius)
{
  Checks checks("arc");
  const double mismatch = norm(curve.point(1.0) - enclose(end)).upper();
  if (!(mismatch <= ARC_MISMATCH))
    checks.add() << Named{ "end", end } << " is " << roundedUp(mismatch, 9)
                 << " m beside the circle through the start, of radius " << nearly(radius) << " m; allowed are "
                 << exact(ARC_MISMATCH) << " m";
  checks.throwIfAny();
  return PathSegment(curve);
}
}  // namespace pkm_workspace
