// SPDX-License-Identifier: BSD-3-Clause
#include "named_machines.h"

#include <algorithm>
#include <iterator>

#include "pkm_workspace/machine/catalogue.h"

namespace pkm_workspace
{
namespace cli
{
namespace
{
Machine makeUranesx(const Dimensions& given)
{
  const Interval length(given.length);
  const Interval by_lambda = (Interval(7.0) / Interval(13.0) + Interval(given.lambda.value_or(0.0))) * length;
  const Interval by_length = Interval(3.0) / Interval(26.0) * length;
  return uranesx(given.rail_radius ? Interval(*given.rail_radius) : by_lambda,
                 given.platform_radius ? Interval(*given.platform_radius) : by_length, given.length);
}

const NamedMachine MACHINES[] = {
  { "orthoglide", { "length" }, [](const Dimensions& given) { return orthoglide(given.length); } },
  { "orthoglide_prototype", {}, [](const Dimensions&) { return orthoglidePrototype(); } },
  { "uranesx", { "length", "rail-radius", "platform-radius", "lambda" }, makeUranesx },
};
}  // namespace

Words machineNames()
{
  Words names;
  for (const NamedMachine& machine : MACHINES)
    names.push_back(machine.name);
  return names;
}

const NamedMachine& namedMachine(const std::string& name)
{
  return *std::find_if(std::begin(MACHINES), std::end(MACHINES), [&](const NamedMachine& m) { return m.name == name; });
}

Machine makeDriven(const NamedMachine& named, const Dimensions& given)
{
  const Machine machine = named.make(given);
  Machine::Legs legs = machine.legs();
  for (std::size_t i = 0; i < 3; ++i)
  {
    legs[i].speed = given.speeds[i] > 0.0 ? given.speeds[i] : legs[i].speed;
    legs[i].effort = given.efforts[i] > 0.0 ? given.efforts[i] : legs[i].effort;
  }
  return { machine.name(), legs, machine.zero() };
}
}  // namespace cli
}  // namespace pkm_workspace
