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
  const SineCosine half(Interval((angles - Interval(middle)).magnitude()));
  const Interval sine = withinOne(half.sine);
  const double least = withinOne(half.cosine).lower();
  const double shrunk = 0.5 * (1.0 + least);  // in the middle of what cos(x) may be
  const double bend =
      std::max((Interval(1.0) - Interval(shrunk)).upper(), (Interval(shrunk) - Interval(least)).upper());
  const IntervalMatrix to_middle = rotationsAboutZ(Interval(middle));
  places_ = turnedAboutZ(points, middle);
  std::vector<IntervalVector> sweeps;
  for (std::size_t k = 0; k < points.size(); ++k)
  {
    for (Eigen::Vector3d* part : { &places_[k].fixed, &places_[k].per_size })
      part->head<2>() *= shrunk;
    const IntervalVector a = to_middle * encloseAt(points[k], size);
    const IntervalVector rest = Interval(shrunk) * a - encloseAt(places_[k], size);
    const auto sweep = [&](const Interval& across, std::size_t j) {
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
}  // namespace pkm_workspace
