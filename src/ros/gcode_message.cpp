// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/ros/gcode_message.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#include "pkm_workspace/interval/decimal.h"
#include "pkm_workspace/report/binding_limit.h"
#include "pkm_workspace/ros/conversions.h"
#include "pkm_workspace/ros/path_message.h"
#include "pkm_workspace/ros/verdict_message.h"

namespace pkm_workspace
{
namespace
{
constexpr std::int64_t DEFAULT_LISTED = 100;
constexpr std::int64_t MOST_LISTED = 10000;

/// A point of the setup; 0 where it is out of range.
Eigen::Vector3d placeOf(const std::string& name, const geometry_msgs::Point& message, Problems& problems)
{
  const Eigen::Vector3d place = fromMessage(message);
  if (place.allFinite() && place.cwiseAbs().maxCoeff() <= FARTHEST_SETUP)
    return place;
  complain(problems, name, " = (", exact(place.x()), ", ", exact(place.y()), ", ", exact(place.z()),
           ") m must be within ", exact(FARTHEST_SETUP), " m");
  return Eigen::Vector3d::Zero();
}

void readTools(const CheckGcode::Request& request, GcodeSetup& setup, Problems& problems)
{
  const auto& numbers = request.tool_numbers;
  const auto& lengths = request.tool_lengths;
  if (numbers.size() != lengths.size())
    complain(problems, "tool_numbers has ", numbers.size(), " entries and tool_lengths ", lengths.size(),
             ": give a length [m] for each number");
  for (std::size_t k = 0; k < std::min(numbers.size(), lengths.size()); ++k)
    if (numbers[k] < 0 || !(std::abs(lengths[k]) <= FARTHEST_SETUP))
      complain(problems, "tool ", numbers[k], " of length ", exact(lengths[k]),
               " m: numbers must be >= 0, lengths within ", exact(FARTHEST_SETUP), " m");
    else if (!setup.tool_lengths.emplace(numbers[k], lengths[k]).second)
      complain(problems, "tool_numbers has ", numbers[k], " twice");
}

void readSetup(const CheckGcode::Request& request, GcodeSetup& setup, Problems& problems)
{
  setup.origin = placeOf("origin", request.origin, problems);
  if (request.work_offsets.size() > GcodeSetup::SYSTEMS)
    complain(problems, "work_offsets has ", request.work_offsets.size(), " entries, at most ", GcodeSetup::SYSTEMS,
             " from G54 to G59.3");
  for (std::size_t k = 0; k < std::min(request.work_offsets.size(), GcodeSetup::SYSTEMS); ++k)
    setup.work_offsets[k] = placeOf("work_offsets[" + std::to_string(k) + "]", request.work_offsets[k], problems);
  const Eigen::Vector3d tool_at = placeOf("tool_at", request.tool_at, problems);
  if (request.use_tool_at)
    setup.start = tool_at;
  else if (tool_at != Eigen::Vector3d::Zero())
    problems.emplace_back("tool_at must be 0 unless use_tool_at");
  readTools(request, setup, problems);
  setup.rapids_have_feed = request.rapids_have_feed != 0;
}

/// Hands out pieces of a text that lives on.
ByteSource sourceOf(const std::string& text)
{
  return [&text, at = std::size_t(0)](char* data, std::size_t size) mutable {
    const std::size_t count = std::min(size, text.size() - at);
    std::memcpy(data, text.data() + at, count);
    at += count;
    return count;
  };
}

OffendingLine lineMessage(const JobTask::Offence& found, const Machine& machine)
{
  OffendingLine message;
  message.line = static_cast<std::int64_t>(found.offence.segment);
  message.verdict = constantOf(found.verdict);
  message.good_until = found.offence.good_until;
  message.bad_at = found.offence.bad_at.value_or(std::numeric_limits<double>::quiet_NaN());
  message.point = toMessage(found.offence.point);
  message.tool_speed = found.offence.tool_speed.upper();
  message.limit = toMessage(found.offence.limit, machine);
  message.reason = describe(found.offence.limit, machine);
  return message;
}
}  // namespace

void read(const CheckGcode::Request& request, JobTask& job, Problems& problems)
{
  job.name = "gcode";
  job.remedies = { "tool_at", "rapid_feed" };
  job.read_lines = [&request](const LineTaker& take) { readLines("gcode", sourceOf(request.gcode), take); };
  readSetup(request, job.setup, problems);
  if (request.rapid_feed != 0.0)
    job.rapid_feed = request.rapid_feed;
  if (job.rapid_feed && request.rapids_have_feed)
    problems.emplace_back("rapid_feed must be 0 where rapids_have_feed: G0 goes at the feed in effect then");
  if (job.rapid_feed && !(*job.rapid_feed >= SLOWEST_TOOL && *job.rapid_feed <= FASTEST_TOOL))
    complain(problems, "rapid_feed = ", exact(*job.rapid_feed), " m/s must be from 1e-9 to 1e9 m/s, or 0 for none");
  if (request.most_listed < 0 || request.most_listed > MOST_LISTED)
    complain(problems, "most_listed = ", request.most_listed, " must be from 1 to ", MOST_LISTED, ", or 0 for ",
             DEFAULT_LISTED);
  else
    job.most_listed = static_cast<std::size_t>(request.most_listed == 0 ? DEFAULT_LISTED : request.most_listed);
}

PathRatesTask ratesOf(const CheckGcode::Request& request, const std::vector<double>& joint_acceleration_max)
{
  PathRatesTask rates;
  rates.steps_have_speeds = true;
  rates.joint_speeds_off = request.joint_speeds_off != 0;
  rates.joint_acceleration_max =
      request.joint_acceleration_max.empty() ? joint_acceleration_max : request.joint_acceleration_max;
  return rates;
}

void fill(const PathReport& report, const JobTask& job, const Machine& machine, CheckGcode::Response& response)
{
  const JobTask::Findings& found = job.findings();
  response.verdict = constantOf(report.result.verdict);
  response.lines = static_cast<std::int64_t>(found.lines);
  response.moves = static_cast<std::int64_t>(found.summary.moves);
  response.moves_without_feed = static_cast<std::int64_t>(found.without_feed);
  response.unknown_moves = static_cast<std::int64_t>(found.summary.unknown_moves);
  response.first_unknown = static_cast<std::int64_t>(found.summary.first_unknown);
  for (const auto& [word, count] : found.summary.ignored)
  {
    response.ignored.push_back(word);
    response.ignored_counts.push_back(static_cast<std::int64_t>(count));
  }
  response.outside = static_cast<std::int64_t>(found.outside);
  response.undecided = static_cast<std::int64_t>(found.undecided);
  for (const JobTask::Offence& offence : found.listed)
    response.offences.push_back(lineMessage(offence, machine));
  if (report.result.motion)
    response.motion = toMessage(*report.result.motion);
  response.looks = report.result.looks;
  response.end = static_cast<std::uint8_t>(report.result.end);  // numbered as PathResult::End
  response.message = withRemark(report.message, job.remark());
}
}  // namespace pkm_workspace
