// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <interactive_markers/interactive_marker_server.h>

#include <Eigen/Core>
#include <string>
#include <vector>

#include "scene.h"

namespace pkm_workspace
{
/// A ball to be dragged.
struct Handle
{
  std::string name;
  std::string frame;
  Eigen::Vector3d place = Eigen::Vector3d::Zero();  ///< [m]
  double size = 0.0;                                ///< its diameter [m]
  Color color = { 0.5F, 0.5F, 0.5F, 1.0F };
  std::vector<int> axes{};    ///< along which there are arrows
  bool is_free = false;       ///< whether the ball itself can be dragged anywhere
  std::string description{};  ///< shown above it
};

visualization_msgs::InteractiveMarker toMessage(const Handle& handle);
geometry_msgs::Pose poseAt(const Eigen::Vector3d& place);
}  // namespace pkm_workspace
