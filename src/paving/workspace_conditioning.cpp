// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/paving/workspace_conditioning.h"

#include "pkm_workspace/paving/paving.h"

namespace pkm_workspace
{
GlobalConditioning workspaceConditioning(const Machine& machine, const Criterion& criterion,
                                         const ConditioningQuery& query)
{
  const BoxTest test(machine, criterion);
  const Box box = defaultBox(machine, criterion);
  if (!box.isValid())  // the set is empty
  {
    GlobalConditioning nothing;
    nothing.index = Interval(0.0, 1.0);
    return nothing;
  }
  return globalConditioning(machine, test, box, query);
}
}  // namespace pkm_workspace
