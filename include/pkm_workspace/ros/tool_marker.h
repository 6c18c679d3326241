// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <interactive_markers/interactive_marker_server.h>
#include <visualization_msgs/MarkerArray.h>

#include <functional>
#include <mutex>

#include "pkm_workspace/ros/tool.h"

namespace pkm_workspace
{
/// What rviz shows of a machine with its tool at a point, in the frame of its root link: namespaces "ellipsoid" (tool
/// velocities for joint velocities of 0.1 m/s: green well within the criterion, yellow near its border, red beyond),
/// "travel" (along each rail its joint range and where it stands), "nearest" (the condition that is nearest to its
/// limit) and "reason" (why it is red).
visualization_msgs::MarkerArray toolMarkers(const Machine& machine, const Criterion& criterion, const ToolState& tool,
                                            const std::string& frame);

/// A handle to drag the tool with, among the interactive markers; and ~tool_markers, latched.
class ToolMarker
{
public:
  /// The references have to outlive this object.
  ToolMarker(NodeContext& context, Tool& tool, interactive_markers::InteractiveMarkerServer& handles);

  /// @param moved called after each move, by any thread
  void onMove(const std::function<void()>& moved) { moved_ = moved; }
  /// Of the handle, in the frame of the root link [m].
  Eigen::Vector3d lowestPoint() const;

private:
  void show();

  NodeContext& context_;
  Tool& tool_;
  interactive_markers::InteractiveMarkerServer& handles_;
  std::mutex mutex_;
  ros::Publisher markers_;
  std::function<void()> moved_;
};
}  // namespace pkm_workspace
