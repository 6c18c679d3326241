// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/ros/singularity_service.h"

#include <ros/console.h>

#include <algorithm>
#include <array>

#include "pkm_workspace/interval/decimal.h"
#include "pkm_workspace/paving/range_workspace.h"
#include "pkm_workspace/region/path.h"
#include "pkm_workspace/ros/conversions.h"
#include "pkm_workspace/ros/criterion_message.h"
#include "pkm_workspace/ros/markers.h"
#include "pkm_workspace/ros/reply.h"
#include "pkm_workspace/ros/solid_message.h"
#include "scene.h"

namespace pkm_workspace
{
namespace
{
using visualization_msgs::Marker;

constexpr Color SINGULAR = { 0.85F, 0.1F, 0.1F, 1.0F };

std::array<Interval, 3> readRanges(const FindSingularities::Request& request, Problems& problems)
{
  std::array<Interval, 3> ranges;
  for (std::size_t i = 0; i < 3; ++i)
  {
    const Bounds& bounds = request.ranges[i];
    if (bounds.lower >= -FARTHEST && bounds.lower <= bounds.upper && bounds.upper <= FARTHEST)
      ranges[i] = { bounds.lower, bounds.upper };
    else
      problems.push_back("ranges[" + std::to_string(i) + "] = [" + exact(bounds.lower) + ", " + exact(bounds.upper) +
                         "] m must be finite, within 1e9 m, the lower end first");
  }
  return ranges;
}

/// Refuses what is set and without effect.
void requireUnused(const FindSingularities::Request& request, Problems& problems)
{
  for (const Bounds& bounds : request.ranges)
    if (request.over != FindSingularities::Request::JOINT_RANGES && (bounds.lower != 0.0 || bounds.upper != 0.0))
      return problems.push_back("ranges must be 0 [m] unless over = JOINT_RANGES");
}

SingularityFinding findingOf(const SingularityAnswer& answer)
{
  constexpr std::uint8_t STATUS[] = { SingularityFinding::NONE, SingularityFinding::PROVED,
                                      SingularityFinding::UNDECIDED };  // as SingularityAnswer::Status
  SingularityFinding message;
  message.status = STATUS[static_cast<std::size_t>(answer.status)];
  message.least = toMessage(answer.least);
  if (answer.status == SingularityAnswer::Status::PROVED)
  {
    message.min_corner = toMessage(answer.box->lower);
    message.max_corner = toMessage(answer.box->upper);
  }
  message.boxes = answer.boxes;
  return message;
}

/// A ball around each box, which is mostly too small to be seen.
visualization_msgs::MarkerArray markersOf(const FindSingularities::Response& found, const Premises& premises,
                                          const Machine& machine)
{
  Scene scene(found.header, machine.scale() / 1000.0, found.message + '\n' + captionOf(premises, "", 0.0));
  const auto add = [&scene](const SingularityFinding& finding, const std::string& text) {
    if (finding.status != SingularityFinding::PROVED)
      return;
    const Box box{ fromMessage(finding.min_corner), fromMessage(finding.max_corner) };
    Marker& ball = scene.add("singularity", Marker::SPHERE, SINGULAR);
    ball.pose.position = toMessage(box.center());
    ball.scale.x = ball.scale.y = ball.scale.z = std::max(40.0 * scene.unit(), 2.0 * box.maxWidth());
    scene.addText("singularity", box.center() + 80.0 * scene.unit() * Eigen::Vector3d::UnitZ(), text);
  };
  for (int i = 0; i < 3; ++i)
    add(found.serial[static_cast<std::size_t>(i)], "serial singularity: " + machine.leg(i).joint);
  add(found.parallel, "parallel singularity");
  return scene.array();
}
}  // namespace

SingularityService::SingularityService(NodeContext& context)
  : context_(context)
  , markers_(context.private_node.advertise<visualization_msgs::MarkerArray>("singularity_markers", 1, true))
  , service_(offer<FindSingularities>(context.computing, context.health, "find_singularities",
                                      [this](const FindSingularities::Request& request,
                                             FindSingularities::Response& response) { find(request, response); }))
{}

SingularityService::Question SingularityService::read(const FindSingularities::Request& request) const
{
  CriterionRequest built;
  built.tolerances = request.tolerances;
  built.own_tolerances = request.own_tolerances;
  Question question{ {}, context_.frames.machineIn(request.header.frame_id, built) };
  SingularityQuery& query = question.task.query;
  Problems problems;
  requireUnused(request, problems);
  if (request.over > FindSingularities::Request::REGION)
    problems.push_back("over = " + std::to_string(request.over) +
                       " must be JOINT_LIMITS = 0, REACHABLE = 1, JOINT_RANGES = 2 or REGION = 3");
  question.task.region =
      readRegion(request.over == FindSingularities::Request::REGION, request.solid, request.center, problems);
  query.joint_limits = request.over == FindSingularities::Request::JOINT_LIMITS ||
                       request.over == FindSingularities::Request::JOINT_RANGES;
  query.aspect = aspectOf(request.aspect, Criterion::Aspect::BOTH, problems);
  query.accuracy = valueOr(request.accuracy, query.accuracy);
  const Budget& node = context_.parameters.query.budget;
  query.budget.threads = node.threads;
  query.budget.max_memory = node.max_memory;
  query.budget.time_limit = timeLimitOf(request.time_limit, node.time_limit, node.time_limit, problems);
  query.validate(problems);
  if (request.over == FindSingularities::Request::JOINT_RANGES)
  {
    const auto ranges = readRanges(request, problems);
    throwProblems(problems);
    question.in.machine = std::make_shared<const Machine>(withJointLimits(*question.in.machine, ranges));
    const Machine& own = context_.machine();
    question.in.geometry_hash = withJointLimits(machineOf(built, own).value_or(own), ranges).geometryHash();
  }
  throwProblems(problems);
  return question;
}

void SingularityService::find(const FindSingularities::Request& request, FindSingularities::Response& response)
{
  Question question = read(request);
  const auto& [task, in] = question;
  const StopFlag stop = context_.worker.makeStopFlag();
  question.task.query.budget.stop = stop.get();
  const std::string asked =
      std::string("singularities of ") +
      (request.over == FindSingularities::Request::REGION         ? "a region, "
       : request.over == FindSingularities::Request::JOINT_RANGES ? "all points within joint ranges, "
                                                                  : "all points that are ") +
      describe(task.criterion());
  ROS_INFO_STREAM_NAMED("server", "computing: " << asked);
  const SingularityReport report = withRemedy({ "over = JOINT_LIMITS", "over = JOINT_RANGES or REGION" }, [&question] {
    return findSingularities(*question.in.machine, question.task);
  });
  response.header = headerOf(in, ros::Time::now());
  const Premises premises = in.premises(task.criterion());
  response.hypotheses = toMessage(premises, task.query.accuracy);
  for (const SingularityAnswer& answer : report.found.serial)
    response.serial.push_back(findingOf(answer));
  response.parallel = findingOf(report.found.parallel);
  response.seconds = report.found.seconds;
  response.message = report.message;
  ROS_INFO_STREAM_NAMED("server", response.message << " " << response.seconds << " s");
  context_.health.noteComputation({ asked, response.message, response.seconds, !report.isDecided() });
  markers_.publish(inRoot(markersOf(response, premises, *in.machine), in, context_.frames.root().frame));
  context_.panel.tell("singularities", captionOf(premises, "", 0.0));
}
}  // namespace pkm_workspace
