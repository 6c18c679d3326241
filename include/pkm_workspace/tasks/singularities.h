// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

#include "pkm_workspace/dexterity/singularity.h"
#include "pkm_workspace/region/beyond_limits.h"
#include "pkm_workspace/tasks/placed_solid.h"

namespace pkm_workspace
{
/// What is asked about singularities. Values with defaults: at all points that the struts reach within the joint
/// limits.
struct SingularityTask
{
  SingularityTask();

  /// What is asked of each point that counts.
  Criterion criterion() const;

  std::optional<PlacedSolid> region;  ///< only its points count; without it, all
  SingularityQuery query;             ///< its box and part follow from the region
};

struct SingularityReport
{
  Singularities found;
  std::optional<JointReaches> reaches;  ///< over the points that count, where joint limits are left aside
  std::string message;                  ///< what is proved, and what that means for limits that are left aside

  /// Whether nothing is left open.
  bool isDecided() const;
};

/// @throws std::invalid_argument as findSingularities() of a query
SingularityReport findSingularities(const Machine& machine, SingularityTask task);
}  // namespace pkm_workspace
