// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pkm_workspace/FindSingularities.h>

#include <optional>

#include "pkm_workspace/dexterity/singularity.h"
#include "pkm_workspace/region/beyond_limits.h"
#include "pkm_workspace/ros/node_context.h"
#include "pkm_workspace/ros/solid_message.h"

namespace pkm_workspace
{
/// ~find_singularities, and ~singularity_markers for those that are proved.
class SingularityService
{
public:
  /// Advertises. @param context has to outlive this object, its threads have to end before
  explicit SingularityService(NodeContext& context);

private:
  /// Where to look, and in which machine: its joint limits stand for the ranges that are asked about.
  struct Question
  {
    SingularityQuery query;
    FramedMachine in;
    std::optional<Solid> solid;  ///< of a region
    Eigen::Vector3d center;      ///< of that
  };

  Question read(const FindSingularities::Request& request) const;
  /// How far the rails go for the points that count, where limits are left aside.
  static std::optional<JointReaches> reachesOf(const Question& question, const Criterion& criterion);
  void find(const FindSingularities::Request& request, FindSingularities::Response& response);

  NodeContext& context_;
  ros::Publisher markers_;
  ros::ServiceServer service_;
};
}  // namespace pkm_workspace
