// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pkm_workspace/Region.h>
#include <ros/node_handle.h>

#include <atomic>
#include <optional>

#include "pkm_workspace/paving/paving.h"
#include "pkm_workspace/ros/joint_state_publisher.h"
#include "pkm_workspace/ros/parameters.h"

namespace pkm_workspace
{
/// Shows a region to others: latched ~region, ~joint_ranges and ~markers, and the machine at its center on
/// joint_states. publish() is for one thread, the one that computes; publishMarkers() may be for another.
class RegionPublisher
{
public:
  /// Advertises. The references have to outlive this object. @param stop ends pavings
  RegionPublisher(ros::NodeHandle& node, ros::NodeHandle& private_node, const Parameters& parameters,
                  const UrdfMachine& urdf, const std::atomic<bool>& stop);

  /// Publishes the region and its joint ranges, and moves the machine there.
  void publish(const Region& region);
  /// Publishes the markers, after a paving (up to seconds) unless it is the last one over again.
  void publishMarkers(const RegionQuery& query, const Region& region);

private:
  void moveMachine(const Region& region);
  PavingQuery pavingQuery(const RegionQuery& query) const;
  /// The set that the region lies in; nothing where it is not to be shown or cannot be bounded.
  const Paving* pavingFor(const RegionQuery& query);

  const Parameters& parameters_;
  const UrdfMachine& urdf_;
  const std::atomic<bool>& stop_;
  ros::Publisher region_;
  ros::Publisher joint_ranges_;
  ros::Publisher markers_;
  std::optional<JointStatePublisher> joint_states_;
  std::optional<PavingQuery> paved_;  ///< what paving_ answers
  std::optional<Paving> paving_;
};
}  // namespace pkm_workspace
