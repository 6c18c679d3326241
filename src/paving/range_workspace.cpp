// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/paving/range_workspace.h"

#include <algorithm>
#include <chrono>
#include <optional>
#include <sstream>

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
      std::ostringstream text;
      text << "range of joint " << i + 1 << " = " << ranges[i] << " m must have two ends";
      problems.push_back(text.str());
    }
}

/// Both aspects at one resolution after the other.
class RangePaver
{
public:
  RangePaver(const Machine& machine, const RangeQuery& query)
    : machine_(withJointLimits(machine, query.ranges)), query_(query), begin_(std::chrono::steady_clock::now())
  {}

  RangeWorkspace run()
  {
    double resolution = COARSE * machine_.scale();
    for (int k = 0; k <= HALVINGS && !answer_.complete && !isOver(); ++k, resolution *= 0.5)
    {
      answer_.resolution = resolution;
      const Interval own = volume(Criterion::Aspect::OWN, resolution);
      const Interval other = volume(Criterion::Aspect::OTHER, resolution);
      answer_.own_aspect = k == 0 ? own : intersection(answer_.own_aspect, own);
      answer_.other_aspect = k == 0 ? other : intersection(answer_.other_aspect, other);
      answer_.complete = answer_.own_aspect.width() <= query_.accuracy * answer_.own_aspect.upper();
    }
    answer_.seconds = seconds();
    return answer_;
  }

private:
  double seconds() const { return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count(); }
  bool isOver() const
  {
    const Budget& budget = query_.budget;
    return boxes_ > 0 && (budget.isOver(seconds()) || (budget.max_boxes > 0 && boxes_ >= budget.max_boxes));
  }

  Interval volume(Criterion::Aspect aspect, double resolution)
  {
    PavingQuery query;
    query.criterion.set = Criterion::Set::REACHABLE;
    query.criterion.aspect = aspect;
    query.criterion.joint_limits = true;
    query.resolution = resolution;
    query.budget = query_.budget;
    if (query.budget.max_boxes > 0)
      query.budget.max_boxes = std::max<std::int64_t>(1, query.budget.max_boxes - boxes_);
    if (query.budget.time_limit > 0.0)
      query.budget.time_limit = std::max(1e-9, query.budget.time_limit - seconds());
    std::optional<Paving>& paving = pavings_[aspect == Criterion::Aspect::OWN ? 0 : 1];
    paving = paving ? resume(machine_, query, *paving) : pave(machine_, query);
    boxes_ += paving->boxes_here;
    if (query.budget.time_limit > 0.0)
      query.budget.time_limit = std::max(1e-9, query_.budget.time_limit - seconds());
    return reachableVolume(machine_, query.criterion, *paving, query.budget);
  }

  const Machine machine_;
  const RangeQuery& query_;
  const std::chrono::steady_clock::time_point begin_;
  std::int64_t boxes_ = 0;
  std::array<std::optional<Paving>, 2> pavings_;  ///< of either aspect, at the last resolution
  RangeWorkspace answer_;
};
}  // namespace

std::array<Interval, 3> equalisedRanges(const std::array<Interval, 3>& ranges)
{
  Problems problems;
  validateRanges(ranges, problems);
  throwProblems(problems);
  double stroke = 0.0;
  for (const Interval& range : ranges)
    stroke = std::max(stroke, range.width());
  std::array<Interval, 3> equal;
  std::transform(ranges.begin(), ranges.end(), equal.begin(), [stroke](const Interval& range) {
    return Interval(range.lower(), (Interval(range.lower()) + Interval(stroke)).upper());
  });
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
  validateRanges(ranges, problems);
  validateShare("accuracy", accuracy, "(relative)", problems);
  budget.validate(problems);
}

RangeWorkspace workspaceOfRanges(const Machine& machine, const RangeQuery& query)
{
  return RangePaver(machine, validated(query)).run();
}
}  // namespace pkm_workspace
