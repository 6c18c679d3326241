// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pkm_workspace/CheckPath.h>
#include <pkm_workspace/CheckRegion.h>
#include <pkm_workspace/EvaluatePoint.h>

#include <memory>

#include "pkm_workspace/dexterity/point_evaluation.h"
#include "pkm_workspace/ros/node_context.h"

namespace pkm_workspace
{
/// Verdicts for planners: ~check_region, ~check_path, ~evaluate_point. On a thread of their own: they neither wait for
/// computations, nor does what answers at once wait for them.
class PlannerService
{
public:
  /// Advertises. @param context has to outlive this object, its threads have to end before
  explicit PlannerService(NodeContext& context);

private:
  void checkRegion(const CheckRegion::Request& request, CheckRegion::Response& response);
  void checkPath(const CheckPath::Request& request, CheckPath::Response& response);
  void evaluatePoint(const EvaluatePoint::Request& request, EvaluatePoint::Response& response);

  /// Reads frame and criterion, and fills in what the answer holds for.
  /// @return what to ask; kept for the next request, which mostly is about the same
  template <class Response>
  const PointEvaluator& prepare(const std::string& frame, const CriterionRequest& criterion, Response& response);

  NodeContext& context_;
  std::shared_ptr<const Machine> machine_;  ///< of the evaluator; the decider's own, as the next two
  Criterion criterion_;
  std::unique_ptr<const PointEvaluator> evaluator_;
  ros::ServiceServer check_region_;
  ros::ServiceServer check_path_;
  ros::ServiceServer evaluate_point_;
};
}  // namespace pkm_workspace
