// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/tasks/paving.h"

#include <algorithm>

#include "pkm_workspace/dexterity/defaults.h"
#include "pkm_workspace/report/connection_sentence.h"
#include "pkm_workspace/report/paving_sentence.h"
#include "pkm_workspace/report/set_reach.h"

namespace pkm_workspace
{
namespace
{
/// With what is left of the budget.
SetVolume sizeOf(const Machine& machine, const PavingQuery& query, const Paving& paving, VolumeQuery wanted)
{
  wanted.budget = query.budget.within(std::max(1e-9, query.budget.time_limit - paving.seconds));
  if (query.budget.max_boxes > 0)
    wanted.budget.max_boxes = std::max<std::int64_t>(1, query.budget.max_boxes - paving.boxes_here);
  wanted.progress = query.progress;
  wanted.progress_period = query.progress_period;
  return setVolume(machine, paving, wanted);
}

std::string endedBy(const Budget& budget, const PavingReport& report)
{
  if (report.paving.complete && report.size.complete)
    return "";
  const std::int64_t boxes = report.paving.boxes_here + (report.paving.complete ? report.size.boxes : 0);
  for (const bool out_of_memory : { false, true })
    if (const std::string ended_by = budget.endedBy(report.seconds(), boxes, out_of_memory); !ended_by.empty())
      return ended_by;
  return "";
}
}  // namespace

std::string PavingReport::message(const Machine& machine) const
{
  return withRemark(describe(paving, size.volume, machine, ended_by),
                    remarkOnLimits(machine, paving.premises.criterion, reaches));
}

ComponentsReport reportComponents(const Machine& machine, const Paving& paving, bool is_whole, const Budget& budget)
{
  const RunningBudget running(budget);
  const Components components(paving.tree, [&running] { return running.isOver(); });
  ComponentsReport report;
  report.list = components.list();
  report.clusters = components.clusters();
  report.zero = components.at(machine.zero());
  const PointEvaluation zero = evaluatePoint(machine, paving.premises.criterion, machine.zero());
  report.message = describe(components, is_whole, zero.verdict, report.zero);
  return report;
}

double defaultResolution(const Machine& machine, const PavingQuery& query)
{
  return defaultResolution(machine, query.box ? *query.box : defaultBox(machine, query.criterion));
}

PavingReport reportPaving(const Machine& machine, const PavingQuery& query, const Paving* earlier, VolumeQuery wanted)
{
  PavingReport report;
  report.paving = earlier ? resume(machine, query, *earlier) : pave(machine, query);
  report.size = sizeOf(machine, query, report.paving, std::move(wanted));
  if (!query.criterion.joint_limits)
    report.reaches = reachOver(machine, report.paving);
  report.ended_by = endedBy(query.budget, report);
  return report;
}
}  // namespace pkm_workspace
