// SPDX-License-Identifier: BSD-3-Clause
#include "rotary_delta.h"

#include "linear_delta.h"

namespace pkm_workspace
{
namespace firmware
{
namespace
{
LegDescription describe(const DrivenCrank& crank, const RotaryDelta& delta)
{
  const auto radians = [](const Decimal& degrees) { return (degrees * radianOfDegree()).nearest(); };
  LegDescription leg;
  leg.kind = LegDescription::Kind::CRANK;
  leg.joint = crank.joint;
  leg.angle = radians(crank.angle);
  leg.radius = delta.base_radius->nearest();
  leg.crank = delta.crank->nearest();
  leg.length = delta.forearm->nearest();
  leg.platform_joint.x() = delta.platform_radius->nearest();
  leg.lower = radians(*crank.lower);
  leg.upper = radians(*crank.upper);
  leg.speed = crank.speed;
  return leg;
}
}  // namespace

void checkDelta(const RotaryDelta& delta, Reading& reading)
{
  for (const DrivenCrank& crank : delta.cranks)
    if (crank.lower && crank.upper && !(*crank.lower < *crank.upper))
      reading.refuse(crank.place, "the upper limit of ", crank.joint, ", ", measure(*crank.upper, "degrees"),
                     ", must be above the lower one, ", measure(*crank.lower, "degrees"), ": exchange or mend them");
  if (!delta.base_radius || !delta.crank || !delta.forearm || !delta.platform_radius)
    return;
  const Decimal across = *delta.base_radius + *delta.crank - *delta.platform_radius;
  if (!(across < *delta.forearm) || !(-*delta.forearm < across))
    reading.refuse(delta.place, "the forearm, ", measure(*delta.forearm, "m"),
                   ", must be longer than what it bridges where all cranks are level, ", measure(across, "m"),
                   " (base radius and crank less platform radius): a URDF shows the machine assembled at joint values "
                   "0; check these lengths");
}

MachineDescription describe(const RotaryDelta& delta, const std::string& name)
{
  MachineDescription machine;
  machine.name = name;
  for (std::size_t i = 0; i < delta.cranks.size(); ++i)
    machine.legs[i] = describe(delta.cranks[i], delta);
  return machine;
}
}  // namespace firmware
}  // namespace pkm_workspace
