// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pkm_workspace/Reload.h>
#include <ros/callback_queue.h>

#include <condition_variable>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>

#include "pkm_workspace/ros/server.h"

namespace pkm_workspace
{
/// The server for the machine of robot_description, and ~reload, which puts one for another machine in its place.
class Node
{
public:
  /// As Server.
  Node(const ros::NodeHandle& node, const ros::NodeHandle& private_node);
  ~Node();

  /// Serves until ROS shuts down. @return as Server::run()
  bool run();

private:
  struct Next
  {
    Loaded loaded;
    LargestRegion region;
  };

  void reload(Reload::Response& response);
  /// Hands it to the thread that serves, and waits until it is in its place.
  void replace(Next next);
  void stop();

  ros::NodeHandle node_;
  ros::NodeHandle private_node_;
  std::mutex mutex_;  ///< of the next three
  std::condition_variable changed_;
  std::unique_ptr<Server> server_;
  std::optional<Next> next_;
  std::atomic<bool> stopped_{ false };
  Health health_;  ///< refusals of ~reload are logged
  ros::CallbackQueue queue_;
  ros::ServiceServer service_;
  std::thread thread_;
};
}  // namespace pkm_workspace
