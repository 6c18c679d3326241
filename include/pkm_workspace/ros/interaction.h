// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

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

private:
  Tool* tool_;
  interactive_markers::InteractiveMarkerServer handles_;
  BoxMarker box_marker_;
  std::optional<ToolMarker> tool_marker_;
};
}  // namespace pkm_workspace
