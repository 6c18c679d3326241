// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pkm_workspace/ComputeLargestRegion.h>
#include <pkm_workspace/GetRegion.h>
#include <ros/node_handle.h>

#include <memory>
#include <mutex>
#include <optional>
#include <string>

#include "pkm_workspace/ros/parameters.h"
#include "pkm_workspace/ros/region_publisher.h"
#include "pkm_workspace/ros/worker.h"

namespace pkm_workspace
{
/// The node: the largest region of a machine from robot_description, by services and on latched topics.
///
/// Three threads: the one in run() answers what can be answered at once, the worker computes, the painter makes
/// markers, so that no request waits for a picture. They share the last region under a lock, everything else is
/// constant or one thread's own.
class Server
{
public:
  /// Reads and validates everything, then advertises.
  /// @throws std::invalid_argument for bad parameters or a bad URDF, std::runtime_error where arithmetic cannot be
  /// trusted
  Server(const ros::NodeHandle& node, const ros::NodeHandle& private_node);
  ~Server();

  /// Computes the node's own region and serves, until ROS shuts down.
  /// @return whether that first computation worked; otherwise a FATAL line says why
  bool run();

private:
  using RegionConstPtr = std::shared_ptr<const Region>;

  void advertise();
  bool computeLargestRegion(ComputeLargestRegion::Request& request, ComputeLargestRegion::Response& response);
  bool getRegion(GetRegion::Request& request, GetRegion::Response& response);

  void computeFirst();
  /// Computes and keeps what it finds; leaves it to later jobs to show it.
  RegionConstPtr compute(RegionQuery query);
  /// Publishes; leaves the markers to the painter.
  void show(const RegionQuery& query, const RegionConstPtr& region);
  void setLastRegion(const RegionConstPtr& region);
  RegionConstPtr lastRegion() const;

  ros::NodeHandle node_;
  ros::NodeHandle private_node_;
  const Parameters parameters_;
  const UrdfMachine urdf_;
  const std::string frame_;
  Worker worker_;
  Worker painter_;
  std::optional<RegionPublisher> publisher_;
  bool failed_ = false;  ///< the worker's, until it has stopped
  ros::ServiceServer compute_service_;
  ros::ServiceServer get_service_;

  mutable std::mutex mutex_;
  RegionConstPtr last_region_;
};
}  // namespace pkm_workspace
