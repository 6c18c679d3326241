// SPDX-License-Identifier: BSD-3-Clause
#include "handles.h"

#include <cmath>

#include "pkm_workspace/ros/conversions.h"

namespace pkm_workspace
{
namespace
{
using visualization_msgs::InteractiveMarkerControl;

/// rviz moves what is grabbed along x of its control: a turn of a third of a circle brings x to another axis.
geometry_msgs::Quaternion turnTo(int axis)
{
  geometry_msgs::Quaternion turn;
  turn.w = std::sqrt(0.5);
  (axis == 0 ? turn.x : axis == 1 ? turn.z : turn.y) = std::sqrt(0.5);
  return turn;
}

InteractiveMarkerControl along(int axis)
{
  InteractiveMarkerControl control;
  control.name = std::string("along_") + "xyz"[axis];
  control.interaction_mode = InteractiveMarkerControl::MOVE_AXIS;
  control.orientation = turnTo(axis);
  return control;
}

InteractiveMarkerControl anywhere()
{
  InteractiveMarkerControl control;
  control.name = "anywhere";
  control.interaction_mode = InteractiveMarkerControl::MOVE_3D;
  control.orientation.w = 1.0;
  return control;
}

visualization_msgs::Marker bodyOf(const Handle& handle)
{
  visualization_msgs::Marker body;
  body.type = handle.type;
  body.pose.orientation.w = 1.0;
  body.scale.x = handle.size.x();
  body.scale.y = handle.size.y();
  body.scale.z = handle.size.z();
  body.color = toMessage(handle.color);
  return body;
}
}  // namespace

geometry_msgs::Pose poseAt(const Eigen::Vector3d& place)
{
  geometry_msgs::Pose pose;
  pose.position = toMessage(place);
  pose.orientation.w = 1.0;
  return pose;
}

visualization_msgs::InteractiveMarker toMessage(const Handle& handle)
{
  visualization_msgs::InteractiveMarker message;
  message.header.frame_id = handle.frame;
  message.name = handle.name;
  message.pose = poseAt(handle.place);
  message.scale = static_cast<float>(handle.arrows);
  message.controls.push_back(handle.axis ? along(*handle.axis) : anywhere());
  message.controls.back().always_visible = true;
  message.controls.back().markers.push_back(bodyOf(handle));
  if (handle.arrows > 0.0)
    for (int axis = 0; axis < 3; ++axis)
      message.controls.push_back(along(axis));
  for (const std::string& title : handle.menu)
  {
    visualization_msgs::MenuEntry entry;
    entry.id = static_cast<unsigned>(message.menu_entries.size() + 1);
    entry.title = title;
    message.menu_entries.push_back(entry);
  }
  return message;
}
}  // namespace pkm_workspace
