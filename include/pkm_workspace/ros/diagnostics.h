// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <diagnostic_updater/diagnostic_updater.h>

#include "pkm_workspace/ros/node_context.h"

namespace pkm_workspace
{
/// What the node tells on /diagnostics once a second (REP-107): its geometry, and whether robot_description still is
/// the one that it read, its last computation, its refusals, the clock. What is wrong with the system is logged once.
class Diagnostics
{
public:
  explicit Diagnostics(NodeContext& context);

private:
  using Status = diagnostic_updater::DiagnosticStatusWrapper;

  void tellGeometry(Status& status) const;
  void tellComputation(Status& status) const;
  void tellRefusals(Status& status) const;
  void tellClock(Status& status) const;
  /// Looks at what others may have changed.
  void look();

  NodeContext& context_;
  diagnostic_updater::Updater updater_;
  bool is_description_changed_ = false;
  bool is_without_clock_ = false;
  ros::WallTime start_ = ros::WallTime::now();
  ros::WallTimer timer_;
};
}  // namespace pkm_workspace
