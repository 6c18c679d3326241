// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/interval/turning.h"

#include <algorithm>
#include <cmath>

#include "pkm_workspace/interval/curve.h"

namespace pkm_workspace
{
namespace
{
/// A sine or a cosine is no larger.
Interval withinOne(const Enclosed<double>& x)
{
  return intersection(Interval(x.lower(), x.upper()), Interval(-1.0, 1.0));
}

/// Of the angles x in [-d, d] that angles are from their middle.
struct HalfTurn
{
  explicit HalfTurn(const Interval& angles)
  {
    const SineCosine half(Interval((angles - Interval(angles.mid())).magnitude()));
    sine = withinOne(half.sine);
    const double least = withinOne(half.cosine).lower();
    shrunk = 0.5 * (1.0 + least);
    bend = std::max((Interval(1.0) - Interval(shrunk)).upper(), (Interval(shrunk) - Interval(least)).upper());
  }

  Interval sine;  ///< of d
  double shrunk;  ///< in the middle of what cos(x) may be
  double bend;    ///< how far that may be from it
};
}  // namespace

IntervalMatrix rotationsAboutZ(const Interval& angles)
{
  const SineCosine turn(angles);
  const Interval s = withinOne(turn.sine);
  const Interval c = withinOne(turn.cosine);
  return { IntervalVector{ c, -s, 0.0 }, IntervalVector{ s, c, 0.0 }, IntervalVector{ 0.0, 0.0, 1.0 } };
}

Eigen::Vector3d turnedAboutZ(const Eigen::Vector3d& offset, double angle)
{
  const double s = std::sin(angle);
  const double c = std::cos(angle);
  return { c * offset.x() - s * offset.y(), s * offset.x() + c * offset.y(), offset.z() };
}

std::vector<GrowingVector> turnedAboutZ(const std::vector<GrowingVector>& offsets, double angle)
{
  std::vector<GrowingVector> turned;
  turned.reserve(offsets.size());
  for (const GrowingVector& offset : offsets)
    turned.push_back({ turnedAboutZ(offset.fixed, angle), turnedAboutZ(offset.per_size, angle) });
  return turned;
}

AffineForm<double> TurningForm::overCenters() const
{
  AffineForm<double> whole = form;
  whole.radius = affine::widened(form.radius + turn.magnitude(), form.magnitude(), 4);
  return whole;
}

TurningForm operator+(const TurningForm& a, const TurningForm& b)
{
  return { a.form + b.form, a.turn + b.turn };
}

TurningForm operator*(const Enclosed<double>& s, const TurningForm& f)
{
  return { s * f.form, s * f.turn };
}

TurningBox::TurningBox(const Box& centers, const Interval& angles, double size,
                       const std::vector<GrowingVector>& points)
  : box_(centers), sweeps_(points.size())
{
  const double middle = angles.mid();
  const auto [sine, shrunk, bend] = HalfTurn(angles);
  const IntervalMatrix to_middle = rotationsAboutZ(Interval(middle));
  places_ = turnedAboutZ(points, middle);
  std::vector<IntervalVector> sweeps;
  for (std::size_t k = 0; k < points.size(); ++k)
  {
    for (Eigen::Vector3d* part : { &places_[k].fixed, &places_[k].per_size })
      part->head<2>() *= shrunk;
    const IntervalVector a = to_middle * encloseAt(points[k], size);
    const IntervalVector rest = Interval(shrunk) * a - encloseAt(places_[k], size);
    const auto sweep = [&, &sine = sine, &bend = bend](const Interval& across, std::size_t j) {
      const double most = (Interval(rest[j].magnitude()) + Interval(bend) * Interval(a[j].magnitude())).upper();
      return sine * across + Interval(-most, most);
    };
    sweeps.push_back({ sweep(-a[1], 0), sweep(a[0], 1), 0.0 });
  }
  widenBy(sweeps);
}

/// @param sweeps how far places leave the center's box, for tau = 1
void TurningBox::widenBy(const std::vector<IntervalVector>& sweeps)
{
  for (std::size_t j = 0; j < 3; ++j)
  {
    double widest = 0.0;
    for (const IntervalVector& sweep : sweeps)
      widest = std::max(widest, sweep[j].magnitude());
    const Interval own(box_.half_widths[j]);
    box_.half_widths[j] = widest > 0.0 ? (own + Interval(widest)).upper() : own.upper();
    const Interval whole(box_.half_widths[j]);
    share_[j] = widest > 0.0 ? Enclosed<double>(own / whole) : Enclosed<double>(1.0, 0.0);
    for (std::size_t k = 0; k < sweeps.size() && widest > 0.0; ++k)
      sweeps_[k][j] = Enclosed<double>(sweeps[k][j] / whole);
  }
}

TurningForm TurningBox::formOf(std::size_t k, const AffineForm<double>& over_box) const
{
  TurningForm result{ over_box, {} };
  for (std::size_t j = 0; j < 3; ++j)
  {
    const Enclosed<double> slope(over_box.gradient[j], 0.0);
    const Enclosed<double> of_center = slope * share_[j];
    result.form.gradient[j] = of_center.value;
    result.form.radius += of_center.radius;
    result.turn = result.turn + slope * sweeps_[k][j];
  }
  result.form.radius = affine::widened(result.form.radius, over_box.magnitude(), 4);
  return result;
}

std::array<double, 3> TurningBox::deltaOf(std::size_t k, const std::array<double, 3>& center, double turn) const
{
  std::array<double, 3> delta;
  for (std::size_t j = 0; j < 3; ++j)
    delta[j] = share_[j].value * center[j] + sweeps_[k][j].value * turn;
  return delta;
}
TurningOffset::TurningOffset(const Box& centers, const Interval& angles, const Eigen::Vector3d& point)
{
  const HalfTurn half(angles);
  const CenteredBox<double> box(centers);
  const IntervalMatrix back = rotationsAboutZ(-Interval(angles.mid()));
  const IntervalVector middle = back * (IntervalVector{ box.center[0], box.center[1], box.center[2] } - enclose(point));
  for (std::size_t j = 0; j < 3; ++j)
  {
    // beside row j is the one that the turn brings in: y for x, and -x for y
    const std::size_t beside = j == 0 ? 1 : 0;
    const Interval sign = j == 0 ? 1.0 : j == 1 ? -1.0 : 0.0;
    const Interval shrunk = j < 2 ? Interval(half.shrunk) : Interval(1.0);
    const Interval bend = j < 2 ? Interval(half.bend) : Interval(0.0);
    TurningForm& coordinate = coordinates_[j];
    Interval radius = bend * abs(middle[j]);
    coordinate.form = AffineForm<double>{} + Enclosed<double>(shrunk * middle[j]);
    for (std::size_t k = 0; k < 3; ++k)
    {
      const Interval width(box.half_widths[k]);
      AffineForm<double> edge;
      edge.gradient[k] = 1.0;
      coordinate.form = coordinate.form + Enclosed<double>(shrunk * back[j][k] * width) * edge;
      radius += (bend * abs(back[j][k]) + half.sine * abs(sign * back[beside][k])) * width;
    }
    coordinate.form.radius = affine::widened(coordinate.form.radius + radius.upper(), radius.upper(), 4);
    coordinate.turn = Enclosed<double>(half.sine * sign * middle[beside]);
    box_.lower[static_cast<int>(j)] = coordinate.lower();
    box_.upper[static_cast<int>(j)] = coordinate.upper();
  }
  const Interval upward = centers.side(2) - Interval(point.z());  // exactly 0 for bodies without height
  box_.lower.z() = upward.lower();
  box_.upper.z() = upward.upper();
}

TurningForm TurningOffset::formOf(const AffineForm<double>& over_box) const
{
  const CenteredBox<double> box(box_);
  TurningForm sum;
  sum.form.radius = over_box.radius;
  sum.form = sum.form + Enclosed<double>(over_box.center, 0.0);
  for (std::size_t j = 0; j < 3; ++j)
  {
    if (over_box.gradient[j] == 0.0)
      continue;
    const Enclosed<double> slope(Interval(over_box.gradient[j]) / Interval(box.half_widths[j]));
    TurningForm beside = coordinates_[j];
    beside.form = beside.form + Enclosed<double>(-box.center[j], 0.0);
    sum = sum + slope * beside;
  }
  return sum;
}
}  // namespace pkm_workspace
