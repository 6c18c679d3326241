// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/ros/conditioning_service.h"

#include <ros/console.h>

#include "pkm_workspace/dexterity/defaults.h"
#include "pkm_workspace/paving/workspace_conditioning.h"
#include "pkm_workspace/region/region_parts.h"
#include "pkm_workspace/report/conditioning_sentence.h"
#include "pkm_workspace/report/set_reach.h"
#include "pkm_workspace/ros/conversions.h"
#include "pkm_workspace/ros/criterion_message.h"
#include "pkm_workspace/ros/reply.h"
#include "pkm_workspace/ros/solid_message.h"

namespace pkm_workspace
{
namespace
{
using Request = ComputeConditioning::Request;

/// Refuses what is set and without effect.
void requireUnused(const Request& request, Problems& problems)
{
  if (request.over > Request::REGION)
    problems.push_back("over = " + std::to_string(request.over) + " must be SET = 0 or REGION = 1");
  if (request.over == Request::REGION && request.criterion != CriterionRequest())
    problems.push_back("criterion must be 0 unless over = SET: all points of a region count");
  if (request.over != Request::REGION &&
      (!request.solid.dimensions.empty() || fromMessage(request.center) != Eigen::Vector3d::Zero()))
    problems.push_back("solid and center must be empty and 0 [m] unless over = REGION");
}

GlobalConditioning overRegion(const Machine& machine, const Request& request, const ConditioningQuery& query)
{
  const Solid solid = fromMessage(request.solid);
  return globalConditioning(machine, *solid.shape, fromMessage(request.center), solid.size, query);
}
}  // namespace

ConditioningService::ConditioningService(NodeContext& context)
  : context_(context)
  , service_(offer<ComputeConditioning>(
        context.computing, context.health, "compute_conditioning",
        [this](const Request& request, ComputeConditioning::Response& response) { compute(request, response); }))
{}

void ConditioningService::compute(const Request& request, ComputeConditioning::Response& response)
{
  const FramedMachine in = context_.frames.machineIn(request.header.frame_id);
  const bool of_region = request.over == Request::REGION;
  const Budget& node = context_.parameters.query.budget;
  ConditioningQuery query;
  Problems problems;
  requireUnused(request, problems);
  const Criterion criterion = fromMessage(request.criterion, context_.query().criterion, problems);
  query.accuracy = valueOr(request.accuracy, query.accuracy);
  query.budget = node;
  query.budget.time_limit = timeLimitOf(request.time_limit, node.time_limit, node.time_limit, problems);
  query.validate(problems);
  if (of_region)
    requireFinite("center", fromMessage(request.center), problems);
  throwProblems(problems);
  const StopFlag stop = context_.worker.makeStopFlag();
  query.budget.stop = stop.get();
  const std::string asked =
      "global conditioning index of " + (of_region ? "a region" : "all points that are " + describe(criterion));
  ROS_INFO_STREAM_NAMED("server", "computing: " << asked);
  const GlobalConditioning found =
      of_region ? overRegion(*in.machine, request, query) : withRemedy({ "joint_limits = ON", "over = REGION" }, [&] {
        return workspaceConditioning(*in.machine, criterion, query);
      });
  response.header = headerOf(in, ros::Time::now());
  response.hypotheses = toMessage(in.premises(of_region ? anyReachable() : criterion), query.accuracy);
  response.index = toMessage(found.index);
  response.measure = toMessage(found.measure);
  response.complete = found.complete;
  response.boxes = found.boxes;
  response.seconds = found.seconds;
  const auto reaches = of_region ? std::nullopt : reachOver(*in.machine, criterion);
  response.message = withRemark(describe(found, query.budget), remarkOnLimits(*in.machine, criterion, reaches));
  ROS_INFO_STREAM_NAMED("server", response.message << " " << found.seconds << " s");
  context_.health.noteComputation({ asked, response.message, found.seconds, !found.complete });
}
}  // namespace pkm_workspace
