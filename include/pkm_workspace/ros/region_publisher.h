// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pkm_workspace/Region.h>
#include <ros/node_handle.h>

#include <optional>

#include "pkm_workspace/paving/paving.h"
#include "pkm_workspace/ros/conversions.h"
#include "pkm_workspace/ros/interaction.h"
#include "pkm_workspace/ros/node_context.h"
#include "pkm_workspace/ros/set_surface.h"
#include "pkm_workspace/ros/tool.h"

namespace pkm_workspace
{
/// Shows a region to others: latched ~region, ~joint_ranges and ~markers, and the machine at its center on
/// joint_states, until somebody leads its tool. publish() is for one thread, the one that computes; publishMarkers()
/// may be for another.
class RegionPublisher
{
public:
  /// Advertises. The references have to outlive this object.
  /// @param tool what is moved to centers of regions, or nullptr @param interaction whose box is moved into them
  RegionPublisher(NodeContext& context, Tool* tool, Interaction& interaction);

  /// Publishes the region and its joint ranges, and moves the machine there.
  void publish(const RegionQuestion& question, const Region& region);
  /// Publishes the markers, after a paving (up to seconds) unless it is the last one over again.
  /// @param stop where it is set, the paving ends, and the markers come without the set
  void publishMarkers(const RegionQuestion& question, const Region& region, const StopFlag& stop);

private:
  void moveMachine(const RegionQuestion& question, const Region& region);
  static Box pavedBox(const RegionQuestion& question, const Region& region);
  PavingQuery pavingQuery(const RegionQuestion& question, const Region& region) const;
  /// The set that the region lies in; nothing where it is not to be shown or cannot be bounded.
  const SetSurface* setFor(const RegionQuestion& question, const Region& region, const StopFlag& stop);

  NodeContext& context_;
  Tool* const tool_;
  Interaction& interaction_;
  ros::Publisher region_;
  ros::Publisher joint_ranges_;
  ros::Publisher markers_;
  std::optional<Paving> paving_;   ///< the last one
  std::optional<SetSurface> set_;  ///< its surface
};
}  // namespace pkm_workspace
