// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/study/machine_family.h"

#include <stdexcept>
#include <string>

#include "pkm_workspace/dexterity/criterion.h"
#include "pkm_workspace/interval/decimal.h"
#include "pkm_workspace/machine/catalogue.h"

namespace pkm_workspace
{
namespace
{
/// Exact at both ends, and where both numbers are the same.
Interval between(const Interval& first, const Interval& last, const Interval& t)
{
  if (first == last || t == Interval(0.0))
    return first;
  return t == Interval(1.0) ? last : first + t * (last - first);
}

IntervalVector between(const IntervalVector& first, const IntervalVector& last, const Interval& t)
{
  return { between(first[0], last[0], t), between(first[1], last[1], t), between(first[2], last[2], t) };
}

IntervalVector directionBetween(const IntervalVector& first, const IntervalVector& last, const Interval& t)
{
  const IntervalVector sum = between(first, last, t);
  if (first == last || sum == first || sum == last)
    return sum;
  const Interval length = norm(sum);
  if (!length.certainlyPositive())
    throw std::invalid_argument("the rails of the two machines point in opposite directions");
  return { sum[0] / length, sum[1] / length, sum[2] / length };
}

Leg between(const Leg& first, const Leg& last, const Interval& t)
{
  Leg leg = first;
  leg.origin = between(first.origin, last.origin, t);
  leg.axis = directionBetween(first.axis, last.axis, t);
  leg.platform = between(first.platform, last.platform, t);
  leg.length = between(first.length, last.length, t);
  if (first.limits != last.limits)
    leg.limits = Interval::entire();
  return leg;
}

void validateEnds(const Machine& first, const Machine& last, bool joint_limits)
{
  Problems problems;
  for (int i = 0; i < 3; ++i)
  {
    const std::string legs = "legs '" + first.leg(i).joint + "' and '" + last.leg(i).joint + "' of the two machines ";
    if (first.leg(i).working_mode != last.leg(i).working_mode)
      problems.push_back(legs + "have opposite working modes");
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
  return { "lambda", "m", [](const Interval& lambda) {
            return uranesx(Interval(7.0) / Interval(13.0) + lambda, Interval(3.0) / Interval(26.0));
          } };
}

MachineFamily familyBetween(const Machine& first, const Machine& last, bool joint_limits)
{
  validateEnds(first, last, joint_limits);
  return { "share", "", [first, last](const Interval& t) {
            Machine::Legs legs;
            const std::array<int, 3> directions = sharedDirections([&](std::size_t i, std::size_t j) {
              const int sense = parallelSense(first.legs()[i], first.legs()[j]);
              return sense == parallelSense(last.legs()[i], last.legs()[j]) ? sense : 0;
            });
            for (std::size_t i = 0; i < 3; ++i)
            {
              legs[i] = between(first.legs()[i], last.legs()[i], t);
              legs[i].direction = directions[i];
            }
            const Eigen::Vector3d zero = first.zero() + t.mid() * (last.zero() - first.zero());
            Machine machine(first.name() + " to " + last.name(), legs, zero);
            if (machine.aspect() != first.aspect())
              throw std::invalid_argument("the machine at share " + exact(t.mid()) +
                                          " has the opposite aspect (sign of det A) of those at both ends");
            return machine;
          } };
}
}  // namespace pkm_workspace
