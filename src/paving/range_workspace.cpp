// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/paving/range_workspace.h"

#include <algorithm>
#include <optional>

#include "pkm_workspace/interval/text_stream.h"
#include "pkm_workspace/paving/reachable_volume.h"

namespace pkm_workspace
{
namespace
{
/// In struts: the resolution of the first pavings.
constexpr double COARSE = 0.1;
/// Each takes about four times the boxes of the one before.
constexpr int HALVINGS = 6;

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
    Interval between = Interval(outer.upper()) - Interval(outer.lower());
    if (!inner.isEmpty())
      between =
          (Interval(inner.lower()) - Interval(outer.lower())) + (Interval(outer.upper()) - Interval(inner.upper()));
    volume +=
        visitLeg([&](const auto& leg) { return volumeOfJoints(leg, between); }, machine.enclosed(static_cast<int>(i)));
  }
  return volume;
}

/// Both aspects at one resolution after the other.
class RangePaver
{
public:
  RangePaver(const Machine& machine, const RangeQuery& query)
    : machine_(withJointLimits(machine, query.ranges.outer))
    , query_(query)
    , uncertain_(volumeBetween(machine, query.ranges))
    , budget_(query.budget)
  {}

  RangeWorkspace run()
  {
    double resolution = COARSE * machine_.scale();
    for (int k = 0; k <= HALVINGS && !(k > 0 && isSettled()) && !isOver(); ++k, resolution *= 0.5)
    {
      answer_.resolution = resolution;
      const Interval own = volume(Criterion::Aspect::OWN, resolution);
      const Interval other = volume(Criterion::Aspect::OTHER, resolution);
      answer_.own_aspect = k == 0 ? own : intersection(answer_.own_aspect, own);
      answer_.other_aspect = k == 0 ? other : intersection(answer_.other_aspect, other);
    }
    answer_.own_aspect = withinRanges(answer_.own_aspect);
    answer_.other_aspect = withinRanges(answer_.other_aspect);
    answer_.complete = isSettled();
    answer_.seconds = budget_.seconds();
    return answer_;
  }

private:
  bool isOver() const { return boxes_ > 0 && budget_.isOver(boxes_); }

  /// Whether the volume that the accuracy is about is known to it.
  bool isSettled() const
  {
    const Interval& asked = query_.aspect == Criterion::Aspect::OTHER ? answer_.other_aspect : answer_.own_aspect;
    return asked.width() <= query_.accuracy * asked.upper();
  }

  Interval volume(Criterion::Aspect aspect, double resolution)
  {
    PavingQuery query;
    query.criterion.set = Criterion::Set::REACHABLE;
    query.criterion.aspect = aspect;
    query.criterion.joint_limits = true;
    query.resolution = resolution;
    query.budget = budget_.rest(boxes_).sharedBy(pavings_.size());
    std::optional<Paving>& paving = pavings_[aspect == Criterion::Aspect::OWN ? 0 : 1];
    paving = paving ? resume(machine_, query, *paving) : pave(machine_, query);
    boxes_ += paving->boxes_here;
    return reachableVolume(machine_, query.criterion, *paving, budget_.rest(boxes_));
  }

  /// Encloses the volume for the ranges, given that for the outer ones.
  Interval withinRanges(const Interval& outer) const
  {
    return { std::max(0.0, (outer - uncertain_).lower()), outer.upper() };
  }

  const Machine machine_;
  const RangeQuery& query_;
  const Interval uncertain_;  ///< what may belong to the outer ranges only [m^3]
  const RunningBudget budget_;
  std::int64_t boxes_ = 0;
  std::array<std::optional<Paving>, 2> pavings_;  ///< of either aspect, at the last resolution
  RangeWorkspace answer_;
};
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
  return RangePaver(machine, validated(query)).run();
}
}  // namespace pkm_workspace
