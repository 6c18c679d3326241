// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pkm_workspace/CompareMachines.h>

#include "pkm_workspace/ros/node_context.h"

namespace pkm_workspace
{
/// ~compare_machines.
class ComparisonService
{
public:
  /// Advertises. @param context has to outlive this object, its threads have to end before
  explicit ComparisonService(NodeContext& context);

private:
  void compare(const CompareMachines::Request& request, CompareMachines::Response& response);

  NodeContext& context_;
  ros::ServiceServer service_;
};
}  // namespace pkm_workspace
