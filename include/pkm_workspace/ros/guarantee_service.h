// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pkm_workspace/ComputeGuarantees.h>

#include "pkm_workspace/ros/node_context.h"
#include "pkm_workspace/tasks/guarantee.h"

namespace pkm_workspace
{
/// ~guarantee.
class GuaranteeService
{
public:
  /// Advertises. @param context has to outlive this object, its threads have to end before
  explicit GuaranteeService(NodeContext& context);

private:
  GuaranteeTask read(const ComputeGuarantees::Request& request, const Machine& machine) const;
  void compute(const ComputeGuarantees::Request& request, ComputeGuarantees::Response& response);

  NodeContext& context_;
  ros::ServiceServer service_;
};
}  // namespace pkm_workspace
