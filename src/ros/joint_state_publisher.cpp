// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/ros/joint_state_publisher.h"

#include "pkm_workspace/urdf_io/joint_values.h"

namespace pkm_workspace
{
namespace
{
constexpr double PERIOD = 0.05;  // [s]
}  // namespace

JointStatePublisher::JointStatePublisher(ros::NodeHandle& node, const UrdfMachine& urdf) : urdf_(urdf)
{
  moveTo(urdf.machine.zero());
  publisher_ = node.advertise<sensor_msgs::JointState>("joint_states", 1);
  timer_ = node.createWallTimer(ros::WallDuration(PERIOD), [this](const ros::WallTimerEvent&) { publish(); });
}

void JointStatePublisher::moveTo(const Eigen::Vector3d& p)
{
  sensor_msgs::JointState state;
  for (const auto& joint : jointValues(urdf_, p))
  {
    state.name.push_back(joint.first);
    state.position.push_back(joint.second);
  }
  const std::lock_guard<std::mutex> lock(mutex_);
  state_ = state;
}

void JointStatePublisher::publish()
{
  const std::lock_guard<std::mutex> lock(mutex_);
  state_.header.stamp = ros::Time::now();
  publisher_.publish(state_);
}
}  // namespace pkm_workspace
