// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/machine/ball_axes.h"

#include "pkm_workspace/interval/decimal.h"

namespace pkm_workspace
{
void validateBallAxes(const BallAxes& axes, Problems& problems)
{
  if (!axes.empty() && axes.size() != 1 && axes.size() != 3)
    complain(problems, "ball_axes: ", axes.size(), " axes, expected one for all legs or one for each of the three");
  for (const Eigen::Vector3d& axis : axes)
    if (!axis.allFinite() || !(axis.norm() >= 1e-9 && axis.norm() <= 1e9))
      complain(problems, "ball_axes: (", exact(axis.x()), ", ", exact(axis.y()), ", ", exact(axis.z()),
               ") is not a direction, expected a vector of a length from 1e-9 to 1e9");
}

void setBallAxes(const BallAxes& axes, Machine::Legs& legs)
{
  for (std::size_t i = 0; !axes.empty() && i < legs.size(); ++i)
    passiveJoints(legs[i]).ball_axes = { enclose(axes[axes.size() == 1 ? 0 : i]) };
}

Machine withBallAxes(const Machine& machine, const BallAxes& axes)
{
  Problems problems;
  validateBallAxes(axes, problems);
  throwProblems(problems);
  Machine::Legs legs = machine.legs();
  setBallAxes(axes, legs);
  return { machine.name(), legs, machine.zero() };
}

BallAxes givenBallAxes(const Machine& machine)
{
  BallAxes axes;
  for (const Leg& leg : machine.legs())
    for (const IntervalVector& axis : passiveJoints(leg).ball_axes)
      axes.push_back(mid(axis));
  return axes;
}
}  // namespace pkm_workspace
