// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <interactive_markers/interactive_marker_server.h>
#include <interactive_markers/menu_handler.h>
#include <visualization_msgs/MarkerArray.h>

#include <mutex>

#include "pkm_workspace/interval/box.h"
#include "pkm_workspace/region/containment.h"
#include "pkm_workspace/ros/node_context.h"

namespace pkm_workspace
{
/// What rviz shows of a box that somebody asks about: green where every point is proved to be good, red with a bad
/// point where one is, yellow where neither is proved.
visualization_msgs::MarkerArray boxMarkers(const Box& box, const ContainmentResult& result, const Machine& machine,
                                           const std::string& frame);

/// A box to drag and to scale among the interactive markers, its verdict on ~box_markers, latched; its context menu
/// grows it to the largest box of its proportions at its center. Thread-safe.
class BoxMarker
{
public:
  /// The references have to outlive this object.
  BoxMarker(NodeContext& context, interactive_markers::InteractiveMarkerServer& handles);

  /// Shows the verdict by the node's criterion of now.
  void refresh() { set(box()); }

private:
  using Feedback = visualization_msgs::InteractiveMarkerFeedbackConstPtr;

  void insertHandles();
  void drag(const Feedback& feedback);
  void grow();
  void makeCube();
  /// Changes the box, then shows it with its verdict.
  void set(const Box& box);
  Box box() const;

  NodeContext& context_;
  interactive_markers::InteractiveMarkerServer& handles_;
  interactive_markers::MenuHandler menu_;
  ros::Publisher markers_;
  mutable std::mutex mutex_;
  Box box_;
};
}  // namespace pkm_workspace
