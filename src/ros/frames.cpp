// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/ros/frames.h"

#include <tf2/exceptions.h>

#include <algorithm>
#include <iterator>
#include <optional>

#include "pkm_workspace/machine/frame.h"
#include "pkm_workspace/ros/reply.h"

namespace pkm_workspace
{
namespace
{
constexpr double PATIENCE = 1.0;  // [s]
constexpr double REST = 10.0;     // [s] from the beginning of one wait to the next for the same name
constexpr std::size_t MOST_NAMES = 16;
constexpr std::size_t LONGEST_NAME = 256;
constexpr double LOOK = 0.01;  // [s] between two looks

std::optional<geometry_msgs::Transform> lookUp(const std::string& frame, const std::string& root,
                                               const tf2_ros::Buffer& buffer)
{
  try
  {
    return buffer.lookupTransform(frame, root, ros::Time()).transform;
  }
  catch (const tf2::TransformException&)
  {
    return std::nullopt;
  }
}

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

geometry_msgs::Pose Frames::rootIn(const std::string& frame, bool patiently) const
{
  std::optional<geometry_msgs::Transform> known = lookUp(frame, root_.frame, buffer_);
  if (!known && patiently && mayWait(frame))
  {
    const ros::WallTime end = ros::WallTime::now() + ros::WallDuration(PATIENCE);
    while (!known && ros::WallTime::now() < end)
    {
      ros::WallDuration(LOOK).sleep();
      known = lookUp(frame, root_.frame, buffer_);
    }
  }
  if (!known)
    throw Refusal(ErrorCode::UNKNOWN_FRAME, unknownFrame(frame, root_.frame, buffer_));
  const geometry_msgs::Transform& transform = *known;
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
  return FramedMachine{ frame, nullptr, "", rootIn(frame, false) }.toRoot() * point;
}

bool Frames::mayWait(const std::string& frame) const
{
  const ros::WallTime now = ros::WallTime::now();
  const std::lock_guard<std::mutex> lock(mutex_);
  for (auto name = waited_.begin(); name != waited_.end();)
    name = now - name->second > ros::WallDuration(REST) ? waited_.erase(name) : std::next(name);
  const auto earlier = waited_.find(frame);
  if (earlier != waited_.end())
    return now - earlier->second < ros::WallDuration(PATIENCE);
  return waited_.size() < MOST_NAMES && frame.size() < LONGEST_NAME && waited_.emplace(frame, now).second;
}

FramedMachine Frames::machineIn(const std::string& name) const
{
  const std::string frame = bare(name);
  if (frame.empty() || frame == root_.frame)
    return root_;
  FramedMachine framed{ frame, nullptr, root_.geometry_hash, rootIn(frame, true) };
  const geometry_msgs::Point& position = framed.root.position;
  const geometry_msgs::Quaternion& orientation = framed.root.orientation;
  const Pose pose{ { orientation.x, orientation.y, orientation.z, orientation.w },
                   { position.x, position.y, position.z } };
  framed.machine = std::make_shared<const Machine>(machineInFrame(*root_.machine, pose));
  return framed;
}
}  // namespace pkm_workspace
