// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/ros/planner_service.h"

#include "pkm_workspace/region/containment.h"
#include "pkm_workspace/report/binding_limit.h"
#include "pkm_workspace/ros/conversions.h"
#include "pkm_workspace/ros/criterion_message.h"
#include "pkm_workspace/ros/path_message.h"
#include "pkm_workspace/ros/reply.h"
#include "pkm_workspace/ros/solid_message.h"
#include "pkm_workspace/ros/verdict_message.h"

namespace pkm_workspace
{
namespace
{
constexpr std::int64_t MAX_BOXES = 1000000;

std::string sentence(const ContainmentResult& result, const PointEvaluator& evaluator)
{
  if (result.verdict == Containment::INSIDE)
    return "proved: every point of the region satisfies the criterion";
  if (result.verdict == Containment::UNDECIDED)
    return "undecided: the border is within rounding, or more boxes are needed";
  return "proved: the bad point violates the criterion; " +
         describe(evaluator(*result.bad_point).binding(), evaluator.machine());
}
}  // namespace

PlannerService::PlannerService(NodeContext& context)
  : context_(context)
  , check_region_(offer<CheckRegion>(context.deciding, context.health, "check_region",
                                     [this](const auto& request, auto& response) { checkRegion(request, response); }))
  , check_path_(offer<CheckPath>(context.deciding, context.health, "check_path",
                                 [this](const auto& request, auto& response) { checkPath(request, response); }))
  , evaluate_point_(
        offer<EvaluatePoint>(context.deciding, context.health, "evaluate_point",
                             [this](const auto& request, auto& response) { evaluatePoint(request, response); }))
{}

template <class Response>
const PointEvaluator& PlannerService::prepare(const std::string& frame, const CriterionRequest& request,
                                              Response& response)
{
  const FramedMachine in = context_.frames.machineIn(frame);
  Problems problems;
  const Criterion criterion = fromMessage(request, context_.query().criterion, problems);
  criterion.validate(problems);
  throwProblems(problems);
  if (!evaluator_ || machine_ != in.machine || !(criterion_ == criterion))
  {
    evaluator_ = std::make_unique<const PointEvaluator>(*in.machine, criterion);
    machine_ = in.machine;
    criterion_ = criterion;
  }
  response.header = headerOf(in, ros::Time::now());
  response.hypotheses = hypothesesOf(in, criterion, 0.0);
  return *evaluator_;
}

void PlannerService::checkRegion(const CheckRegion::Request& request, CheckRegion::Response& response)
{
  const PointEvaluator& evaluator = prepare(request.header.frame_id, request.criterion, response);
  Problems problems;
  const Solid solid = fromMessage(request.solid);
  const Eigen::Vector3d center = fromMessage(request.center);
  requireFinite("center", center, problems);
  if (request.max_boxes < 0)
    problems.push_back("max_boxes = " + std::to_string(request.max_boxes) + " must be positive, or 0 for 1000000");
  throwProblems(problems);
  const StopFlag stop = context_.decider.makeStopFlag();
  const ContainmentResult result = checkContainment(evaluator.test(), *solid.shape, center, solid.size,
                                                    request.max_boxes == 0 ? MAX_BOXES : request.max_boxes, stop.get());
  response.verdict = constantOf(result.verdict);
  response.boxes = result.boxes;
  if (result.bad_point)
    response.bad_point = toMessage(*result.bad_point);
  response.message = sentence(result, evaluator);
}

void PlannerService::checkPath(const CheckPath::Request& request, CheckPath::Response& response)
{
  const PointEvaluator& evaluator = prepare(frameOf(request), request.criterion, response);
  const StopFlag stop = context_.decider.makeStopFlag();
  PathQuery query;
  query.tool_speed = valueOr(request.tool_speed, query.tool_speed);
  query.stop = stop.get();
  fill(pkm_workspace::checkPath(evaluator, segmentsOf(request), query), evaluator.machine(), response);
}

void PlannerService::evaluatePoint(const EvaluatePoint::Request& request, EvaluatePoint::Response& response)
{
  const PointEvaluator& evaluator = prepare(request.header.frame_id, request.criterion, response);
  Problems problems;
  requireFinite("point", fromMessage(request.point), problems);
  throwProblems(problems);
  fill(evaluator(fromMessage(request.point)), evaluator.machine(), response);
}
}  // namespace pkm_workspace
