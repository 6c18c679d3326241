// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <interactive_markers/interactive_marker_server.h>

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "scene.h"

namespace pkm_workspace
{
/// What is around something that is drawn by other markers, so that the mouse finds it.
constexpr Color BARELY_VISIBLE = { 1.0F, 1.0F, 1.0F, 0.02F };

/// A ball or a box to be grabbed and dragged.
struct Handle
{
  std::string name;
  std::string frame;
  Eigen::Vector3d place = Eigen::Vector3d::Zero();  ///< [m]
  int type = visualization_msgs::Marker::SPHERE;    ///< or CUBE
  Eigen::Vector3d size = Eigen::Vector3d::Zero();   ///< of what is drawn [m]
  Color color = { 0.35F, 0.35F, 0.4F, 1.0F };
  std::optional<int> axis{};        ///< the only one along which it moves; none: it moves across the view
  double arrows = 0.0;              ///< how far arrows reach along all axes [m]; 0: there are none
  std::vector<std::string> menu{};  ///< entries of its context menu, numbered from 1
};

visualization_msgs::InteractiveMarker toMessage(const Handle& handle);
geometry_msgs::Pose poseAt(const Eigen::Vector3d& place);
}  // namespace pkm_workspace
