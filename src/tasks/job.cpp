// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/tasks/job.h"

#include <stdexcept>

#include "pkm_workspace/common/text.h"
#include "pkm_workspace/import/rs274.h"

namespace pkm_workspace
{
namespace
{
constexpr std::size_t MOST_JOB_PROBLEMS = 100;
constexpr std::size_t LINES_BETWEEN_PROGRESS = 4096;

PathSegment segmentOf(const GcodeMove& move)
{
  if (move.kind == GcodeMove::Kind::POINT)
    return PathSegment::line(move.end, move.end);
  if (move.kind == GcodeMove::Kind::LINE)
    return PathSegment::line(move.start, move.end);
  return PathSegment::helixTo(move.start, move.center, move.axis, move.end, move.turns);
}

std::string counted(std::size_t count, const std::string& one, const std::string& many)
{
  return std::to_string(count) + " " + (count == 1 ? one : many);
}
}  // namespace

void JobTask::describeTo(PathTask& task)
{
  task.query.most_offences = most_listed;
  task.rates.steps_have_speeds = true;
  task.for_each = [this](const Take& take) { handOver(take); };
  task.tell = [this](const SegmentCheck& check) { keep(check); };
  task.place = [this](std::size_t line) { return place(line); };
}

void JobTask::handOver(const Take& take)
{
  const std::unique_ptr<MoveReader> reader = is_for_rs274 ? canonicalMoves(setup) : std::make_unique<GcodeJob>(setup);
  Problems problems;
  const auto read = [&](const std::string& line, std::size_t number) {
    if (tell && number % LINES_BETWEEN_PROGRESS == 0)
      tell(reader->line(), found_.offending());
    try
    {
      const std::optional<GcodeMove> move = reader->read(line);
      if (move && problems.empty())
        handOver(*move, reader->line(), take);
    }
    catch (const std::invalid_argument& reason)
    {
      for (const std::string& text : linesOf(reason.what()))
        problems.push_back(place(reader->line()) + ": " + text);
    }
    if (problems.size() >= MOST_JOB_PROBLEMS)
      throw std::invalid_argument(place(reader->line()) + ": from here on, nothing was read");
  };
  try
  {
    found_.lines = readAll(read);
  }
  catch (const std::invalid_argument& reason)
  {
    problems.push_back(reason.what());
  }
  found_.summary = reader->summary();
  if (problems.empty() && found_.steps == 0)
    problems.push_back(name +
                       ": nothing can be checked: there is no move from a place that is known, or to one; give " +
                       remedies.tool_at + " where the job has relative moves only");
  throwProblems(problems);
}

std::size_t JobTask::readAll(const LineTaker& read) const
{
  if (is_for_rs274)
    return interpretByRs274({ name, read_lines, setup, is_over, ended_by }, read);
  std::size_t lines = 0;
  read_lines([&](const std::string& line, std::size_t number) {
    lines = number;
    read(line, number);
  });
  return lines;
}

void JobTask::handOver(const GcodeMove& move, std::size_t line, const Take& take)
{
  const PathSegment segment = segmentOf(move);
  PathStep step(segment);
  step.tool_speed = speedOf(move, segment);
  step.id = line;
  ++found_.steps;
  found_.without_feed += move.kind != GcodeMove::Kind::POINT && step.tool_speed->upper() == 0.0 ? 1 : 0;
  take(step);
}

Interval JobTask::speedOf(const GcodeMove& move, const PathSegment& segment) const
{
  if (move.kind == GcodeMove::Kind::POINT)
    return Interval(0.0);
  if (move.feed == GcodeMove::Feed::NONE)
    return Interval(rapid_feed.value_or(0.0));
  return move.feed == GcodeMove::Feed::SPEED ? move.feed_value : move.feed_value * segment.curve().length();
}

void JobTask::keep(const SegmentCheck& check)
{
  found_.outside += check.verdict == Containment::OUTSIDE ? 1 : 0;
  found_.undecided += check.verdict == Containment::UNDECIDED ? 1 : 0;
  if (check.offence)
    found_.listed.push_back({ check.verdict, *check.offence });
}

std::string JobTask::remark() const
{
  std::string text;
  const auto say = [&text](const std::string& sentence) { text += (text.empty() ? "" : " ") + sentence; };
  if (found_.offending() > 1)
    say(std::to_string(found_.offending()) + " lines offend: " + std::to_string(found_.outside) + " outside, " +
        std::to_string(found_.undecided) + " undecided.");
  if (found_.summary.unknown_moves > 0)
    say(counted(found_.summary.unknown_moves, "move begins or ends", "moves begin or end") +
        " where the job does not say, the first on " + place(found_.summary.first_unknown) + ": nothing is said of " +
        (found_.summary.unknown_moves == 1 ? "it." : "them."));
  if (is_for_rs274)
    say("The moves are those that rs274 prints, whose numbers it rounds to four digits behind the point.");
  if (found_.without_feed > 0)
    say("The speeds of " + counted(found_.without_feed, "rapid move", "rapid moves") +
        " (G0) are not held against a limit: " + remedies.rapid_feed + " gives them one.");
  return text;
}
}  // namespace pkm_workspace
