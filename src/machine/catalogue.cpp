// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/machine/catalogue.h"

#include <cmath>
#include <stdexcept>

#include "pkm_workspace/interval/decimal.h"
#include "pkm_workspace/interval/text_stream.h"

namespace pkm_workspace
{
namespace
{
/// What follows from the length is an ordinary number then.
void requireLength(double length)
{
  if (!(length >= 1e-9 && length <= 1e9))
    throw std::invalid_argument("strut length L = " + exact(length) + " m must be from 1e-9 m to 1e9 m");
}
}  // namespace

Machine orthoglide(double length)
{
  requireLength(length);
  Machine::Legs legs;
  const char* const joints[] = { "rail_x", "rail_y", "rail_z" };
  for (std::size_t i = 0; i < 3; ++i)
  {
    SlidingStrut strut;
    strut.axis = { 0.0, 0.0, 0.0 };
    strut.axis[i] = 1.0;
    strut.origin = Interval(-length) * strut.axis;
    strut.platform = { 0.0, 0.0, 0.0 };
    strut.length = length;
    legs[i] = { joints[i], Interval::entire(), strut };
  }
  return Machine("orthoglide", legs, Eigen::Vector3d::Zero());
}

Machine orthoglidePrototype()
{
  const double length = 0.31058;
  // for L = 1 the largest cube reaches from -1/(3 sqrt 2) to 1/sqrt 6 in each axis: its center is half their sum
  const double center = 0.5 * length * (1.0 / std::sqrt(6.0) - 1.0 / (3.0 * std::sqrt(2.0)));
  const double lower = center - 0.1;  // where the strut lies along its rail
  const double upper = center + 0.1;
  const double last = upper + length - std::sqrt(length * length - 2.0 * upper * upper);
  Machine::Legs legs = orthoglide(length).legs();
  for (Leg& leg : legs)
    leg.limits = Interval(std::floor(lower * 1e4) / 1e4, std::ceil(last * 1e4) / 1e4);
  return Machine("orthoglide_prototype", legs, Eigen::Vector3d::Zero());
}

Machine uranesx(const Interval& rail_radius, const Interval& platform_radius, double length)
{
  requireLength(length);
  const Interval offset = rail_radius - platform_radius;
  if (!offset.certainlyPositive() || !(offset.upper() < length))
  {
    TextStream text;
    text << "R - r = " << offset << " m must lie between 0 and the strut length L = " << length << " m";
    throw std::invalid_argument(text.str());
  }
  const Interval half = Interval(1.0) / Interval(2.0);
  const Interval sine = sqrt(Interval(3.0)) * half;
  const IntervalVector directions[] = { { 1.0, 0.0, 0.0 }, { -half, sine, 0.0 }, { -half, -sine, 0.0 } };
  Machine::Legs legs;
  for (std::size_t i = 0; i < 3; ++i)
  {
    SlidingStrut strut;
    strut.axis = { 0.0, 0.0, 1.0 };
    strut.origin = rail_radius * directions[i];
    strut.platform = platform_radius * directions[i];
    strut.length = length;
    strut.working_mode = -1;
    legs[i] = { "rail_" + std::to_string(i + 1), Interval::entire(), strut };
  }
  const double depth = sqrt(sqr(Interval(length)) - sqr(offset)).mid();
  return Machine("uranesx", legs, Eigen::Vector3d(0.0, 0.0, -depth));
}

Machine uranesx()
{
  return uranesx(Interval(7.0) / Interval(13.0), Interval(3.0) / Interval(26.0));
}
}  // namespace pkm_workspace
