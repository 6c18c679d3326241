// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/ros/frames.h"

#include <ros/init.h>
#include <tf2/exceptions.h>

#include <algorithm>
#include <optional>
#include <tuple>

#include "pkm_workspace/ros/criterion_message.h"
#include "pkm_workspace/ros/reply.h"
#include "pkm_workspace/ros/worker.h"
#include "pkm_workspace/version.h"

namespace pkm_workspace
{
namespace
{
constexpr double PATIENCE = 1.0;  // [s]
constexpr double LOOK = 0.01;     // [s] between two looks
constexpr int DEEPEST = 1000;     // frames above each other, as in tf

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

/// Looks again for a while, and lets other requests pass.
std::optional<geometry_msgs::Transform> await(const std::string& frame, const std::string& root,
                                              const tf2_ros::Buffer& buffer)
{
  std::optional<geometry_msgs::Transform> known;
  Worker::stepAside([&] {
    const ros::WallTime end = ros::WallTime::now() + ros::WallDuration(PATIENCE);
    while (!known && ros::WallTime::now() < end && !ros::isShuttingDown())
    {
      ros::WallDuration(LOOK).sleep();
      known = lookUp(frame, root, buffer);
    }
  });
  return known;
}
}  // namespace

std::string bare(const std::string& name)
{
  return name.substr(std::min(name.find_first_not_of('/'), name.size()));
}

Eigen::Isometry3d FramedMachine::toRoot() const
{
  const Eigen::Quaterniond turn(root.orientation.data());  // x, y, z, w
  return (Eigen::Translation3d(root.translation) * turn.normalized()).inverse();
}

Premises FramedMachine::premises(const Criterion& criterion) const
{
  return premisesIn(root, *machine, geometry_hash, criterion);
}

Criterion FramedMachine::seen(Criterion criterion) const
{
  criterion.zones = seenFrom(root, criterion.zones);
  return criterion;
}

Frames::Frames(const Machine& machine, const std::string& root, const std::vector<std::string>& moved)
  : root_{ root, std::make_shared<const Machine>(machine), machine.geometryHash(), Pose() }
  , moved_(moved.begin(), moved.end())
  , listener_(buffer_)
{}

std::string Frames::moverOf(const std::string& frame) const
{
  std::string name = frame;
  for (int depth = 0; depth < DEEPEST && name != root_.frame; ++depth)
  {
    if (moved_.count(name) > 0)
      return name;
    std::string parent;
    if (!buffer_._getParent(name, ros::Time(), parent))
      break;
    name = parent;
  }
  return "";
}

std::string Frames::known() const
{
  std::vector<std::string> all;
  buffer_._getFrameStrings(all);
  std::sort(all.begin(), all.end());
  std::string names = root_.frame;
  for (const std::string& name : all)
    if (name != root_.frame && buffer_.canTransform(name, root_.frame, ros::Time()) && moverOf(name).empty())
      names += ", " + name;
  return names;
}

Pose Frames::rootIn(const std::string& frame, bool patiently) const
{
  std::optional<geometry_msgs::Transform> found = lookUp(frame, root_.frame, buffer_);
  if (!found && patiently)
    found = await(frame, root_.frame, buffer_);
  if (!found)
    throw Refusal(
        ErrorCode::UNKNOWN_FRAME,
        "header.frame_id = '" + frame + "' " +
            (buffer_._frameExists(frame) ? "is not connected to '" + root_.frame + "' in tf" : "is not known to tf") +
            "; empty stands for '" + root_.frame + "', and these frames are known: " + known());
  const auto& [translation, rotation] = std::tie(found->translation, found->rotation);
  return { { rotation.x, rotation.y, rotation.z, rotation.w }, { translation.x, translation.y, translation.z } };
}

Eigen::Vector3d Frames::pointInRoot(const std::string& name, const Eigen::Vector3d& point) const
{
  const std::string frame = bare(name);
  if (frame.empty() || frame == root_.frame)
    return point;
  return FramedMachine{ frame, nullptr, "", rootIn(frame, false) }.toRoot() * point;
}

void Frames::requireStill(const std::string& frame) const
{
  const std::string mover = moverOf(frame);
  if (!mover.empty())
    throw Refusal(ErrorCode::INVALID_REQUEST,
                  "header.frame_id = '" + frame + "' " + (mover == frame ? "" : "hangs at '" + mover + "', which ") +
                      "moves with the machine: name a frame that stands still, such as " + known());
}

FramedMachine Frames::machineIn(const std::string& name, const CriterionRequest& request) const
{
  const std::string frame = bare(name);
  FramedMachine framed = root_;
  if (const std::optional<Machine> asked = machineOf(request, *root_.machine))
  {
    framed.machine = std::make_shared<const Machine>(*asked);
    framed.geometry_hash = framed.machine->geometryHash();
  }
  if (frame.empty() || frame == root_.frame)
    return framed;
  requireStill(frame);
  framed.frame = frame;
  framed.root = rootIn(frame, true);
  requireStill(frame);  // tf may not have known before where it hangs
  framed.machine = std::make_shared<const Machine>(machineInFrame(*framed.machine, framed.root));
  return framed;
}
}  // namespace pkm_workspace
