// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/paving/range_workspace.h"

#include <algorithm>
#include <optional>

#include "pkm_workspace/interval/text_stream.h"
#include "pkm_workspace/paving/set_volume.h"

namespace pkm_workspace
{
namespace
{
/// In struts: the resolution of the pavings, whose boxes at the border are divided further.
constexpr double COARSE = 0.1;
void validateRanges(const std::array<Interval, 3>& ranges, Problems& problems)
{
  for (std::size_t i = 0; i < 3; ++i)
    if (ranges[i].isEmpty() || !ranges[i].isBounded())
    {
      TextStream text;
      text << "range of joint " << i + 1 << " = " << ranges[i] << " m must have two ends";
      problems.push_back(text.str());
    }
}

/// Bounds the volume of the points whose joint values lie in the outer ranges, but not all in the inner ones.
Interval volumeBetween(const Machine& machine, const JointIntervals& ranges)
{
  Interval volume;
  for (std::size_t i = 0; i < 3; ++i)
  {
    const Interval& outer = ranges.outer[i];
    const Interval& inner = ranges.inner[i];
    const auto volumeOf = [&](double lower, double upper) {
      return visitLeg(
          [&](const auto& leg) {
            return volumeOfJoints(leg, { lower, upper });
          },
          machine.enclosed(static_cast<int>(i)));
    };
    volume += inner.isEmpty() ? volumeOf(outer.lower(), outer.upper())
                              : volumeOf(outer.lower(), inner.lower()) + volumeOf(inner.upper(), outer.upper());
  }
  return volume;
}

/// Encloses the volume of one aspect for the outer ranges.
Interval volumeOfAspect(const Machine& machine, Criterion::Aspect aspect, VolumeQuery wanted)
{
  const RunningBudget running(wanted.budget);
  PavingQuery query;
  query.criterion.set = Criterion::Set::REACHABLE;
  query.criterion.aspect = aspect;
  query.criterion.joint_limits = true;
  query.resolution = COARSE * machine.scale();
  query.budget = wanted.budget;
  const Paving paving = pave(machine, query);
  wanted.budget = running.rest(paving.boxes_here);
  return setVolume(machine, paving, wanted).volume;
}
/// What the volume for these ranges is at least.
double volumeWithin(const Machine& machine, const std::array<Interval, 3>& ranges, Criterion::Aspect aspect,
                    const VolumeQuery& wanted)
{
  if (std::any_of(ranges.begin(), ranges.end(), [](const Interval& range) { return range.isEmpty(); }))
    return 0.0;
  return volumeOfAspect(withJointLimits(machine, ranges), aspect, wanted).lower();
}
}  // namespace

JointIntervals equalisedRanges(const std::array<Interval, 3>& least, const std::array<Interval, 3>& strokes)
{
  Problems problems;
  validateRanges(least, problems);
  validateRanges(strokes, problems);
  throwProblems(problems);
  Interval longest = strokes[0];
  for (const Interval& stroke : strokes)
    longest = { std::max(longest.lower(), stroke.lower()), std::max(longest.upper(), stroke.upper()) };
  JointIntervals equal;
  for (std::size_t i = 0; i < 3; ++i)
  {
    const Interval end = least[i] + longest;
    equal.outer[i] = { least[i].lower(), end.upper() };
    equal.inner[i] = least[i].upper() <= end.lower() ? Interval(least[i].upper(), end.lower()) : Interval::empty();
  }
  return equal;
}

Machine withJointLimits(const Machine& machine, const std::array<Interval, 3>& limits)
{
  Machine::Legs legs = machine.legs();
  for (std::size_t i = 0; i < 3; ++i)
    legs[i].limits = limits[i];
  return Machine(machine.name(), legs, machine.zero());
}

void RangeQuery::validate(Problems& problems) const
{
  validateRanges(ranges.outer, problems);
  for (std::size_t i = 0; i < 3; ++i)
    if (!ranges.inner[i].isSubsetOf(ranges.outer[i]))
      problems.push_back("inner range of joint " + std::to_string(i + 1) + " must lie in the outer one");
  validateShare("accuracy", accuracy, "(relative)", problems);
  budget.validate(problems);
}

RangeWorkspace workspaceOfRanges(const Machine& machine, const RangeQuery& query)
{
  validated(query);
  const Machine limited = withJointLimits(machine, query.ranges.outer);
  const Interval uncertain = machine.hasTolerances() ? Interval() : volumeBetween(machine, query.ranges);
  const RunningBudget budget(query.budget);
  const auto volumeOf = [&](bool is_own, double width) {
    VolumeQuery wanted;
    wanted.accuracy = query.accuracy;
    wanted.width = width;
    wanted.budget = query.budget.inTurns(machine.hasTolerances() ? 4.0 : 2.0);
    const Criterion::Aspect aspect = is_own ? Criterion::Aspect::OWN : Criterion::Aspect::OTHER;
    const Interval volume = volumeOfAspect(limited, aspect, wanted);
    if (machine.hasTolerances())  // a point may be between the ranges on one machine and within them on another
      return Interval(volumeWithin(machine, query.ranges.inner, aspect, wanted), volume.upper());
    return Interval(std::max(0.0, (volume - uncertain).lower()), volume.upper());
  };
  const bool asks_own = query.aspect == Criterion::Aspect::OWN;
  const Interval asked = volumeOf(asks_own, 0.0);
  const double width = query.accuracy * asked.upper();
  const Interval other = volumeOf(!asks_own, width);
  RangeWorkspace answer;
  answer.own_aspect = asks_own ? asked : other;
  answer.other_aspect = asks_own ? other : asked;
  answer.complete = asked.width() <= width;
  answer.seconds = budget.seconds();
  return answer;
}
}  // namespace pkm_workspace
