// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pkm_workspace/ComputeConditioning.h>

#include "pkm_workspace/ros/node_context.h"
#include "pkm_workspace/tasks/conditioning.h"

namespace pkm_workspace
{
/// ~compute_conditioning.
class ConditioningService
{
public:
  /// Advertises. @param context has to outlive this object, its threads have to end before
  explicit ConditioningService(NodeContext& context);

private:
  ConditioningTask read(const ComputeConditioning::Request& request) const;
  void compute(const ComputeConditioning::Request& request, ComputeConditioning::Response& response);

  NodeContext& context_;
  ros::ServiceServer service_;
};
}  // namespace pkm_workspace
