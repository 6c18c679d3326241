// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "pkm_workspace/region/placement.h"
#include "pkm_workspace/tasks/path.h"

namespace pkm_workspace
{
/// What is to be placed: a path, or a solid part; and where.
struct PlacementTask
{
  /// Hands out the segments of a path, in their order; unset for a part.
  std::function<void(const std::function<void(const PathStep&)>& use)> for_each = nullptr;
  std::vector<Eigen::Vector3d> vertices = {};  ///< of a part, their convex hull, in place of a path [m]
  std::string part = "the part";               ///< what it is called where it is refused
  PathRatesTask rates = {};                    ///< of a path
  std::optional<double> base_z = {};           ///< height that its lowest point comes to lie at, but for rounding [m]
  std::optional<Eigen::Vector3d> reference = {};  ///< about which it is scaled; the middle of its bounds, on a base at
                                                  ///< their lower end [m]
  PlacementQuery query;                           ///< but for the workpiece, and limits, which follow from the rates
};

struct PlacementReport
{
  PlacementQuery query;  ///< as it was asked
  Placement placement;
  std::string message;  ///< what is proved, and what that means for limits that are left aside
};

/// @throws std::invalid_argument when the task is not valid or has no bounded answer, and what for_each throws
PlacementReport place(const Machine& machine, const PlacementTask& task);
}  // namespace pkm_workspace
