// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pkm_workspace/ApproximateWorkspaceAction.h>
#include <pkm_workspace/ComputeWorkspace.h>

#include <memory>
#include <mutex>

#include "pkm_workspace/ros/goal_server.h"
#include "pkm_workspace/ros/node_context.h"
#include "pkm_workspace/ros/paving_message.h"
#include "pkm_workspace/ros/set_below.h"
#include "pkm_workspace/ros/surface_maker.h"

namespace pkm_workspace
{
/// Pavings: ~compute_workspace and ~approximate_workspace, latched ~workspace and ~workspace_markers.
class PavingService
{
public:
  /// Advertises. @param context has to outlive this object, its threads have to end before
  /// @param below shows what the handles leave free
  PavingService(NodeContext& context, SetBelow& below);

private:
  using Action = GoalServer<ApproximateWorkspaceAction>;

  PavingQuestion read(const PavingRequest& request, double longest) const;
  void approximate(const Action::Goal& goal, const StopFlag& stop, const Action::Tell& tell, Action::Result& result);
  Workspace compute(PavingQuestion question, const StopFlag& stop);
  /// Paves, or goes on from the last paving where that is about the same.
  PavingReport goOn(const PavingQuestion& question) const;
  /// Publishes; leaves the markers to the painter.
  void show(const FramedMachine& in, Workspace workspace, const std::shared_ptr<const PavingReport>& report);
  void draw(const FramedMachine& in, const Workspace& workspace, const std::shared_ptr<const PavingReport>& report,
            const std::shared_ptr<const SetPicture>& set);

  NodeContext& context_;
  SetBelow& below_;
  mutable std::mutex mutex_;
  std::shared_ptr<const PavingReport> last_;  ///< of service or action
  ros::Publisher workspace_;
  ros::Publisher markers_;
  SurfaceMaker surfaces_;
  ros::ServiceServer service_;
  Action action_;
};
}  // namespace pkm_workspace
