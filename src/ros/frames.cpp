// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/ros/frames.h"

#include <algorithm>

#include "pkm_workspace/machine/frame.h"
#include "pkm_workspace/ros/reply.h"

namespace pkm_workspace
{
namespace
{
constexpr double PATIENCE = 1.0;  // [s]
constexpr double LOOK = 0.01;     // [s] between two looks

std::string unknownFrame(const std::string& name, const std::string& root, const tf2_ros::Buffer& buffer)
{
  std::vector<std::string> all;
  buffer._getFrameStrings(all);
  const bool exists = std::count(all.begin(), all.end(), name) > 0;
  std::string known = root;
  std::sort(all.begin(), all.end());
  for (const std::string& other : all)
    if (other != root && buffer.canTransform(other, root, ros::Time()))
      known += ", " + other;
  return "header.frame_id = '" + name + "' " +
         (exists ? "is not connected to '" + root + "' in tf" : "is not known to tf") + "; empty stands for '" + root +
         "', and these frames are known: " + known;
}
}  // namespace

std::string bare(const std::string& name)
{
  return name.substr(std::min(name.find_first_not_of('/'), name.size()));
}

Eigen::Isometry3d FramedMachine::toRoot() const
{
  const Eigen::Quaterniond turn(root.orientation.w, root.orientation.x, root.orientation.y, root.orientation.z);
  const Eigen::Vector3d shift(root.position.x, root.position.y, root.position.z);
  return (Eigen::Translation3d(shift) * turn.normalized()).inverse();
}

Frames::Frames(const Machine& machine, const std::string& root)
  : root_{ root, std::make_shared<const Machine>(machine), machine.geometryHash(), geometry_msgs::Pose() }
  , listener_(buffer_)
{
  root_.root.orientation.w = 1.0;
}

geometry_msgs::Pose Frames::rootIn(const std::string& frame, double patience) const
{
  const ros::WallTime end = ros::WallTime::now() + ros::WallDuration(patience);
  while (!buffer_.canTransform(frame, root_.frame, ros::Time()))
  {
    if (ros::WallTime::now() >= end)
      throw Refusal(ErrorCode::UNKNOWN_FRAME, unknownFrame(frame, root_.frame, buffer_));
    ros::WallDuration(LOOK).sleep();
  }
  const geometry_msgs::Transform transform = buffer_.lookupTransform(frame, root_.frame, ros::Time()).transform;
  geometry_msgs::Pose pose;
  pose.position.x = transform.translation.x;
  pose.position.y = transform.translation.y;
  pose.position.z = transform.translation.z;
  pose.orientation = transform.rotation;
  return pose;
}

Eigen::Vector3d Frames::pointInRoot(const std::string& name, const Eigen::Vector3d& point) const
{
  const std::string frame = bare(name);
  if (frame.empty() || frame == root_.frame)
    return point;
  return FramedMachine{ frame, nullptr, "", rootIn(frame, 0.0) }.toRoot() * point;
}

FramedMachine Frames::machineIn(const std::string& name) const
{
  const std::string frame = bare(name);
  if (frame.empty() || frame == root_.frame)
    return root_;
  FramedMachine framed{ frame, nullptr, root_.geometry_hash, rootIn(frame, PATIENCE) };
  const geometry_msgs::Point& position = framed.root.position;
  const geometry_msgs::Quaternion& orientation = framed.root.orientation;
  const Pose pose{ { orientation.x, orientation.y, orientation.z, orientation.w },
                   { position.x, position.y, position.z } };
  framed.machine = std::make_shared<const Machine>(machineInFrame(*root_.machine, pose));
  return framed;
}
}  // namespace pkm_workspace
