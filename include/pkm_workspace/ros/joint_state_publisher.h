// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/node_handle.h>
#include <sensor_msgs/JointState.h>

#include <mutex>

#include "pkm_workspace/urdf_io/urdf_reader.h"

namespace pkm_workspace
{
/// Publishes joint_states for the whole closed mechanism, passive joints included, so that a robot_state_publisher
/// shows it assembled. Twenty times a second: it drops what comes much faster, and forgets what does not come again.
/// Thread-safe.
class JointStatePublisher
{
public:
  /// Stands at the zero configuration. @param urdf has to outlive this object
  JointStatePublisher(ros::NodeHandle& node, const UrdfMachine& urdf);

  /// @param p tool point [m] @throws std::invalid_argument where a leg does not reach it; nothing has changed then
  void moveTo(const Eigen::Vector3d& p);

private:
  void publish();

  const UrdfMachine& urdf_;
  std::mutex mutex_;
  sensor_msgs::JointState state_;
  ros::Publisher publisher_;
  ros::WallTimer timer_;
};
}  // namespace pkm_workspace
