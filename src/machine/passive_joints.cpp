// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/machine/passive_joints.h"

#include "numbers.h"

namespace pkm_workspace
{
namespace
{
std::string textOfStops(const PassiveJoints& joints)
{
  std::string text;
  for (const StrutStop& stop : joints.stops)
    text += (stop.is_upper ? " upper stop" : " lower stop") + exactText(stop.direction) + exactText(stop.least);
  return text;
}

std::string textOfBallAxes(const PassiveJoints& joints)
{
  std::string text;
  for (const IntervalVector& axis : joints.ball_axes)
    text += " ball axis" + exactText(axis);
  return text;
}
}  // namespace

std::string exactText(const PassiveJoints& joints)
{
  return textOfStops(joints) + textOfBallAxes(joints);
}

void turn(const IntervalMatrix& rotation, PassiveJoints& joints)
{
  for (StrutStop& stop : joints.stops)
    stop.direction = rotation * stop.direction;
  for (IntervalVector& axis : joints.ball_axes)
    axis = rotation * axis;
}

PassiveJoints between(const PassiveJoints& first, const PassiveJoints& last)
{
  PassiveJoints joints = first;
  if (textOfStops(first) != textOfStops(last))
  {
    joints.stops.clear();
    joints.open_hinges = { "passive hinges differ between the two machines" };
  }
  return joints;
}

std::string differenceOf(const PassiveJoints& first, const PassiveJoints& last)
{
  return textOfBallAxes(first) == textOfBallAxes(last) ? "" : "have different ball axes: give both the same";
}
}  // namespace pkm_workspace
