// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/ros/planner_service.h"

#include "pkm_workspace/dexterity/defaults.h"
#include "pkm_workspace/region/containment.h"
#include "pkm_workspace/report/containment_sentence.h"
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
ros::NodeHandle withQueue(ros::NodeHandle node, ros::CallbackQueue& queue)
{
  node.setCallbackQueue(&queue);
  return node;
}
}  // namespace

PlannerService::PlannerService(NodeContext& context)
  : context_(context)
  , checking_(withQueue(context.private_node, crew_.queue()))
  , check_region_(offer<CheckRegion>(checking_, context.health, "check_region",
                                     [this](const auto& request, auto& response) { checkRegion(request, response); }))
  , check_path_(offer<CheckPath>(checking_, context.health, "check_path",
                                 [this](const auto& request, auto& response) { checkPath(request, response); }))
  , evaluate_point_(
        offer<EvaluatePoint>(context.deciding, context.health, "evaluate_point",
                             [this](const auto& request, auto& response) { evaluatePoint(request, response); }))
{
  crew_.start();
}

PlannerService::~PlannerService()
{
  crew_.stop();
}

template <class Response>
PlannerService::EvaluatorPtr PlannerService::prepare(const std::string& frame, const CriterionRequest& request,
                                                     Response& response, JointUse use)
{
  const FramedMachine in = context_.frames.machineIn(frame);
  Problems problems;
  const Criterion criterion = fromMessage(request, context_.machine(), context_.query().criterion, problems, use);
  throwProblems(problems);
  const Premises premises = in.premises(in.seen(criterion));
  const EvaluatorPtr evaluator = evaluatorFor(*in.machine, premises);
  response.header = headerOf(in, ros::Time::now());
  response.hypotheses = toMessage(premises, 0.0);
  return evaluator;
}

PlannerService::EvaluatorPtr PlannerService::evaluatorFor(const Machine& machine, const Premises& premises)
{
  const std::lock_guard<std::mutex> lock(mutex_);
  // equal premises leave aside what the criterion does not count with; at a tool speed paths do
  if (!evaluator_ || !(premises_ == premises) ||
      premises_.criterion.joint_speed_max != premises.criterion.joint_speed_max)
  {
    evaluator_ = std::make_shared<const PointEvaluator>(machine, premises.criterion);
    premises_ = premises;
  }
  return evaluator_;
}

void PlannerService::checkRegion(const CheckRegion::Request& request, CheckRegion::Response& response)
{
  const EvaluatorPtr evaluator = prepare(request.header.frame_id, request.criterion, response);
  Problems problems;
  const auto region = fromMessage(request.solid, request.vertices, request.center, problems);
  if (request.max_boxes < 0)
    problems.push_back("max_boxes = " + std::to_string(request.max_boxes) + " must be positive, or 0 for " +
                       std::to_string(DEFAULT_CHECK_BOXES));
  throwProblems(problems);
  Budget budget = context_.parameters.query.budget;
  budget.max_boxes = request.max_boxes == 0 ? DEFAULT_CHECK_BOXES : request.max_boxes;
  budget.stop = crew_.stopFlag();
  const auto& [solid, center] = *region;
  const ContainmentResult result = checkContainment(evaluator->test(), *solid.shape, center, solid.size, budget);
  response.verdict = constantOf(result.verdict);
  response.boxes = result.boxes;
  if (result.bad_point)
    response.bad_point = toMessage(*result.bad_point);
  response.message = describe(result, *evaluator, *solid.shape, center, solid.size, budget);
}

void PlannerService::checkPath(const CheckPath::Request& request, CheckPath::Response& response)
{
  const bool is_at_speed = request.tool_speed != 0.0 || request.largest_feed != 0;
  const EvaluatorPtr evaluator =
      prepare(frameOf(request), request.criterion, response, is_at_speed ? JointUse::SPEEDS_TOO : JointUse::BOUNDS);
  PathTask task;
  task.rates = ratesOf(request, context_.parameters.joint_acceleration_max);
  task.query.stop = crew_.stopFlag();
  task.for_each = [&request](const UseSegment& use) { forEachSegment(request, use); };
  task.tell = [&response](const SegmentCheck& segment) {
    response.segment_verdicts.push_back(constantOf(segment.verdict));
    addRates(segment, response.rates);
  };
  task.place = [](std::size_t segment) { return "segment " + std::to_string(segment); };
  fill(pkm_workspace::checkPath(*evaluator, task), evaluator->machine(), response);
}

void PlannerService::evaluatePoint(const EvaluatePoint::Request& request, EvaluatePoint::Response& response)
{
  const EvaluatorPtr evaluator = prepare(request.header.frame_id, request.criterion, response);
  Problems problems;
  requireFinite("point", fromMessage(request.point), problems);
  throwProblems(problems);
  fill((*evaluator)(fromMessage(request.point)), *evaluator, response);
}
}  // namespace pkm_workspace
