// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/tasks/paving.h"

#include <algorithm>

#include "pkm_workspace/dexterity/defaults.h"
#include "pkm_workspace/paving/reachable_volume.h"
#include "pkm_workspace/report/connection_sentence.h"
#include "pkm_workspace/report/paving_sentence.h"
#include "pkm_workspace/report/set_reach.h"

namespace pkm_workspace
{
namespace
{
/// With what is left of the time.
Interval measureOf(const Machine& machine, const PavingQuery& query, const Paving& paving)
{
  const Interval measure(paving.volumeLower(), paving.volumeUpper());
  if (query.criterion.boundsFactors())
    return measure;
  const Budget budget = query.budget.within(std::max(1e-9, query.budget.time_limit - paving.seconds));
  return intersection(measure, reachableVolume(machine, query.criterion, paving, budget));
}

std::string endedBy(const Budget& budget, const Paving& paving)
{
  if (paving.complete)
    return "";
  const std::string ended_by = budget.endedBy(paving.seconds, paving.boxes_here);
  return ended_by.empty() ? budget.endedBy(paving.seconds, paving.boxes_here, true) : ended_by;
}
}  // namespace

std::string PavingReport::message(const Machine& machine) const
{
  return withRemark(describe(paving, measure, machine, ended_by),
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

PavingReport reportPaving(const Machine& machine, const PavingQuery& query, const Paving* earlier)
{
  PavingReport report;
  report.paving = earlier ? resume(machine, query, *earlier) : pave(machine, query);
  report.measure = measureOf(machine, query, report.paving);
  if (!query.criterion.joint_limits)
    report.reaches = reachOver(machine, report.paving);
  report.ended_by = endedBy(query.budget, report.paving);
  return report;
}
}  // namespace pkm_workspace
