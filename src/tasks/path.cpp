// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/tasks/path.h"

#include "pkm_workspace/report/path_sentence.h"

namespace pkm_workspace
{
PathReport checkPath(const PointEvaluator& evaluator, const PathTask& task)
{
  const Machine& machine = evaluator.machine();
  const Criterion& criterion = evaluator.test().model().criterion();
  PathChecker checker(evaluator, task.query, task.tell);
  PathReach reach(machine);
  task.for_each([&](const PathSegment& segment) {
    checker.add(segment);
    if (!criterion.joint_limits)
      reach.add(segment);
  });
  PathReport report;
  report.result = checker.finish();
  if (report.result.motion && !criterion.joint_limits)
    report.reaches = reach.over(*report.result.motion);
  const bool is_told = report.result.end == PathResult::End::STOPPED && task.stopped_by;
  report.message =
      withRemark(describe(report.result, machine, task.place, is_told ? task.stopped_by() : "a request to stop"),
                 remarkOnLimits(machine, criterion, report.reaches));
  return report;
}
}  // namespace pkm_workspace
