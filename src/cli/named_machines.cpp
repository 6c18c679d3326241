// SPDX-License-Identifier: BSD-3-Clause
#include "named_machines.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <stdexcept>

#include "pkm_workspace/interval/decimal.h"
#include "pkm_workspace/machine/catalogue.h"

namespace pkm_workspace
{
namespace cli
{
namespace
{
Machine makeUranesx(const Dimensions& given)
{
  const Interval length(given.length.value_or(1.0));
  const Interval by_lambda = (Interval(7.0) / Interval(13.0) + Interval(given.lambda.value_or(0.0))) * length;
  const Interval by_length = Interval(3.0) / Interval(26.0) * length;
  return uranesx(given.rail_radius ? Interval(*given.rail_radius) : by_lambda,
                 given.platform_radius ? Interval(*given.platform_radius) : by_length, length.lower());
}

Interval limitsOf(const std::array<double, 2>& travel, double unit)
{
  if (!(travel[0] < travel[1]))
    throw std::invalid_argument("--travel " + exact(travel[0]) + ' ' + exact(travel[1]) +
                                ": the lower end comes first");
  return { travel[0] * unit, travel[1] * unit };
}

Machine makeDelta(const Dimensions& given)
{
  DeltaDimensions delta;
  delta.base_radius = given.base_radius ? Interval(*given.base_radius) : delta.base_radius;
  delta.crank = given.crank ? Interval(*given.crank) : delta.crank;
  delta.forearm = given.length ? Interval(*given.length) : delta.forearm;
  delta.platform_radius = given.platform_radius ? Interval(*given.platform_radius) : delta.platform_radius;
  delta.limits = DELTA_TRAVEL;
  if (given.travel)
    delta.limits = limitsOf(*given.travel, M_PI / 180.0);
  return pkm_workspace::delta(delta);
}

Machine makeTripod(const Dimensions& given)
{
  TripodDimensions tripod;
  tripod.base_radius = given.base_radius ? Interval(*given.base_radius) : tripod.base_radius;
  tripod.platform_radius = given.platform_radius ? Interval(*given.platform_radius) : tripod.platform_radius;
  tripod.length = given.length ? Interval(*given.length) : tripod.length;
  if (given.travel)
    tripod.limits = limitsOf(*given.travel, 1.0);
  return pkm_workspace::tripod(tripod);
}

const NamedMachine MACHINES[] = {
  { "orthoglide", { "length" }, [](const Dimensions& given) { return orthoglide(given.length.value_or(1.0)); } },
  { "orthoglide_prototype", {}, [](const Dimensions&) { return orthoglidePrototype(); } },
  { "uranesx", { "length", "rail-radius", "platform-radius", "lambda" }, makeUranesx },
  { "delta", { "base-radius", "crank", "length", "platform-radius", "travel" }, makeDelta },
  { "tripod", { "base-radius", "length", "platform-radius", "travel" }, makeTripod },
  { "mixed_legs", {}, [](const Dimensions&) { return mixedLegs(); } },
};
}  // namespace

void setDimension(const std::string& name, const std::vector<double>& numbers, Dimensions& dimensions)
{
  const std::pair<const char*, std::optional<double>*> single[] = {
    { "length", &dimensions.length },
    { "rail_radius", &dimensions.rail_radius },
    { "base_radius", &dimensions.base_radius },
    { "crank", &dimensions.crank },
    { "platform_radius", &dimensions.platform_radius },
  };
  for (const auto& [known, dimension] : single)
    if (name == known)
      *dimension = numbers[0];
  if (name == "travel")
    dimensions.travel = { { numbers[0], numbers[1] } };
}

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
