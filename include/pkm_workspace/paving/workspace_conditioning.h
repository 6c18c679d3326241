// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "pkm_workspace/dexterity/global_conditioning.h"

namespace pkm_workspace
{
/// The global conditioning index over all of the criterion's set; where nothing changes along the rails, over its
/// section (defaultBox()).
/// @throws std::invalid_argument for a query that is not valid or a set without bounds, with all reasons
GlobalConditioning workspaceConditioning(const Machine& machine, const Criterion& criterion,
                                         const ConditioningQuery& query);
}  // namespace pkm_workspace
