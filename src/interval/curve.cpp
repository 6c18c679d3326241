// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/interval/curve.h"

#include <algorithm>
#include <cmath>

namespace pkm_workspace
{
namespace
{
using Number = Enclosed<double>;

/// sin y and cos y for |y| <= 0.8 by Taylor's series to y^17 and y^16, of which the rest is below 3e-18. From one line
/// of the sum to the next errors shrink by z / n < 1/3, so that four roundings of numbers up to 1 bound them all.
double sineSeries(double y)
{
  const double z = y * y;
  double sum = 1.0;
  for (const double n : { 272.0, 210.0, 156.0, 110.0, 72.0, 42.0, 20.0, 6.0 })
    sum = 1.0 - z / n * sum;
  return y * sum;
}
double cosineSeries(double y)
{
  const double z = y * y;
  double sum = 1.0;
  for (const double n : { 240.0, 182.0, 132.0, 90.0, 56.0, 30.0, 12.0, 2.0 })
    sum = 1.0 - z / n * sum;
  return sum;
}
constexpr double SERIES_REST = 3e-18;

/// pi / 2 as a double and an enclosure of what it lacks.
constexpr double HALF_PI = 0x1.921fb54442d18p+0;
const Interval HALF_PI_REST(0x1.1a62633145c06p-54, 0x1.1a62633145c07p-54);

Number number(const EnclosedVector<double>& v, std::size_t k)
{
  return { v.value[k], v.radius };
}

/// center + delta_0 first + delta_1 second + delta_2 third in one coordinate of a box.
void put(std::size_t k, const Number& center, const Number& first, const Number& second, const Number& third,
         SkewBox<double>& box)
{
  box.center[k] = center.value;
  box.edges[k] = { first.value, second.value, third.value };
  const double radius = center.radius + first.radius + second.radius + third.radius;
  box.slack = std::max(box.slack, affine::widened(radius, 0.0, 0));
}
}  // namespace

SineCosine::SineCosine(const Interval& angle)
{
  const double quarters = std::round(angle.mid() / HALF_PI);  // in every rounding mode
  const Interval y = (angle - Interval(quarters) * Interval(HALF_PI)) - Interval(quarters) * HALF_PI_REST;
  const double middle = y.mid();
  if (!(std::abs(middle) <= 0.8))  // so many turns that doubles do not tell the rest
  {
    sine = cosine = { 0.0, 1.0 };
    return;
  }
  const double error = affine::widened(y.radius() + SERIES_REST, 1.0, 4);
  const int quadrant = static_cast<int>(quarters - 4.0 * std::floor(quarters / 4.0));
  const double s = sineSeries(middle);
  const double c = cosineSeries(middle);
  constexpr int SIGNS[] = { 1, 1, -1, -1 };
  sine = { SIGNS[quadrant] * (quadrant % 2 == 0 ? s : c), error };
  cosine = { SIGNS[(quadrant + 1) % 4] * (quadrant % 2 == 0 ? c : s), error };
}

Curve::Curve(const IntervalVector& origin, const IntervalVector& drift, const IntervalVector& u,
             const IntervalVector& w, const Interval& angle)
  : origin_(origin)
  , drift_(drift)
  , u_(u)
  , w_(w)
  , angle_(angle)
  , length_(sqrt(squaredNorm(drift) + sqr(angle) * squaredNorm(u)))
{
  setDirection(drift);
  if (length_.certainlyPositive())
    turning_ = Number(angle * (Interval(1.0) / length_));
}

/// Paths have thousands of lines: nothing is worked out here of what turns.
Curve::Curve(const Eigen::Vector3d& start, const IntervalVector& drift)
  : drift_(drift), angle_(0.0), length_(sqrt(squaredNorm(drift)))
{
  origin_.value = { start.x(), start.y(), start.z() };
  u_.value = w_.value = { 0.0, 0.0, 0.0 };
  setDirection(drift);
}

Curve Curve::line(const Eigen::Vector3d& start, const Eigen::Vector3d& end)
{
  return Curve(start, enclose(end) - enclose(start));
}

void Curve::setDirection(const IntervalVector& drift)
{
  drift_direction_.value = { 0.0, 0.0, 0.0 };
  if (length_.certainlyPositive())
    drift_direction_ = EnclosedVector<double>((Interval(1.0) / length_) * drift);
  else if (length_.upper() > 0.0)
    drift_direction_.radius = 1.0;  // any direction
}

Curve::Turn::Turn(const Interval& angle, const Interval& half_angle) : middle(angle)
{
  const Number one(1.0, 0.0);
  const Number half(0.5, 0.0);
  const double b = half_angle.magnitude();
  if (b > 3.0)  // all directions
  {
    center = Number();
    radial = one;
    along = Number();
    bend = 1.0;
    return;
  }
  const SineCosine ends(half_angle);
  center = half * (one + ends.cosine);
  radial = half * (one + -ends.cosine);
  along = ends.sine;
  bend = affine::widened(b * b * b / 15.0, b * b * b, 8);  // 9 sqrt 3 > 15
}

Curve::Middle::Middle(double first, double last)
  : t(0.5 * first + 0.5 * last)
  , h(std::max((Interval(last) - Interval(t)).upper(), (Interval(t) - Interval(first)).upper()))
{}

CurvePiece Curve::piece(double first, double last) const
{
  const auto [t, h] = Middle(first, last);
  return angle_ == Interval(0.0) ? straightPiece(t, h) : turningPiece(t, h);
}

CurvePiece Curve::straightPiece(double t, double h) const
{
  const Number middle(t, 0.0);
  const Number half(h, 0.0);
  CurvePiece piece;
  for (std::size_t k = 0; k < 3; ++k)
  {
    const Number drift = number(drift_, k);
    put(k, number(origin_, k) + middle * drift + number(u_, k), half * drift, Number(), Number(), piece.points);
    put(k, number(drift_direction_, k), Number(), Number(), Number(), piece.tangents);
  }
  return piece;
}

CurvePiece Curve::turningPiece(double t, double h) const
{
  const Turn turn(angle_ * Interval(t), angle_ * Interval(h));
  const Number middle(t, 0.0);
  const Number half(h, 0.0);
  const Number bend(turn.bend, 0.0);
  CurvePiece piece;
  for (std::size_t k = 0; k < 3; ++k)
  {
    const Number drift = number(drift_, k);
    const Number direction = number(drift_direction_, k);
    const Number start = number(origin_, k) + middle * drift;
    const Number radius = turn.middle.cosine * number(u_, k) + turn.middle.sine * number(w_, k);
    const Number tangent = turn.middle.cosine * number(w_, k) + -(turn.middle.sine * number(u_, k));
    put(k, start + turn.center * radius, half * drift + turn.along * tangent, turn.radial * radius, bend * tangent,
        piece.points);
    const Number per_length = turning_ * tangent;
    const Number inward = -(turning_ * radius);
    put(k, direction + turn.center * per_length, turn.along * inward, turn.radial * per_length, bend * inward,
        piece.tangents);
  }
  return piece;
}

/// Inward, with the square of what the direction turns.
SkewBox<double> Curve::curvatures(double first, double last) const
{
  SkewBox<double> box{};
  if (angle_ == Interval(0.0))
    return box;
  if (!length_.certainlyPositive() && length_.upper() > 0.0)
  {
    box.slack = INF;
    return box;
  }
  const auto [t, h] = Middle(first, last);
  const Turn turn(angle_ * Interval(t), angle_ * Interval(h));
  const Number bend(turn.bend, 0.0);
  const Number inward = -(turning_ * turning_);
  for (std::size_t k = 0; k < 3; ++k)
  {
    const Number radius = inward * (turn.middle.cosine * number(u_, k) + turn.middle.sine * number(w_, k));
    const Number tangent = inward * (turn.middle.cosine * number(w_, k) + -(turn.middle.sine * number(u_, k)));
    put(k, turn.center * radius, turn.along * tangent, turn.radial * radius, bend * tangent, box);
  }
  return box;
}

IntervalVector Curve::point(double t) const
{
  const SkewBox<double> box = piece(t, t).points;
  IntervalVector result;
  for (std::size_t k = 0; k < 3; ++k)
  {
    const AffineForm<double> form = coordinate(box, k);
    result[k] = Interval(form.lower(), form.upper());
  }
  return result;
}
}  // namespace pkm_workspace
