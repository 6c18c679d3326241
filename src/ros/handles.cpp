// SPDX-License-Identifier: BSD-3-Clause
#include "handles.h"

#include <cmath>

#include "pkm_workspace/ros/conversions.h"

namespace pkm_workspace
{
namespace
{
using visualization_msgs::InteractiveMarkerControl;

InteractiveMarkerControl ballOf(const Handle& handle)
{
  visualization_msgs::Marker ball;
  ball.type = visualization_msgs::Marker::SPHERE;
  ball.pose.orientation.w = 1.0;
  ball.scale.x = ball.scale.y = ball.scale.z = handle.size;
  ball.color.r = handle.color.r;
  ball.color.g = handle.color.g;
  ball.color.b = handle.color.b;
  ball.color.a = handle.color.a;
  InteractiveMarkerControl control;
  control.name = "ball";
  control.always_visible = true;
  control.orientation.w = 1.0;
  control.interaction_mode = handle.is_free ? InteractiveMarkerControl::MOVE_3D : InteractiveMarkerControl::BUTTON;
  control.markers.push_back(ball);
  return control;
}

/// The arrows point along x of the control: a turn of a third of a circle brings x to another axis.
InteractiveMarkerControl arrowsAlong(int axis)
{
  InteractiveMarkerControl control;
  control.name = std::string("along_") + "xyz"[axis];
  control.interaction_mode = InteractiveMarkerControl::MOVE_AXIS;
  control.orientation.w = std::sqrt(0.5);
  (axis == 0 ? control.orientation.x : axis == 1 ? control.orientation.z : control.orientation.y) = std::sqrt(0.5);
  return control;
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
  message.description = handle.description;
  message.pose = poseAt(handle.place);
  message.scale = static_cast<float>(4.0 * handle.size);
  message.controls.push_back(ballOf(handle));
  for (const int axis : handle.axes)
    message.controls.push_back(arrowsAlong(axis));
  return message;
}
}  // namespace pkm_workspace
