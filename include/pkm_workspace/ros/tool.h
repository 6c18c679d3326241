// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <geometry_msgs/PoseStamped.h>
#include <sensor_msgs/JointState.h>

#include <atomic>
#include <functional>
#include <mutex>
#include <string>

#include "pkm_workspace/ros/joint_state_publisher.h"
#include "pkm_workspace/ros/node_context.h"

namespace pkm_workspace
{
/// Where the tool of the model stands.
struct ToolState
{
  Eigen::Vector3d point = Eigen::Vector3d::Zero();  ///< in the frame of the root link [m]
  std::string objection;                            ///< why it is not where it was wanted; empty where it is
};

/// The model on joint_states follows ~tool_pose, the three rails on ~rail_states, and whoever calls moveTo(). It goes
/// as far as the mechanism can be assembled: within the struts' reach, the aspect of the node's criterion, and the
/// joint limits where that asks for them. Thread-safe.
class Tool
{
public:
  /// Subscribes and advertises. @param context has to outlive this object
  /// @throws std::invalid_argument where ~rail_states is the topic that it publishes on
  explicit Tool(NodeContext& context);

  /// @param moved called after each move, by any thread
  void onMove(const std::function<void()>& moved) { moved_ = moved; }
  /// Moves towards a point in the frame of the root link [m], up to the border where it cannot go there, unless a
  /// handle, a pose or rails have led the tool: it is theirs then, and no computation moves it.
  ToolState moveTo(const Eigen::Vector3d& p);
  /// The same for somebody who leads the tool.
  ToolState lead(const Eigen::Vector3d& p);
  /// Tells again what the node's criterion of now says about where the tool is.
  void refresh();
  ToolState state() const;

private:
  void follow(const geometry_msgs::PoseStamped& pose);
  void follow(const sensor_msgs::JointState& rails);
  /// The sign of det A with which rails are assembled: the one that the node's criterion asks for, with both aspects
  /// the one where the tool is.
  int aspect() const;
  /// As far as there is an assembly on the way to these joint values.
  void stopBefore(Eigen::Vector3d bad);
  /// @param is_computed whether nobody leads it there
  ToolState go(const ToolState& state, bool is_computed);
  ToolState placeTowards(const Eigen::Vector3d& p) const;
  /// Why the mechanism cannot be assembled there; empty where it can.
  std::string objectionTo(const Eigen::Vector3d& p) const;
  /// The last point on the way from @p good to @p bad, to rounding, and what is in the way there.
  ToolState border(Eigen::Vector3d good, Eigen::Vector3d bad) const;

  NodeContext& context_;
  JointStatePublisher joint_states_;
  std::function<void()> moved_;
  std::atomic<bool> is_led_{ false };
  mutable std::mutex mutex_;
  ToolState state_;
  ros::Subscriber pose_;
  ros::Subscriber rails_;
};
}  // namespace pkm_workspace
