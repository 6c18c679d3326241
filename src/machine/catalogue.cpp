// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/machine/catalogue.h"

#include <cmath>
#include <initializer_list>
#include <stdexcept>
#include <utility>

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

/// Outward in the plane z = 0: at 0, 120 and 240 degrees.
std::array<IntervalVector, 3> threeDirections()
{
  const Interval half = Interval(1.0) / Interval(2.0);
  const Interval sine = sqrt(Interval(3.0)) * half;
  return { IntervalVector{ 1.0, 0.0, 0.0 }, IntervalVector{ -half, sine, 0.0 }, IntervalVector{ -half, -sine, 0.0 } };
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
  const auto directions = threeDirections();
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

namespace
{
void requireLengths(const std::initializer_list<std::pair<const char*, Interval>>& lengths)
{
  for (const auto& [name, length] : lengths)
    if (!(length.lower() >= 1e-9 && length.upper() <= 1e9))
      throw std::invalid_argument(std::string(name) + " = " + exact(length.mid()) + " m must be from 1e-9 m to 1e9 m");
}

/// How far the platform is from the plane of a machine's base. @param across what a strut of that length spans there
double heightOf(const Interval& length, const Interval& across)
{
  if (!(across.magnitude() < length.lower()))
    throw std::invalid_argument("at zero the legs span " + exact(across.magnitude()) +
                                " m across, which must be less than their length " + exact(length.mid()) + " m");
  return sqrt(sqr(Interval(length.mid())) - sqr(Interval(across.mid()))).mid();
}
}  // namespace

Machine delta(const DeltaDimensions& dimensions)
{
  requireLengths({ { "base radius", dimensions.base_radius },
                   { "crank", dimensions.crank },
                   { "forearm", dimensions.forearm },
                   { "platform radius", dimensions.platform_radius } });
  const auto directions = threeDirections();
  Machine::Legs legs;
  for (std::size_t i = 0; i < 3; ++i)
  {
    Crank crank;
    crank.pivot = dimensions.base_radius * directions[i];
    crank.along = directions[i];
    crank.across = { 0.0, 0.0, -1.0 };
    crank.radius = dimensions.crank;
    crank.platform = dimensions.platform_radius * directions[i];
    crank.length = dimensions.forearm;
    legs[i] = { "crank_" + std::to_string(i + 1), dimensions.limits, crank };
  }
  const Interval across = dimensions.base_radius + dimensions.crank - dimensions.platform_radius;
  return Machine("delta", legs, Eigen::Vector3d(0.0, 0.0, -heightOf(dimensions.forearm, across)));
}

Machine tripod(const TripodDimensions& dimensions)
{
  requireLengths({ { "base radius", dimensions.base_radius },
                   { "platform radius", dimensions.platform_radius },
                   { "length", dimensions.length } });
  const auto directions = threeDirections();
  Machine::Legs legs;
  for (std::size_t i = 0; i < 3; ++i)
  {
    TelescopicStrut strut;
    strut.foot = dimensions.base_radius * directions[i];
    strut.platform = dimensions.platform_radius * directions[i];
    strut.length = dimensions.length;
    legs[i] = { "strut_" + std::to_string(i + 1), dimensions.limits, strut };
  }
  const Interval across = dimensions.base_radius - dimensions.platform_radius;
  return Machine("tripod", legs, Eigen::Vector3d(0.0, 0.0, heightOf(dimensions.length, across)));
}

Machine mixedLegs()
{
  Machine::Legs legs = orthoglide().legs();
  legs[0].limits = { -0.5, 0.8 };
  TelescopicStrut strut;
  strut.foot = { 0.0, -1.0, 0.0 };
  strut.platform = { 0.0, 0.0, 0.0 };
  legs[1] = { "strut_y", { -0.4, 0.4 }, strut };
  Crank crank;
  crank.pivot = { -0.5, 0.0, -1.0 };
  crank.along = { 1.0, 0.0, 0.0 };
  crank.across = { 0.0, 0.0, 1.0 };
  crank.radius = 0.5;
  crank.platform = { 0.0, 0.0, 0.0 };
  legs[2] = { "crank_z", { -1.2, 1.2 }, crank };
  return Machine("mixed_legs", legs, Eigen::Vector3d::Zero());
}

Machine uranesx()
{
  return uranesx(Interval(7.0) / Interval(13.0), Interval(3.0) / Interval(26.0));
}
}  // namespace pkm_workspace
