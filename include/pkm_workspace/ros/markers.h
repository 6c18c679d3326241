// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pkm_workspace/Region.h>
#include <pkm_workspace/Workspace.h>
#include <visualization_msgs/MarkerArray.h>

#include <array>
#include <limits>

#include "pkm_workspace/machine/machine.h"
#include "pkm_workspace/ros/frames.h"
#include "pkm_workspace/ros/set_picture.h"

namespace pkm_workspace
{
/// The joint values that each rail is drawn between in a URDF: labels stand beyond them. Empty where it is not drawn.
using DrawnRails = std::array<Interval, 3>;

/// What rviz shows of a region, in the frame of its message: it replaces all that was shown before.
///
/// Namespaces: "region" (its faces and edges, a label), "paving_inside" and "paving_boundary" (their surface),
/// "joint_ranges" (a bar from slider point to slider point along each rail, a label with its stroke), "zones" (to keep
/// within, or out of). What it holds for
/// is told by the text of the marker that clears.
/// @param premises what is proved of it
/// @param set that the region lies in, or nullptr
visualization_msgs::MarkerArray markersOf(const Region& region, const Premises& premises, const Machine& machine,
                                          const DrawnRails& rails, const SetPicture* set);

/// What rviz shows of a set by itself, in namespaces "inside" and "boundary" (all that is undecided).
/// @param premises what is proved of it, in the frame of the machine
/// @param workspace the message about it
/// @param ceiling what reaches above it is left out [m]; a flat set that is the same along z is lowered to it
visualization_msgs::MarkerArray markersOf(const SetPicture& set, const Premises& premises, const Machine& machine,
                                          const Workspace& workspace,
                                          double ceiling = std::numeric_limits<double>::infinity());

/// Where there is room for what the pictures hold for, below machine and region, in the frame of the region's message.
Eigen::Vector3d placeOfHypotheses(const Region& region, const Machine& machine, const DrawnRails& rails);

/// The same markers in the frame of the root link, where they stay when the frame that was asked for moves: what is
/// proved holds for where the machine stood in it.
visualization_msgs::MarkerArray inRoot(visualization_msgs::MarkerArray array, const FramedMachine& in,
                                       const std::string& root);
}  // namespace pkm_workspace
