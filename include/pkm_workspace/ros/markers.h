// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pkm_workspace/Region.h>
#include <pkm_workspace/Workspace.h>
#include <visualization_msgs/MarkerArray.h>

#include "pkm_workspace/machine/machine.h"
#include "pkm_workspace/paving/paving.h"
#include "pkm_workspace/ros/frames.h"

namespace pkm_workspace
{
/// What rviz shows of a region, in the frame of its message: it replaces all that was shown before.
///
/// Namespaces: "region" (its faces and edges, a label), "paving_inside" and "paving_boundary" (one list for each size
/// of boxes), "joint_ranges" (a bar from slider point to slider point along each rail, a label with its stroke),
/// "hypotheses" (what it holds for).
/// @param premises what is proved of it
/// @param paving of the set that the region lies in, or nullptr
/// @param show_boundary whether its undecided boxes are shown too
visualization_msgs::MarkerArray markersOf(const Region& region, const Premises& premises, const Machine& machine,
                                          const Paving* paving, bool show_boundary);

/// What rviz shows of a paving by itself, in namespaces "inside" and "boundary" (all that is undecided).
/// @param premises what is proved of it, in the frame of the machine
visualization_msgs::MarkerArray markersOf(const Paving& paving, const Premises& premises, const Machine& machine,
                                          const Workspace& workspace);

/// The same markers in the frame of the root link, where they stay when the frame that was asked for moves: what is
/// proved holds for where the machine stood in it.
visualization_msgs::MarkerArray inRoot(visualization_msgs::MarkerArray array, const FramedMachine& in,
                                       const std::string& root);
}  // namespace pkm_workspace
