// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/ros/placement_service.h"

#include <ros/console.h>

#include "pkm_workspace/dexterity/defaults.h"
#include "pkm_workspace/ros/conversions.h"
#include "pkm_workspace/ros/criterion_message.h"
#include "pkm_workspace/ros/path_message.h"
#include "pkm_workspace/ros/reply.h"
#include "pkm_workspace/ros/solid_message.h"

namespace pkm_workspace
{
namespace
{
/// The path of a request, as ~check_path has it.
CheckPath::Request pathOf(const PlacePath::Request& request)
{
  CheckPath::Request path;
  path.header = request.header;
  path.path = request.path;
  path.segments = request.segments;
  path.tool_speed = request.tool_speed;
  path.joint_acceleration_max = request.joint_acceleration_max;
  path.joint_speeds_off = request.joint_speeds_off;
  return path;
}

void fill(const Placement& placement, PlacePath::Response& response)
{
  const LargestRegion& found = placement.found;
  response.status = static_cast<std::uint8_t>(found.status) + 1;  // in the order of LargestRegion::Status
  response.translation = asVector(found.center);
  response.margin = found.size;
  response.margin_upper_bound = found.size_upper_bound;
  response.boxes = found.boxes;
  response.seconds = found.seconds;
  if (!placement.largest)
    return;
  response.scale_least = placement.largest->least;
  response.scale = placement.largest->scale;
  response.scale_upper_bound = placement.largest->upper_bound;
  response.scale_translation = asVector(placement.largest->translation);
  response.boxes += placement.largest->search.boxes;
  response.seconds += placement.largest->search.seconds;
}
}  // namespace

PlacementService::PlacementService(NodeContext& context)
  : context_(context)
  , service_(offer<PlacePath>(
        context.computing, context.health, "place_path",
        [this](const PlacePath::Request& request, PlacePath::Response& response) { compute(request, response); }))
{}

PlacementTask PlacementService::read(const PlacePath::Request& request, const Machine& machine) const
{
  const Budget& node = context_.parameters.query.budget;
  PlacementTask task;
  Problems problems;
  const JointUse use = request.tool_speed != 0.0 ? JointUse::SPEEDS_TOO : JointUse::BOUNDS;
  task.query.criterion = fromMessage(request.criterion, context_.machine(), context_.query().criterion, problems, use);
  task.query.translations = readCorners(request.use_box, request.min_corner, request.max_corner, "use_box", problems);
  task.query.accuracy = valueOr(request.accuracy, 0.1 * defaultAccuracy(machine));
  task.query.wants_scale = request.largest_scale != 0;
  task.query.budget = node;
  task.query.budget.time_limit = timeLimitOf(request.time_limit, node.time_limit, node.time_limit, problems);
  validatePositive("accuracy", task.query.accuracy, "m", problems);
  task.rates = ratesOf(pathOf(request), context_.parameters.joint_acceleration_max);
  task.rates.validate(problems);
  throwProblems(problems);
  return task;
}

void PlacementService::compute(const PlacePath::Request& request, PlacePath::Response& response)
{
  const CheckPath::Request path = pathOf(request);
  const FramedMachine in = context_.frames.machineIn(frameOf(path), request.criterion);
  PlacementTask task = read(request, *in.machine);
  task.query.criterion = in.seen(task.query.criterion);
  task.for_each = [&path](const auto& use) { forEachSegment(path, use); };
  const StopFlag stop = context_.worker.makeStopFlag();
  task.query.budget.stop = stop.get();
  const std::string asked = "placement of a path whose points are " + describe(task.query.criterion);
  ROS_INFO_STREAM_NAMED("server", "computing: " << asked);
  const PlacementReport report =
      withRemedy({ "joint_limits = ON", "translations by use_box" }, [&] { return place(*in.machine, task); });
  response.header = headerOf(in, ros::Time::now());
  response.hypotheses = toMessage(in.premises(task.query.criterion), task.query.accuracy);
  fill(report.placement, response);
  response.message = report.message;
  ROS_INFO_STREAM_NAMED("server", response.message << " " << response.seconds << " s");
  const bool is_wide = report.placement.found.status == LargestRegion::Status::STOPPED;
  context_.health.noteComputation({ asked, response.message, response.seconds, is_wide });
}
}  // namespace pkm_workspace
