// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/tasks/path.h"

#include "pkm_workspace/report/path_sentence.h"
#include "pkm_workspace/report/rates_sentence.h"

namespace pkm_workspace
{
namespace
{
/// One number for all joints, or one for each.
std::array<double, 3> forEachJoint(const std::vector<double>& values)
{
  const auto at = [&values](std::size_t i) { return values[values.size() == 3 ? i : 0]; };
  return { at(0), at(1), at(2) };
}

void setRates(const PathRatesTask& rates, const Machine& machine, const Criterion& criterion, PathQuery& query)
{
  query.limits = limitsOf(rates, machine, criterion);
  query.tool_speed = rates.tool_speed.value_or(query.tool_speed);
  query.holds_limits = rates.isHeld();
  query.steps_have_speeds = rates.steps_have_speeds;
  query.wants_rates = rates.isAsked();
}
}  // namespace

JointRateLimits limitsOf(const PathRatesTask& rates, const Machine& machine, const Criterion& criterion)
{
  Problems problems;
  rates.validate(problems);
  throwProblems(problems);
  JointRateLimits limits;
  for (std::size_t i = 0; i < 3 && !rates.joint_speeds_off; ++i)
    limits.speed[i] = criterion.joint_speed_max[i] > 0.0 ? criterion.joint_speed_max[i] : machine.legs()[i].speed;
  if (!rates.joint_acceleration_max.empty())
    limits.acceleration = forEachJoint(rates.joint_acceleration_max);
  return limits;
}

void PathRatesTask::validate(Problems& problems) const
{
  const std::size_t count = joint_acceleration_max.size();
  if (count != 0 && count != 1 && count != 3)
    complain(problems, "joint_acceleration_max has ", count,
             " numbers: give one for all joints, or one for each [m/s^2]");
  if (steps_have_speeds && tool_speed)
    problems.push_back("tool_speed is without effect: each segment has its own");
  if (count != 0 && !isAsked() && !isHeld())
    problems.push_back("joint_acceleration_max is without effect: give tool_speed too, or ask for largest_feed");
  if (joint_speeds_off && !isAsked() && !isHeld())
    problems.push_back("joint_speeds_off is without effect: joint speeds are held at a tool_speed only");
}

PathReport checkPath(const PointEvaluator& evaluator, const PathTask& task)
{
  const Machine& machine = evaluator.machine();
  const Criterion& criterion = evaluator.test().model().criterion();
  PathReport report;
  report.query = task.query;
  setRates(task.rates, machine, criterion, report.query);
  PathChecker checker(evaluator, report.query, task.tell);
  PathReach reach(machine);
  task.for_each([&](const PathStep& step) {
    checker.add(step);
    if (!criterion.joint_limits)
      reach.add(step.segment);
  });
  report.result = checker.finish();
  if (report.result.motion && !criterion.joint_limits)
    report.reaches = reach.over(*report.result.motion);
  const bool is_told = report.result.end == PathResult::End::STOPPED && task.stopped_by;
  const std::string proof =
      describe(report.result, machine, task.place, is_told ? task.stopped_by() : "a request to stop");
  const std::string rates =
      describeRates(report.result, report.query, machine, task.place, task.rates.joint_speeds_off);
  report.message = withRemark(withRemark(proof, rates), remarkOnLimits(machine, criterion, report.reaches));
  return report;
}
}  // namespace pkm_workspace
