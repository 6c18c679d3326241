// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/ros/path_message.h"

#include <limits>
#include <optional>

#include "pkm_workspace/report/point_sentence.h"
#include "pkm_workspace/ros/conversions.h"
#include "pkm_workspace/ros/frames.h"
#include "pkm_workspace/ros/solid_message.h"
#include "pkm_workspace/ros/verdict_message.h"

namespace pkm_workspace
{
namespace
{
constexpr double NONE = std::numeric_limits<double>::quiet_NaN();

Eigen::Vector3d fromVector(const geometry_msgs::Vector3& vector)
{
  return { vector.x, vector.y, vector.z };
}

bool isUnset(const geometry_msgs::Point& point)
{
  return fromMessage(point) == Eigen::Vector3d::Zero();
}

void requireUnused(const ToolSegment& segment)
{
  const bool has_arc = !isUnset(segment.center) || fromVector(segment.axis) != Eigen::Vector3d::Zero() ||
                       segment.angle != 0.0 || segment.lift != 0.0;
  if (segment.kind != ToolSegment::ARC_THROUGH && !isUnset(segment.via))
    throw std::invalid_argument("via must be 0 [m] unless kind = ARC_THROUGH");
  if (segment.kind != ToolSegment::ARC && has_arc)
    throw std::invalid_argument("center, axis, angle and lift must be 0 unless kind = ARC");
  if (segment.kind == ToolSegment::ARC && !isUnset(segment.end))
    throw std::invalid_argument("end must be 0 [m] for kind = ARC: it follows from the angle");
}

PathSegment fromSegment(const ToolSegment& segment)
{
  const Eigen::Vector3d start = fromMessage(segment.start);
  requireUnused(segment);
  switch (segment.kind)
  {
    case ToolSegment::LINE:
      return PathSegment::line(start, fromMessage(segment.end));
    case ToolSegment::ARC_THROUGH:
      return PathSegment::arcThrough(start, fromMessage(segment.via), fromMessage(segment.end));
    case ToolSegment::ARC:
      return PathSegment::arc(start, fromMessage(segment.center), fromVector(segment.axis), segment.angle,
                              segment.lift);
    default:
      throw std::invalid_argument("kind = " + std::to_string(segment.kind) +
                                  " must be LINE = 1, ARC_THROUGH = 2 or ARC = 3");
  }
}

Bounds boundsOf(const LargestFeed& feed)
{
  Bounds message;
  message.lower = feed.lower;
  message.upper = feed.upper;
  return message;
}

void fill(const PathReport& report, const Machine& machine, JointRates& rates)
{
  const PathRates& found = *report.result.rates;
  for (std::size_t i = 0; i < 3; ++i)
  {
    rates.speed_max[i] = report.query.limits.speed[i];
    rates.acceleration_max[i] = report.query.limits.acceleration[i];
    rates.accelerations[i] = found.joint_acceleration[i];
  }
  rates.feed = boundsOf(found.feed);
  rates.slowest_segment = static_cast<std::int64_t>(report.result.slowest);
  rates.slowest_joint = found.feed.leg < 0 ? "" : machine.leg(found.feed.leg).joint;
}

/// Uses what @p make makes, unless something is wrong already, or keeps why it cannot be made.
template <class Make>
void handOut(const char* list, std::size_t index, const Make& make, const UseSegment& use, Problems& problems)
{
  std::optional<PathSegment> segment;
  try
  {
    segment = make();
  }
  catch (const std::invalid_argument& error)
  {
    problems.push_back(list + ("[" + std::to_string(index)) + "]: " + error.what());
  }
  if (segment && problems.empty())
    use(*segment);
}
}  // namespace

void forEachSegment(const CheckPath::Request& request, const UseSegment& use)
{
  Problems problems;
  const auto& poses = request.path.poses;
  if (poses.empty() == request.segments.empty() || poses.size() == 1)
    problems.push_back("give either segments or a path of two poses or more");
  for (std::size_t k = 0; k + 1 < poses.size(); ++k)
    handOut(
        "path.poses", k + 1,
        [&] { return PathSegment::line(fromMessage(poses[k].pose.position), fromMessage(poses[k + 1].pose.position)); },
        use, problems);
  for (std::size_t k = 0; k < request.segments.size(); ++k)
    handOut(
        "segments", k, [&] { return fromSegment(request.segments[k]); }, use, problems);
  throwProblems(problems);
}

PathRatesTask ratesOf(const CheckPath::Request& request, const std::vector<double>& joint_acceleration_max)
{
  PathRatesTask rates;
  if (request.tool_speed != 0.0)
    rates.tool_speed = request.tool_speed;
  rates.largest_feed = request.largest_feed != 0;
  rates.joint_speeds_off = request.joint_speeds_off != 0;
  rates.joint_acceleration_max = request.joint_acceleration_max;
  if (rates.isAsked() && rates.joint_acceleration_max.empty())
    rates.joint_acceleration_max = joint_acceleration_max;
  return rates;
}

std::string frameOf(const CheckPath::Request& request)
{
  std::string frame = bare(request.header.frame_id);
  const auto require = [&frame](const std::string& name) {
    const std::string other = bare(name);
    if (frame.empty())
      frame = other;
    else if (!other.empty() && other != frame)
      throw std::invalid_argument("path: frame '" + other + "' must be empty or that of the request, '" + frame + "'");
  };
  require(request.path.header.frame_id);
  for (const auto& pose : request.path.poses)
    require(pose.header.frame_id);
  return frame;
}

BindingLimit toMessage(const Limit& limit, const Machine& machine)
{
  BindingLimit message;
  message.kind = static_cast<std::uint8_t>(limit.kind);  // numbered as Limit::Kind
  message.joint = limit.leg < 0 ? "" : machine.leg(limit.leg).joint;
  message.value = toMessage(limit.value);
  message.margin = toMessage(limit.margin);
  message.bound = limit.bound;
  message.zone = limit.zone;
  return message;
}

ToolMotion toMessage(const PathMotion& motion)
{
  ToolMotion message;
  for (std::size_t i = 0; i < 3; ++i)
  {
    message.psi[i] = toMessage(motion.psi[i]);
    message.joints[i] = toMessage(motion.joint[i]);
    message.joint_speeds[i] = motion.joint_speed[i];
  }
  return message;
}

void fill(const PointEvaluation& evaluation, const PointEvaluator& evaluator, EvaluatePoint::Response& response)
{
  response.verdict = constantOf(evaluation.verdict);
  response.within_reach = constantOf(evaluation.within_reach);
  response.has_values = evaluation.has_values;
  response.limit = toMessage(evaluation.binding(), evaluator.machine());
  response.message = describe(evaluation, evaluator);
  if (!evaluation.has_values)
    return;
  for (std::size_t i = 0; i < 3; ++i)
  {
    response.psi[i] = toMessage(evaluation.psi[i]);
    response.joints[i] = toMessage(evaluation.rho[i]);
  }
  response.condition = toMessage(evaluation.condition);
  response.det_a = toMessage(evaluation.det_a);
}

void addRates(const SegmentCheck& check, JointRates& rates)
{
  if (check.rates)
    rates.segment_feeds.push_back(boundsOf(check.rates->feed));
}

void fill(const PathReport& report, const Machine& machine, CheckPath::Response& response)
{
  const PathResult& result = report.result;
  response.verdict = constantOf(result.verdict);
  response.looks = result.looks;
  response.offending_segment = -1;
  response.bad_at = NONE;
  response.end = static_cast<std::uint8_t>(result.end);  // numbered as PathResult::End
  response.message = report.message;
  if (result.motion)
    response.motion = toMessage(*result.motion);
  if (result.rates)
    fill(report, machine, response.rates);
  if (!result.first)
    return;
  const PathOffence& offence = *result.first;
  response.offending_segment = static_cast<std::int64_t>(offence.segment);
  response.good_until = offence.good_until;
  response.bad_at = offence.bad_at.value_or(NONE);
  response.offence = toMessage(offence.point);
  response.limit = toMessage(offence.limit, machine);
  for (const PathPart& part : offence.open)
    response.open.push_back(toMessage(Interval(part.first, part.last)));
}
}  // namespace pkm_workspace
