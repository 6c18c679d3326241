// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "pkm_workspace/ros/box_marker.h"
#include "pkm_workspace/ros/tool_marker.h"

namespace pkm_workspace
{
/// What can be dragged in rviz: the tool and a box, on ~interactive_markers.
class Interaction
{
public:
  /// @param tool or nullptr: then there is only the box. The references have to outlive this object.
  Interaction(NodeContext& context, Tool* tool)
    : tool_(tool), handles_(context.private_node.resolveName("interactive_markers")), box_marker_(context, handles_)
  {
    if (tool)
      tool_marker_.emplace(context, *tool, handles_);
  }

  /// Shows everything by the node's criterion of now.
  void refresh()
  {
    box_marker_.refresh();
    if (tool_)
      tool_->refresh();
  }

  /// Puts the box into a region in the frame of the root link, unless somebody has led it.
  void placeBox(const Region& region) { box_marker_.placeIn(region); }

  /// @param moved called after each move, by any thread
  void onMove(const std::function<void()>& moved)
  {
    box_marker_.onMove(moved);
    if (tool_marker_)
      tool_marker_->onMove(moved);
  }
  /// Of all that can be dragged, in the frame of the root link, whose z is meant by low [m]. Thread-safe.
  std::vector<Eigen::Vector3d> lowestPoints() const
  {
    std::vector<Eigen::Vector3d> points = { box_marker_.lowestPoint() };
    if (tool_marker_)
      points.push_back(tool_marker_->lowestPoint());
    return points;
  }

private:
  Tool* tool_;
  interactive_markers::InteractiveMarkerServer handles_;
  BoxMarker box_marker_;
  std::optional<ToolMarker> tool_marker_;
};
}  // namespace pkm_workspace
