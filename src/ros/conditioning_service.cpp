// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/ros/conditioning_service.h"

#include <ros/console.h>

#include "pkm_workspace/ros/conversions.h"
#include "pkm_workspace/ros/criterion_message.h"
#include "pkm_workspace/ros/reply.h"
#include "pkm_workspace/ros/solid_message.h"

namespace pkm_workspace
{
ConditioningService::ConditioningService(NodeContext& context)
  : context_(context)
  , service_(
        offer<ComputeConditioning>(context.computing, context.health, "compute_conditioning",
                                   [this](const ComputeConditioning::Request& request,
                                          ComputeConditioning::Response& response) { compute(request, response); }))
{}

ConditioningTask ConditioningService::read(const ComputeConditioning::Request& request) const
{
  const Budget& node = context_.parameters.query.budget;
  ConditioningTask task;
  Problems problems;
  if (request.over > ComputeConditioning::Request::REGION)
    problems.push_back("over = " + std::to_string(request.over) + " must be SET = 0 or REGION = 1");
  if (request.over == ComputeConditioning::Request::REGION && request.criterion != CriterionRequest())
    problems.push_back("criterion must be 0 unless over = SET: all points of a region count");
  task.region =
      readRegion(request.over == ComputeConditioning::Request::REGION, request.solid, request.center, problems);
  task.criterion = fromMessage(request.criterion, context_.machine(), context_.query().criterion, problems);
  task.query.accuracy = valueOr(request.accuracy, task.query.accuracy);
  task.query.budget = node;
  task.query.budget.time_limit = timeLimitOf(request.time_limit, node.time_limit, node.time_limit, problems);
  task.query.validate(problems);
  throwProblems(problems);
  return task;
}

void ConditioningService::compute(const ComputeConditioning::Request& request, ComputeConditioning::Response& response)
{
  const FramedMachine in = context_.frames.machineIn(request.header.frame_id, request.criterion);
  ConditioningTask task = read(request);
  task.criterion = in.seen(task.criterion);
  const StopFlag stop = context_.worker.makeStopFlag();
  task.query.budget.stop = stop.get();
  const std::string asked =
      "global conditioning index of " + (task.region ? "a region" : "all points that are " + describe(task.criterion));
  ROS_INFO_STREAM_NAMED("server", "computing: " << asked);
  const ConditioningReport report =
      withRemedy({ "joint_limits = ON", "over = REGION" }, [&] { return globalConditioning(*in.machine, task); });
  const GlobalConditioning& found = report.found;
  response.header = headerOf(in, ros::Time::now());
  response.hypotheses = toMessage(in.premises(task.pointsThatCount()), task.query.accuracy);
  response.index = toMessage(found.index);
  response.measure = toMessage(found.measure);
  response.complete = found.complete;
  response.boxes = found.boxes;
  response.seconds = found.seconds;
  response.message = report.message;
  ROS_INFO_STREAM_NAMED("server", response.message << " " << found.seconds << " s");
  context_.health.noteComputation({ asked, response.message, found.seconds, !found.complete });
}
}  // namespace pkm_workspace
