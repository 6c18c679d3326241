// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/tasks/conditioning.h"

#include "pkm_workspace/paving/workspace_conditioning.h"
#include "pkm_workspace/region/region_parts.h"
#include "pkm_workspace/report/conditioning_sentence.h"
#include "pkm_workspace/report/set_reach.h"

namespace pkm_workspace
{
ConditioningReport globalConditioning(const Machine& machine, const ConditioningTask& task)
{
  ConditioningReport report;
  if (task.region)
  {
    const auto& [solid, center] = *task.region;
    report.found = globalConditioning(machine, *solid.shape, center, solid.size, task.query);
  }
  else
  {
    report.found = workspaceConditioning(machine, task.criterion, task.query);
    report.reaches = reachOver(machine, task.criterion);
  }
  report.message =
      withRemark(describe(report.found, task.query.budget), remarkOnLimits(machine, task.criterion, report.reaches));
  return report;
}
}  // namespace pkm_workspace
