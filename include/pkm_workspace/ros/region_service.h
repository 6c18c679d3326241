// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pkm_workspace/FindLargestRegionAction.h>
#include <pkm_workspace/Region.h>

#include <memory>
#include <mutex>

#include "pkm_workspace/ros/conversions.h"
#include "pkm_workspace/ros/goal_server.h"
#include "pkm_workspace/ros/node_context.h"
#include "pkm_workspace/ros/region_publisher.h"

namespace pkm_workspace
{
/// The largest region: ~compute_largest_region, ~find_largest_region, ~get_region, and what RegionPublisher shows.
class RegionService
{
public:
  /// Advertises. @param context has to outlive this object, its threads have to end before
  /// @param tool what is moved to centers of regions, or nullptr @param interaction whose box is moved into them
  RegionService(NodeContext& context, Tool* tool, Interaction& interaction);

  /// Computes the node's own region, later; ends that computation, and the pictures, that still run.
  void computeOwn();
  /// Takes what was found of the node's own region, and shows it.
  void adopt(const LargestRegion& region);
  /// Whether the first computation has failed: a FATAL line has said why.
  bool hasFailed() const { return failed_; }

private:
  using RegionConstPtr = std::shared_ptr<const Region>;
  using Action = GoalServer<FindLargestRegionAction>;

  RegionQuestion read(const RegionRequest& request, double longest) const;
  void find(const Action::Goal& goal, const StopFlag& stop, const Action::Tell& tell, Action::Result& result);
  void computeOwn(const StopFlag& stop);
  /// Computes and, unless it was cancelled, keeps what it finds; leaves it to later jobs to show it.
  RegionConstPtr compute(RegionQuestion question, const StopFlag& stop);
  /// Keeps an answer, and leaves it to later jobs to show it.
  void keep(RegionQuestion question, const RegionConstPtr& region);
  /// Publishes; leaves the markers to the painter.
  void show(const RegionQuestion& question, const RegionConstPtr& region);
  RegionConstPtr lastRegion() const;

  NodeContext& context_;
  mutable std::mutex mutex_;
  RegionConstPtr last_region_;
  StopFlag own_;       ///< of the node's own computation
  StopFlag pictures_;  ///< of what the painter has to do

  RegionPublisher publisher_;
  std::atomic<bool> failed_{ false };
  ros::ServiceServer compute_service_;
  ros::ServiceServer get_service_;
  Action action_;
};
}  // namespace pkm_workspace
