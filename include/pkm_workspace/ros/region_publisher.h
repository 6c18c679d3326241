// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pkm_workspace/Region.h>
#include <ros/node_handle.h>

#include <functional>
#include <memory>

#include "pkm_workspace/paving/paving.h"
#include "pkm_workspace/ros/conversions.h"
#include "pkm_workspace/ros/interaction.h"
#include "pkm_workspace/ros/node_context.h"
#include "pkm_workspace/ros/surface_maker.h"
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
  /// Publishes the markers, after a paving (up to seconds) unless it is the last one over again; once more when there
  /// is a surface of the set. Of the painter.
  /// @param stop where it is set, the paving ends, and the markers come without the set
  void publishMarkers(const RegionQuestion& question, const Region& region, const StopFlag& stop);

private:
  void moveMachine(const RegionQuestion& question, const Region& region);
  static Box pavedBox(const RegionQuestion& question, const Region& region);
  PavingQuery pavingQuery(const RegionQuestion& question, const Region& region) const;
  /// The set that the region lies in; nothing where it is not to be shown or cannot be bounded.
  std::shared_ptr<const SetPicture> setFor(const RegionQuestion& question, const Region& region, const StopFlag& stop);
  void draw(const RegionQuestion& question, const Region& region, const SetPicture* set);

  NodeContext& context_;
  Tool* const tool_;
  Interaction& interaction_;
  ros::Publisher region_;
  ros::Publisher joint_ranges_;
  ros::Publisher markers_;
  std::shared_ptr<const Paving> paving_;   ///< the last one
  std::shared_ptr<const SetPicture> set_;  ///< of it
  std::function<void()> draw_again_;       ///< what was drawn last, with the set as it is now
  SurfaceMaker surfaces_;
};
}  // namespace pkm_workspace
