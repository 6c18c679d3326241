// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/study/machine_family.h"

#include <algorithm>
#include <stdexcept>
#include <string>

#include "pkm_workspace/dexterity/criterion.h"
#include "pkm_workspace/interval/decimal.h"
#include "pkm_workspace/machine/catalogue.h"
#include "pkm_workspace/machine/rails.h"

namespace pkm_workspace
{
namespace
{
LegKind between(const LegKind& first, const LegKind& last, const Interval& t)
{
  return visitLeg(
      [&](const auto& kind) -> LegKind { return between(kind, std::get<std::decay_t<decltype(kind)>>(last), t); },
      first);
}

/// Why no leg is between these; "" where each share has one.
std::string differenceOfKinds(const LegKind& first, const LegKind& last)
{
  if (first.index() != last.index())
    return "are of different kinds";
  return visitLeg(
      [&](const auto& kind) { return differenceOfModes(kind, std::get<std::decay_t<decltype(kind)>>(last)); }, first);
}

void validateEnds(const Machine& first, const Machine& last, bool joint_limits)
{
  Problems problems;
  for (int i = 0; i < 3; ++i)
  {
    const std::string legs = "legs '" + first.leg(i).joint + "' and '" + last.leg(i).joint + "' of the two machines ";
    const std::string difference = differenceOfKinds(first.leg(i).kind, last.leg(i).kind);
    if (!difference.empty())
      problems.push_back(legs + difference);
    if (joint_limits && first.leg(i).limits != last.leg(i).limits)
      problems.push_back(legs + "have different joint limits: leave joint limits off, or make them the same");
  }
  if (first.aspect() != last.aspect())
    problems.push_back("the two machines have opposite aspects (signs of det A)");
  throwProblems(problems);
}
}  // namespace

MachineFamily uranesxByRadius(double length)
{
  return { "R-r", "m", [length](const Interval& offset) { return uranesx(offset, Interval(0.0), length); } };
}

MachineFamily uranesxByLambda()
{
  const auto at = [](const Interval& lambda) {
    return uranesx(Interval(7.0) / Interval(13.0) + lambda, Interval(3.0) / Interval(26.0));
  };
  return { "lambda", "m", at };
}

namespace
{
/// The machine at a share of the way from one to the other.
Machine machineBetween(const Machine& first, const Machine& last, const Interval& t)
{
  Machine::Legs legs;
  const std::array<int, 3> directions = sharedDirections([&](std::size_t i, std::size_t j) {
    const int sense = parallelSense(first.legs()[i], first.legs()[j]);
    return sense == parallelSense(last.legs()[i], last.legs()[j]) ? sense : 0;
  });
  for (std::size_t i = 0; i < 3; ++i)
  {
    const Leg& leg = first.legs()[i];
    const bool has_limits = leg.limits == last.legs()[i].limits;
    legs[i] = { leg.joint, has_limits ? leg.limits : Interval::entire(), between(leg.kind, last.legs()[i].kind, t),
                std::min(leg.speed, last.legs()[i].speed), std::min(leg.effort, last.legs()[i].effort) };
  }
  setDirections(legs, directions);
  const Eigen::Vector3d zero = first.zero() + t.mid() * (last.zero() - first.zero());
  Machine machine(first.name() + " to " + last.name(), legs, zero);
  if (machine.aspect() != first.aspect())
    throw std::invalid_argument("the machine at share " + exact(t.mid()) +
                                " has the opposite aspect (sign of det A) of those at both ends");
  return machine;
}
}  // namespace

MachineFamily familyBetween(const Machine& first, const Machine& last, bool joint_limits)
{
  validateEnds(first, last, joint_limits);
  return { "share", "", [first, last](const Interval& t) { return machineBetween(first, last, t); } };
}

MachineFamily withinTolerances(const MachineFamily& family, const GivenTolerances& tolerances)
{
  MachineFamily within = family;
  if (!tolerances.isEmpty())
    within.at = [family, tolerances](const Interval& t) { return withGivenTolerances(family.at(t), tolerances); };
  return within;
}

namespace
{
Machine deltaWith(Interval DeltaDimensions::*dimension, const Interval& value)
{
  DeltaDimensions dimensions;
  dimensions.limits = DELTA_TRAVEL;
  dimensions.*dimension = value;
  return delta(dimensions);
}

Machine tripodWith(Interval TripodDimensions::*dimension, const Interval& value)
{
  TripodDimensions dimensions;
  dimensions.*dimension = value;
  return tripod(dimensions);
}
}  // namespace

MachineFamily deltaBy(Interval DeltaDimensions::*dimension, const std::string& name)
{
  return { name, "m", [dimension](const Interval& value) { return deltaWith(dimension, value); } };
}

MachineFamily tripodBy(Interval TripodDimensions::*dimension, const std::string& name)
{
  return { name, "m", [dimension](const Interval& value) { return tripodWith(dimension, value); } };
}
}  // namespace pkm_workspace
