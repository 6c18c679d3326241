// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/machine/tolerated_strut.h"

#include <Eigen/Geometry>
#include <algorithm>

namespace pkm_workspace
{
namespace
{
/// Covers the roundings of some dozens of operations on numbers of that size.
double roundedUp(const Interval& x)
{
  return (x * Interval(1.0 + 0x1p-40)).upper();
}

/// Two directions across a unit vector and across each other, rounded.
std::array<Eigen::Vector3d, 2> directionsAcross(const Eigen::Vector3d& axis)
{
  const Eigen::Vector3d first = axis.unitOrthogonal();
  return { first, axis.cross(first).normalized() };
}

/// The slopes of c = a - b, and what its coordinates are made of.
void spreadCenter(const SlidingStrut& strut, StrutSpread& spread)
{
  const StrutTolerance& by = strut.tolerance;
  const Interval ball = Interval(by.slider_ball) + Interval(by.platform_ball);
  Interval sum(0.0);
  for (std::size_t j = 0; j < 3; ++j)
  {
    const Interval box = Interval(by.slider[j]) + Interval(by.platform[j]);
    const double reach = (box + ball).upper();
    for (std::size_t k = 0; k < 3; ++k)
    {
      spread.center_slopes[j][k] = reach * by.axes[k][j].mid();
      sum += Interval(reach) * (Interval(by.axes[k][j].radius()) + Interval(0x1p-45));
    }
    spread.set.box[j] = reach > 0.0 ? (box / Interval(reach)).mid() : 0.0;
    spread.set.ball[j] = reach > 0.0 ? (ball / Interval(reach)).mid() : 0.0;
  }
  // a joint value that is wrong by z is that of a slider that is z back on its rail
  for (std::size_t k = 0; k < 3; ++k)
    spread.center_slopes[3][k] = -by.zero * strut.axis[k].mid();
  sum += Interval(by.zero) * (Interval(by.direction) + Interval(0x1p-45));
  for (const Interval& component : strut.axis)
    sum += Interval(by.zero) * Interval(component.radius());
  spread.center_error = roundedUp(sum);
}

/// Rails within an angle t of e: (e + x) / |e + x| with x across e and |x| <= tan t, which is e + x but for less than
/// 1 / cos t - 1.
void spreadAxis(const SlidingStrut& strut, StrutSpread& spread)
{
  const double angle = strut.tolerance.direction;
  const Interval tangent = sin(angle) / cos(angle);
  const auto across = directionsAcross(mid(strut.axis));
  Interval uncertain(0x1p-45);
  for (const Interval& component : strut.axis)
    uncertain += Interval(4.0 * component.radius());
  for (std::size_t j = 0; j < 2; ++j)
    for (std::size_t k = 0; k < 3; ++k)
      spread.axis_slopes[j][k] = tangent.mid() * across[j][static_cast<Eigen::Index>(k)];
  spread.axis_error = roundedUp(Interval(1.0) / cos(angle) - Interval(1.0) + tangent * uncertain);
}

void spreadLength(const SlidingStrut& strut, StrutSpread& spread)
{
  const Interval by(strut.tolerance.length);
  const Interval half_square = Interval(0.5) * sqr(by);
  const Interval slope = Interval(2.0) * strut.length * by;
  const Interval center = sqr(strut.length) + half_square;
  spread.squared_length_slope = slope.mid();
  spread.squared_length = { center.mid(),
                            roundedUp(Interval(center.radius()) + half_square + Interval(slope.radius())) };
}
}  // namespace

StrutSpread spreadOf(const SlidingStrut& strut)
{
  SlidingStrut nominal = strut;
  nominal.tolerance = {};
  StrutSpread spread;
  spread.nominal = ofForms<double>(enclosed(nominal));
  spreadCenter(strut, spread);
  spreadAxis(strut, spread);
  spreadLength(strut, spread);
  return spread;
}
}  // namespace pkm_workspace
