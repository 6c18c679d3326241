// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/ros/planner_service.h"

#include <algorithm>

#include "pkm_workspace/common/text.h"
#include "pkm_workspace/dexterity/defaults.h"
#include "pkm_workspace/interval/decimal.h"
#include "pkm_workspace/region/containment.h"
#include "pkm_workspace/report/containment_sentence.h"
#include "pkm_workspace/ros/certificate_request.h"
#include "pkm_workspace/ros/conversions.h"
#include "pkm_workspace/ros/criterion_message.h"
#include "pkm_workspace/ros/gcode_message.h"
#include "pkm_workspace/ros/path_message.h"
#include "pkm_workspace/ros/reply.h"
#include "pkm_workspace/ros/solid_message.h"
#include "pkm_workspace/ros/verdict_message.h"
#include "pkm_workspace/tasks/limits_export.h"

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
  , check_gcode_(offer<CheckGcode>(checking_, context.health, "check_gcode",
                                   [this](const auto& request, auto& response) { checkGcode(request, response); }))
  , export_limits_(
        offer<ExportLimits>(checking_, context.health, "export_limits",
                            [this](const auto& request, auto& response) { exportLimits(request, response); }))
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
  const FramedMachine in = context_.frames.machineIn(frame, request);
  response.header = headerOf(in, ros::Time::now());
  return prepare(in, request, response, use);
}

template <class Response>
PlannerService::EvaluatorPtr PlannerService::prepare(const FramedMachine& in, const CriterionRequest& request,
                                                     Response& response, JointUse use)
{
  Problems problems;
  const Criterion criterion = fromMessage(request, context_.machine(), context_.query().criterion, problems, use);
  throwProblems(problems);
  const Premises premises = in.premises(in.seen(criterion));
  response.hypotheses = toMessage(premises, 0.0);
  return evaluatorFor(*in.machine, premises);
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

Budget PlannerService::budgetOf(std::int64_t max_boxes, Problems& problems) const
{
  if (max_boxes < 0)
    problems.push_back("max_boxes = " + std::to_string(max_boxes) + " must be positive, or 0 for " +
                       std::to_string(DEFAULT_CHECK_BOXES));
  Budget budget = context_.parameters.query.budget;
  budget.max_boxes = max_boxes == 0 ? DEFAULT_CHECK_BOXES : max_boxes;
  budget.stop = crew_.stopFlag();
  return budget;
}

void PlannerService::checkRegion(const CheckRegion::Request& request, CheckRegion::Response& response)
{
  const EvaluatorPtr evaluator = prepare(request.header.frame_id, request.criterion, response);
  Problems problems;
  const auto region = fromMessage(request.solid, request.vertices, request.center, problems);
  const Budget budget = budgetOf(request.max_boxes, problems);
  throwProblems(problems);
  const auto& [solid, center] = *region;
  const auto certificate = certificateFile(request.certificate, context_.parameters);
  certificate->validate(evaluator->machine(), evaluator->criterion(), solid.shape.get());
  const ContainmentResult result = checkContainment(evaluator->test(), *solid.shape, center, solid.size, budget);
  response.verdict = constantOf(result.verdict);
  response.boxes = result.boxes;
  if (result.bad_point)
    response.bad_point = toMessage(*result.bad_point);
  response.message = describe(result, *evaluator, *solid.shape, center, solid.size, budget);
  saveCertificate(*certificate, false, response, evaluator->machine(), evaluator->criterion(), result.verdict, solid,
                  center);
}

void PlannerService::checkPath(const CheckPath::Request& request, CheckPath::Response& response)
{
  const bool is_at_speed = request.tool_speed != 0.0 || request.largest_feed != 0;
  const EvaluatorPtr evaluator =
      prepare(frameOf(request), request.criterion, response, is_at_speed ? JointUse::SPEEDS_TOO : JointUse::BOUNDS);
  PathTask task;
  task.rates = ratesOf(request, context_.parameters.joint_acceleration_max);
  task.query.stop = crew_.stopFlag();
  const auto certificate = certificateFile(request.certificate, context_.parameters);
  certificate->validate(evaluator->machine(), evaluator->criterion());
  std::vector<PathSegment> path;
  task.for_each = [&](const UseSegment& use) {
    forEachSegment(request, [&](const PathSegment& segment) {
      if (certificate->given())
        path.push_back(segment);
      use(segment);
    });
  };
  task.tell = [&response](const SegmentCheck& segment) {
    response.segment_verdicts.push_back(constantOf(segment.verdict));
    addRates(segment, response.rates);
  };
  task.place = [](std::size_t segment) { return "segment " + std::to_string(segment); };
  const PathReport report = pkm_workspace::checkPath(*evaluator, task);
  fill(report, evaluator->machine(), response);
  saveCertificate(*certificate, false, response, evaluator->machine(), evaluator->criterion(), report.result.verdict,
                  path, task.rates.isHeld());
}

void PlannerService::checkGcode(const CheckGcode::Request& request, CheckGcode::Response& response)
{
  const EvaluatorPtr evaluator = prepare(request.header.frame_id, request.criterion, response, JointUse::SPEEDS_TOO);
  JobTask job;
  Problems problems;
  read(request, job, problems);
  PathTask task;
  task.rates = ratesOf(request, context_.parameters.joint_acceleration_max);
  task.rates.validate(problems);
  throwProblems(problems);
  task.query.stop = crew_.stopFlag();
  job.describeTo(task);
  const PathReport report = pkm_workspace::checkPath(*evaluator, task);
  fill(report, job, evaluator->machine(), response);
}

void PlannerService::exportLimits(const ExportLimits::Request& request, ExportLimits::Response& response)
{
  const FramedMachine in = context_.frames.machineIn("", request.criterion);
  const EvaluatorPtr evaluator = prepare(in, request.criterion, response, JointUse::BOUNDS);
  Problems problems;
  ExportTask task;
  task.format = request.format;
  const std::vector<std::string> formats = limitFormats();
  if (std::find(formats.begin(), formats.end(), task.format) == formats.end())
    problems.push_back("format = '" + task.format + "' must be one of " + joined(formats, ", "));
  if (const auto region = fromMessage(request.solid, request.center, problems))
    task.region = *region;
  task.origin = fromMessage(request.origin);
  task.top_by_slicer = request.top_by_slicer != 0;
  task.remedies = { "type = CYLINDER with height and radius",
                    "a center above the origin",
                    "type = BOX with three sides",
                    "joint_limits = OFF",
                    "top_by_slicer",
                    "origin" };
  task.budget = budgetOf(request.max_boxes, problems);
  throwProblems(problems);
  const ExportReport report = pkm_workspace::exportLimits(*evaluator, task);
  response.text = report.limits.text;
  for (const auto& [key, value] : report.limits.values)
  {
    response.keys.push_back(key);
    response.values.push_back(*parseNumber(value));
  }
  response.message = report.message;
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
