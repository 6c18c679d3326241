// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <diagnostic_updater/diagnostic_updater.h>

#include "pkm_workspace/ros/node_context.h"

namespace pkm_workspace
{
/// What the node tells on /diagnostics once a second (REP-107): its geometry, its last computation, its refusals.
class Diagnostics
{
public:
  explicit Diagnostics(NodeContext& context);

private:
  using Status = diagnostic_updater::DiagnosticStatusWrapper;

  void tellGeometry(Status& status) const;
  void tellComputation(Status& status) const;
  void tellRefusals(Status& status) const;

  NodeContext& context_;
  diagnostic_updater::Updater updater_;
  ros::WallTimer timer_;
};
}  // namespace pkm_workspace
