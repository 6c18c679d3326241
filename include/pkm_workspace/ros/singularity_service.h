// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pkm_workspace/FindSingularities.h>

#include "pkm_workspace/ros/node_context.h"
#include "pkm_workspace/tasks/singularities.h"

namespace pkm_workspace
{
/// ~find_singularities, and ~singularity_markers for those that are proved.
class SingularityService
{
public:
  /// Advertises. @param context has to outlive this object, its threads have to end before
  explicit SingularityService(NodeContext& context);

private:
  /// Where to look, and in which machine: the ranges that are asked about are the limits of its joints, and what the
  /// answer is proved of.
  struct Question
  {
    SingularityTask task;
    FramedMachine in;
  };

  Question read(const FindSingularities::Request& request) const;
  void find(const FindSingularities::Request& request, FindSingularities::Response& response);

  NodeContext& context_;
  ros::Publisher markers_;
  ros::ServiceServer service_;
};
}  // namespace pkm_workspace
