// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <memory>
#include <optional>

#include "pkm_workspace/ros/comparison_service.h"
#include "pkm_workspace/ros/conditioning_service.h"
#include "pkm_workspace/ros/criterion_service.h"
#include "pkm_workspace/ros/diagnostics.h"
#include "pkm_workspace/ros/guarantee_service.h"
#include "pkm_workspace/ros/interaction.h"
#include "pkm_workspace/ros/node_context.h"
#include "pkm_workspace/ros/paving_service.h"
#include "pkm_workspace/ros/placement_service.h"
#include "pkm_workspace/ros/planner_service.h"
#include "pkm_workspace/ros/region_service.h"
#include "pkm_workspace/ros/singularity_service.h"

namespace pkm_workspace
{
/// The node: all that can be asked about the machine from robot_description, by services and on latched topics.
class Server
{
public:
  /// Advertises. @param region of the node's own, where it is known; else it is computed
  Server(const ros::NodeHandle& node, const ros::NodeHandle& private_node, const Loaded& loaded,
         const std::optional<LargestRegion>& region = std::nullopt);
  ~Server();

  /// Computes the node's own region and serves, until ROS shuts down or end() is called, by any thread.
  /// @return whether that first computation worked; otherwise a FATAL line says why
  bool run();
  void end() { ended_ = true; }

private:
  std::atomic<bool> ended_{ false };
  NodeContext context_;
  std::unique_ptr<Tool> tool_;
  Interaction interaction_;
  SetBelow below_;
  RegionService regions_;
  PavingService pavings_;
  SingularityService singularities_;
  ConditioningService conditioning_;
  GuaranteeService guarantee_;
  PlacementService placement_;
  ComparisonService comparisons_;
  PlannerService planning_;
  CriterionService criterion_;
  Diagnostics diagnostics_;
};
}  // namespace pkm_workspace
