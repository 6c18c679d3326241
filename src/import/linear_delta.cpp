// SPDX-License-Identifier: BSD-3-Clause
#include "linear_delta.h"

#include <algorithm>
#include <cmath>

#include "pkm_workspace/interval/decimal.h"

namespace pkm_workspace
{
namespace firmware
{
namespace
{
constexpr double LEAST_ANGLE = 1.0;  ///< between two towers [degrees]
constexpr double HAIR = 1e-9;        ///< more than roots in floating point miss [m]
constexpr int MICROMETRES = 6;

/// Between two directions, from 0 to 180 [degrees].
double angleBetween(const Decimal& a, const Decimal& b)
{
  return std::abs(std::remainder((a - b).nearest(), 360.0));
}

void checkTower(const Tower& tower, const LinearDelta& delta, Reading& reading)
{
  if (tower.arm && tower.radius && !(*tower.radius < *tower.arm))
    reading.refuse(tower.place, "the arm of ", tower.joint, ", ", measure(*tower.arm, "m"),
                   ", must be longer than the radius that it bridges, ", measure(*tower.radius, "m"),
                   ": it reaches the middle otherwise at no height; check both");
  if (tower.radius && !(Decimal(0) < *tower.radius))
    reading.refuse(tower.place, "the radius of ", tower.joint, ", ", measure(*tower.radius, "m"),
                   " with its trim, must be above 0 m; check both");
  if (tower.home && delta.lowest && !(*delta.lowest < *tower.home))
    reading.refuse(tower.place, "the tool at the switch of ", tower.joint, ", z = ", measure(*tower.home, "m"),
                   ", must be above its lowest place, z = ", measure(*delta.lowest, "m"),
                   ": nothing is left to travel; check both");
  if (tower.lower && tower.upper && !(*tower.lower < *tower.upper))
    reading.refuse(tower.place, "the upper limit of ", tower.joint, ", ", measure(*tower.upper, "m"),
                   ", must be above the lower one, ", measure(*tower.lower, "m"), ": exchange or mend them");
}

double rise(const Decimal& arm, const Decimal& across)
{
  return std::sqrt(std::max(0.0, (arm * arm - across * across).nearest()));
}

/// A limit to the micrometre, on its inner side: what is proved within it the controller allows.
double roundedIn(double limit, bool is_upper)
{
  return *parseNumber(is_upper ? roundedDown(limit - HAIR, MICROMETRES) : roundedUp(limit + HAIR, MICROMETRES));
}

/// The carriage at the controller's lowest move. Where its reach is not known, the strut lies flat there at the worst.
double lowerLimit(const Tower& tower, const LinearDelta& delta)
{
  const Decimal lowest = delta.lowest.value_or(0) - tower.height;
  const double slope = std::hypot(delta.slope_x.nearest(), delta.slope_y.nearest());
  if (!delta.print_radius)
    return lowest.nearest();
  const double sunk = slope * delta.print_radius->nearest();
  const Decimal across = *tower.radius + *delta.print_radius;
  if (!(across < *tower.arm) && sunk == 0.0)
    return lowest.nearest();
  return roundedIn(lowest.nearest() - sunk + rise(*tower.arm, across), false);
}

LegDescription describe(const Tower& tower, const LinearDelta& delta)
{
  LegDescription leg;
  leg.joint = tower.joint;
  leg.angle = (*tower.angle * radianOfDegree()).nearest();
  leg.radius = tower.radius->nearest();
  leg.height = tower.height.nearest();
  leg.length = tower.arm->nearest();
  leg.speed = tower.speed.value_or(0).nearest();
  leg.lower = tower.lower ? tower.lower->nearest() : lowerLimit(tower, delta);
  leg.upper =
      tower.upper
          ? tower.upper->nearest()
          : roundedIn((tower.home.value_or(0) - tower.height).nearest() + rise(*tower.arm, *tower.radius), true);
  return leg;
}

/// How the towers stand in the frame in which the bed is level.
std::optional<Mount> mountOn(const Decimal& slope_x, const Decimal& slope_y)
{
  const double x = slope_x.nearest();
  const double y = slope_y.nearest();
  if (x == 0.0 && y == 0.0)
    return std::nullopt;
  Mount mount;
  mount.rpy = { -std::atan(y), std::atan2(x, std::hypot(1.0, y)), 0.0 };
  return mount;
}
}  // namespace

const Decimal& radianOfDegree()
{
  static const Decimal radian = *Decimal::parse("0.017453292519943295769236907684886127134");
  return radian;
}

void checkDelta(const LinearDelta& delta, Reading& reading)
{
  for (const Tower& tower : delta.towers)
    checkTower(tower, delta, reading);
  for (std::size_t i = 0; i < delta.towers.size(); ++i)
    for (std::size_t k = 0; k < i; ++k)
    {
      const Tower& one = delta.towers[k];
      const Tower& other = delta.towers[i];
      if (one.angle && other.angle && angleBetween(*one.angle, *other.angle) < LEAST_ANGLE)
        reading.refuse(other.place, one.joint, " and ", other.joint, " stand at ", measure(*one.angle, "and "),
                       measure(*other.angle, "degrees"),
                       ", expected at least 1 degree between two towers: "
                       "check the angles");
    }
}

MachineDescription describe(const LinearDelta& delta, const std::string& name)
{
  MachineDescription machine;
  machine.name = name;
  for (std::size_t i = 0; i < delta.towers.size(); ++i)
    machine.legs[i] = describe(delta.towers[i], delta);
  machine.mount = mountOn(delta.slope_x, delta.slope_y);
  return machine;
}
}  // namespace firmware
}  // namespace pkm_workspace
