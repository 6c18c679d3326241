// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pkm_workspace/SetCriterion.h>

#include <functional>

#include "pkm_workspace/ros/node_context.h"

namespace pkm_workspace
{
/// ~set_criterion: what the node computes by itself, changed at run time.
class CriterionService
{
public:
  /// Advertises. @param changed called when there is another criterion
  CriterionService(NodeContext& context, const std::function<void()>& changed);

private:
  void set(const SetCriterion::Request& request, SetCriterion::Response& response);

  NodeContext& context_;
  std::function<void()> changed_;
  ros::ServiceServer service_;
};
}  // namespace pkm_workspace
