// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/tasks/singularities.h"

#include <algorithm>

#include "pkm_workspace/dexterity/defaults.h"
#include "pkm_workspace/region/region_parts.h"
#include "pkm_workspace/report/set_reach.h"
#include "pkm_workspace/report/singularity_sentence.h"

namespace pkm_workspace
{
SingularityTask::SingularityTask()
{
  query.joint_limits = defaultCriterion().joint_limits;
}

Criterion SingularityTask::criterion() const
{
  Criterion criterion = anyReachable();
  criterion.aspect = query.aspect;
  criterion.joint_limits = query.joint_limits;
  return criterion;
}

bool SingularityReport::isDecided() const
{
  const auto is_decided = [](const SingularityAnswer& answer) {
    return answer.status != SingularityAnswer::Status::UNDECIDED;
  };
  return is_decided(found.parallel) && std::all_of(found.serial.begin(), found.serial.end(), is_decided);
}

SingularityReport findSingularities(const Machine& machine, SingularityTask task)
{
  const Criterion criterion = task.criterion();
  SingularityReport report;
  if (task.region)
  {
    const auto& [solid, center] = *task.region;
    const SingularityQuery within = singularitiesOver(solid.shape, center, solid.size);
    task.query.box = within.box;
    task.query.part = within.part;
    report.found = findSingularities(machine, task.query);
    report.reaches = reachOver(machine, criterion, *solid.shape, center, solid.size);
  }
  else
  {
    report.found = findSingularities(machine, task.query);
    report.reaches = reachOver(machine, criterion);
  }
  report.message = withRemark(describe(report.found, machine, task.query.budget),
                              remarkOnLimits(machine, criterion, report.reaches));
  return report;
}
}  // namespace pkm_workspace
