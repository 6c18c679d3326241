// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

#include "pkm_workspace/dexterity/defaults.h"
#include "pkm_workspace/dexterity/global_conditioning.h"
#include "pkm_workspace/region/beyond_limits.h"
#include "pkm_workspace/tasks/placed_solid.h"

namespace pkm_workspace
{
/// What is asked about the global conditioning index. Values with defaults: over all points of the default criterion.
struct ConditioningTask
{
  /// What is asked of each point that counts: of a region's, nothing but that the struts reach it.
  Criterion pointsThatCount() const { return region ? anyReachable() : criterion; }

  std::optional<PlacedSolid> region;  ///< all of its points count; without it, those that satisfy the criterion
  Criterion criterion = defaultCriterion();
  ConditioningQuery query;
};

struct ConditioningReport
{
  GlobalConditioning found;
  std::optional<JointReaches> reaches;  ///< over the criterion's set, where joint limits are left aside
  std::string message;                  ///< what is proved, and what that means for limits that are left aside
};

/// @throws std::invalid_argument for a query that is not valid or a set without bounds, with all reasons
ConditioningReport globalConditioning(const Machine& machine, const ConditioningTask& task);
}  // namespace pkm_workspace
