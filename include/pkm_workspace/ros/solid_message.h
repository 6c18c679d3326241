// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pkm_workspace/Bounds.h>
#include <shape_msgs/SolidPrimitive.h>

#include "pkm_workspace/region/solid.h"

namespace pkm_workspace
{
/// Reads a box, a sphere, or a cylinder along z.
/// @throws std::invalid_argument with the dimensions and what they must be, or with another type
Solid fromMessage(const shape_msgs::SolidPrimitive& message);

/// NaN twice for the empty set.
Bounds toMessage(const Interval& interval);

/// Appends one sentence unless the point is finite and within FARTHEST.
void requireFinite(const char* name, const Eigen::Vector3d& point, Problems& problems);
}  // namespace pkm_workspace
