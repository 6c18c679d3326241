// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <geometry_msgs/Point.h>
#include <pkm_workspace/Bounds.h>
#include <shape_msgs/SolidPrimitive.h>

#include <optional>

#include "pkm_workspace/common/problems.h"
#include "pkm_workspace/tasks/placed_solid.h"

namespace pkm_workspace
{
/// Reads a box, a sphere, or a cylinder along z, at its center [m].
/// @param problems gets one sentence for a type, dimensions or a center that it cannot have; then there is nothing
std::optional<PlacedSolid> fromMessage(const shape_msgs::SolidPrimitive& message, const geometry_msgs::Point& center,
                                       Problems& problems);
/// The same of a polytope where there are vertices in place of a solid.
std::optional<PlacedSolid> fromMessage(const shape_msgs::SolidPrimitive& message,
                                       const std::vector<geometry_msgs::Point>& vertices,
                                       const geometry_msgs::Point& center, Problems& problems);
/// The same where a request is about a region; where it is not, both fields have to be unset.
std::optional<PlacedSolid> readRegion(bool given, const shape_msgs::SolidPrimitive& message,
                                      const geometry_msgs::Point& center, Problems& problems);

/// NaN twice for the empty set.
Bounds toMessage(const Interval& interval);

/// Appends one sentence unless the point is finite and within FARTHEST.
void requireFinite(const char* name, const Eigen::Vector3d& point, Problems& problems);
}  // namespace pkm_workspace
