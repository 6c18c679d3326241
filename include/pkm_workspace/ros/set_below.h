// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pkm_workspace/Workspace.h>

#include <memory>
#include <mutex>
#include <vector>

#include "pkm_workspace/ros/interaction.h"
#include "pkm_workspace/ros/set_picture.h"
#include "pkm_workspace/tasks/paving.h"

namespace pkm_workspace
{
/// The last paving as far as it lies below all that can be dragged, on ~set_markers, latched. rviz gives the mouse to
/// what is drawn in front: seen from above the horizon, nothing of this is in front of a handle. It is cut anew as the
/// handles move. Thread-safe.
class SetBelow
{
public:
  /// Advertises. The references have to outlive this object, the threads of the context have to end before it.
  SetBelow(NodeContext& context, Interaction& interaction);

  /// @param workspace without its boxes
  void show(const FramedMachine& in, const Workspace& workspace, const std::shared_ptr<const PavingReport>& report,
            const std::shared_ptr<const SetPicture>& set);

private:
  struct Shown
  {
    FramedMachine in;
    Workspace workspace;
    std::shared_ptr<const PavingReport> report;
    std::shared_ptr<const SetPicture> set;
    std::vector<double> tops;  ///< of boxes, ascending [m]
  };

  void cutLater();
  void cut();
  double ceilingFor(const Shown& shown) const;

  NodeContext& context_;
  Interaction& interaction_;
  ros::Publisher markers_;
  std::mutex mutex_;
  std::shared_ptr<const Shown> shown_;
  double ceiling_ = 0.0;  ///< that was drawn last; of the painter
  std::shared_ptr<const Shown> drawn_;
  bool is_waiting_ = false;  ///< a cut
};
}  // namespace pkm_workspace
