// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pkm_workspace/PlacePath.h>

#include "pkm_workspace/ros/node_context.h"
#include "pkm_workspace/tasks/placement.h"

namespace pkm_workspace
{
/// ~place_path.
class PlacementService
{
public:
  /// Advertises. @param context has to outlive this object, its threads have to end before
  explicit PlacementService(NodeContext& context);

private:
  PlacementTask read(const PlacePath::Request& request, const Machine& machine) const;
  void compute(const PlacePath::Request& request, PlacePath::Response& response);

  NodeContext& context_;
  ros::ServiceServer service_;
};
}  // namespace pkm_workspace
