// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/ros/guarantee_service.h"

#include <ros/console.h>

#include "pkm_workspace/ros/conversions.h"
#include "pkm_workspace/ros/criterion_message.h"
#include "pkm_workspace/ros/path_message.h"
#include "pkm_workspace/ros/reply.h"
#include "pkm_workspace/ros/solid_message.h"

namespace pkm_workspace
{
namespace
{
/// What of a request for a criterion counts: the same as the request where nothing else is set.
CriterionRequest counted(const CriterionRequest& request)
{
  CriterionRequest counts;
  counts.aspect = request.aspect;
  counts.joint_speed_max = request.joint_speed_max;
  counts.joint_effort_max = request.joint_effort_max;
  counts.joint_stiffness = request.joint_stiffness;
  counts.strut_stiffness = request.strut_stiffness;
  counts.joint_error_max = request.joint_error_max;
  counts.ball_axes = request.ball_axes;
  counts.tolerances = request.tolerances;
  counts.own_tolerances = request.own_tolerances;
  return counts;
}

GuaranteedValue valueOf(const Guarantee& found, const std::string& sentence, const Machine& machine)
{
  GuaranteedValue message;
  message.quantity = found.bound->name;
  message.unit = found.bound->unit;
  message.value = toMessage(found.value);
  message.proved = found.proved();
  message.place = toMessage(found.place);
  if (found.limit)
    message.limit = toMessage(*found.limit, machine);
  message.is_reached = found.is_reached;
  message.complete = found.complete;
  message.boxes = found.boxes;
  message.seconds = found.seconds;
  message.message = sentence;
  return message;
}
}  // namespace

GuaranteeService::GuaranteeService(NodeContext& context)
  : context_(context)
  , service_(offer<ComputeGuarantees>(context.computing, context.health, "guarantee",
                                      [this](const ComputeGuarantees::Request& request,
                                             ComputeGuarantees::Response& response) { compute(request, response); }))
{}

GuaranteeTask GuaranteeService::read(const ComputeGuarantees::Request& request, const Machine& machine) const
{
  const Budget& node = context_.parameters.query.budget;
  GuaranteeTask task;
  Problems problems;
  if (request.criterion != counted(request.criterion))
    problems.push_back("criterion: only its aspect and what is known of the joints count, all else must be 0");
  if (const auto region = fromMessage(request.solid, request.center, problems))
    task.region = *region;
  task.quantities = request.quantities;
  task.query.criterion =
      fromMessage(counted(request.criterion), machine, context_.query().criterion, problems, JointUse::ALL);
  task.query.accuracy = valueOr(request.accuracy, task.query.accuracy);
  task.query.budget = node;
  task.query.budget.time_limit = timeLimitOf(request.time_limit, node.time_limit, node.time_limit, problems);
  task.query.validate(problems);
  std::vector<std::string> left_out;
  task.bounds(machine, left_out, problems);
  throwProblems(problems);
  return task;
}

void GuaranteeService::compute(const ComputeGuarantees::Request& request, ComputeGuarantees::Response& response)
{
  const FramedMachine in = context_.frames.machineIn(request.header.frame_id, request.criterion);
  GuaranteeTask task = read(request, *in.machine);
  const StopFlag stop = context_.worker.makeStopFlag();
  task.query.budget.stop = stop.get();
  Criterion reached;
  reached.set = Criterion::Set::REACHABLE;
  reached.aspect = task.query.criterion.aspect;
  const std::string asked =
      "what a " + task.region.solid.shape->name() + " can be relied on for, of points that are " + describe(reached);
  ROS_INFO_STREAM_NAMED("server", "computing: " << asked);
  const GuaranteeReport report = guaranteed(*in.machine, task);
  response.header = headerOf(in, ros::Time::now());
  response.hypotheses = toMessage(in.premises(reached), task.query.accuracy);
  double seconds = 0.0;
  bool complete = true;
  for (std::size_t k = 0; k < report.found.size(); ++k)
  {
    response.guarantees.push_back(valueOf(report.found[k], report.messages[k], *in.machine));
    seconds += report.found[k].seconds;
    complete = complete && report.found[k].complete;
  }
  response.left_out = report.left_out;
  response.message = std::to_string(report.found.size()) + " quantities are told.";
  ROS_INFO_STREAM_NAMED("server", response.message << " " << seconds << " s");
  context_.health.noteComputation({ asked, response.message, seconds, !complete });
}
}  // namespace pkm_workspace
