// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pkm_workspace/CheckGcode.h>
#include <pkm_workspace/CheckPath.h>
#include <pkm_workspace/CheckRegion.h>
#include <pkm_workspace/EvaluatePoint.h>
#include <pkm_workspace/ExportLimits.h>

#include <memory>
#include <mutex>

#include "pkm_workspace/dexterity/point_evaluation.h"
#include "pkm_workspace/ros/crew.h"
#include "pkm_workspace/ros/criterion_message.h"
#include "pkm_workspace/ros/node_context.h"

namespace pkm_workspace
{
/// Verdicts for planners: ~check_region, ~check_path, ~check_gcode, ~evaluate_point; and ~export_limits. They neither
/// wait for computations, nor does what answers at once wait for them. Points have a thread of their own, regions and
/// paths some: these may be long.
class PlannerService
{
public:
  /// Advertises. @param context has to outlive this object, its decider has to end before
  explicit PlannerService(NodeContext& context);
  /// Ends what is being checked.
  ~PlannerService();

private:
  void checkRegion(const CheckRegion::Request& request, CheckRegion::Response& response);
  void checkPath(const CheckPath::Request& request, CheckPath::Response& response);
  void checkGcode(const CheckGcode::Request& request, CheckGcode::Response& response);
  void exportLimits(const ExportLimits::Request& request, ExportLimits::Response& response);
  void evaluatePoint(const EvaluatePoint::Request& request, EvaluatePoint::Response& response);

  using EvaluatorPtr = std::shared_ptr<const PointEvaluator>;

  /// Reads frame and criterion, and fills in what the answer holds for. @return what to ask
  template <class Response>
  EvaluatorPtr prepare(const std::string& frame, const CriterionRequest& criterion, Response& response,
                       JointUse use = JointUse::BOUNDS);
  /// The same in a frame that is known, and without the header.
  template <class Response>
  EvaluatorPtr prepare(const FramedMachine& in, const CriterionRequest& criterion, Response& response, JointUse use);
  /// How many boxes a check may look at, within the node's time limit.
  Budget budgetOf(std::int64_t max_boxes, Problems& problems) const;
  /// Keeps the last one for the next request, which mostly is about the same.
  EvaluatorPtr evaluatorFor(const Machine& machine, const Premises& premises);

  NodeContext& context_;
  Crew crew_{ 8 };
  ros::NodeHandle checking_;  ///< for services of the crew
  std::mutex mutex_;          ///< of the next two
  Premises premises_;         ///< of the evaluator
  EvaluatorPtr evaluator_;
  ros::ServiceServer check_region_;
  ros::ServiceServer check_path_;
  ros::ServiceServer check_gcode_;
  ros::ServiceServer export_limits_;
  ros::ServiceServer evaluate_point_;
};
}  // namespace pkm_workspace
