// SPDX-License-Identifier: BSD-3-Clause
#include "job.h"

#include <stdexcept>

#include "pkm_workspace/common/whole_file.h"
#include "pkm_workspace/interval/decimal.h"
#include "pkm_workspace/report/binding_limit.h"

namespace pkm_workspace
{
namespace cli
{
namespace
{
constexpr std::size_t MOST_PROBLEMS = 100;
constexpr std::size_t LINES_BETWEEN_PROGRESS = 4096;
constexpr std::size_t MOST_OFFENCES = 1000000;

const Words SYSTEM_NAMES = { "G54", "G55", "G56", "G57", "G58", "G59", "G59.1", "G59.2", "G59.3" };

Eigen::Vector3d pointOf(const Words& words, std::size_t first)
{
  const auto numbers = readNumbers({ words.begin() + static_cast<std::ptrdiff_t>(first), words.end() },
                                   Quantity{ "m", -1000.0, true, 1000.0 });
  return { numbers[0], numbers[1], numbers[2] };
}

std::size_t systemOf(const std::string& name)
{
  const std::string known = readChoice(name, SYSTEM_NAMES);
  std::size_t index = 0;
  while (SYSTEM_NAMES[index] != known)
    ++index;
  return index;
}

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

void Job::declare(Options& options, bool lists_lines)
{
  options.text(
      "gcode", file_, "FILE",
      std::string("job in G-code, in place of a file (docs/gcode.md lists what is read): each move at its feed") +
          (lists_lines ? ", every line that offends is listed" : ""));
  options.words("origin", "X Y Z",
                "where the controller's zero is, in the frame of the root link [m]; 0 0 0 without it",
                [this](const Words& words) { setup_.origin = pointOf(words, 0); });
  options.words("tool-at", "X Y Z",
                "where the tool is before the job, in the frame of the root link [m]; unknown without "
                "it, until the job says X, Y and Z",
                [this](const Words& words) { setup_.start = pointOf(words, 0); });
  options.repeated("work-offset", "SYSTEM X Y Z", "offset of G54, ... G59.3 before the job [m]; 0 0 0 without it",
                   [this](const Words& words) { setup_.work_offsets[systemOf(words[0])] = pointOf(words, 1); });
  options.repeated("tool-length", "NUMBER LENGTH", "length of the tool that G43 H names by its number [m]",
                   [this](const Words& words) {
                     const auto number = static_cast<int>(readCount(words[0], 1000000));
                     setup_.tool_lengths[number] = readNumbers({ words[1] }, Quantity{ "m", -1000.0, true, 1000.0 })[0];
                   });
  options.words("rapid-feed", "V",
                "speed of G0 [m/s], or 'programmed' where G0 goes at the feed in effect, as printers "
                "have it; without it G0 is held against no limit of speed",
                [this](const Words& words) {
                  setup_.rapids_have_feed = words[0] == "programmed";
                  if (!setup_.rapids_have_feed)
                    rapid_feed_ = readNumbers(words, Quantity{ "m/s", SLOWEST_TOOL, true, FASTEST_TOOL })[0];
                });
  if (lists_lines)
    options.count("most-listed", most_listed_, MOST_OFFENCES, "offending lines of a job that are listed");
  options.check({ "gcode" }, [this, &options](Problems& problems) {
    for (const char* const name : { "origin", "tool-at", "work-offset", "tool-length", "rapid-feed", "most-listed" })
      if (!isGiven() && options.given(name))
        problems.push_back("--" + std::string(name) + " is without effect: it is about a job in G-code (--gcode)");
  });
}

void Job::describeTo(PathTask& task, Progress& progress)
{
  task.query.most_offences = most_listed_;
  task.for_each = [this, &progress](const Take& take) { handOver(take, progress); };
  task.tell = [this](const SegmentCheck& check) { keep(check); };
  task.place = [this](std::size_t line) { return place(line); };
}

void Job::handOver(const Take& take, Progress& progress)
{
  GcodeJob reader(setup_);
  Problems problems;
  try
  {
    readLines(file_, [&](const std::string& line, std::size_t number) {
      lines_ = number;
      if (number % LINES_BETWEEN_PROGRESS == 0)
        progress.tell(std::to_string(number) + " lines, " + counted(outside_ + undecided_, "offends", "offend"));
      try
      {
        const std::optional<GcodeMove> move = reader.read(line);
        if (move && problems.empty())
          handOver(*move, number, take);
      }
      catch (const std::invalid_argument& reason)
      {
        for (const std::string& text : linesOf(reason.what()))
          problems.push_back(place(number) + ": " + text);
      }
      if (problems.size() >= MOST_PROBLEMS)
        throw std::invalid_argument(place(number) + ": from here on, nothing was read");
    });
  }
  catch (const std::invalid_argument& reason)
  {
    problems.push_back(reason.what());
  }
  summary_ = reader.summary();
  if (problems.empty() && steps_ == 0)
    problems.push_back(file_ +
                       ": nothing can be checked: there is no move from a place that is known, or to one; give "
                       "--tool-at X Y Z where the job has relative moves only");
  throwProblems(problems);
}

void Job::handOver(const GcodeMove& move, std::size_t line, const Take& take)
{
  const PathSegment segment = segmentOf(move);
  PathStep step(segment);
  step.tool_speed = speedOf(move, segment);
  step.id = line;
  ++steps_;
  without_feed_ += move.kind != GcodeMove::Kind::POINT && step.tool_speed->upper() == 0.0 ? 1 : 0;
  take(step);
}

Interval Job::speedOf(const GcodeMove& move, const PathSegment& segment) const
{
  if (move.kind == GcodeMove::Kind::POINT)
    return Interval(0.0);
  if (move.feed == GcodeMove::Feed::NONE)
    return Interval(rapid_feed_.value_or(0.0));
  return move.feed == GcodeMove::Feed::SPEED ? move.feed_value : move.feed_value * segment.curve().length();
}

void Job::keep(const SegmentCheck& check)
{
  outside_ += check.verdict == Containment::OUTSIDE ? 1 : 0;
  undecided_ += check.verdict == Containment::UNDECIDED ? 1 : 0;
  if (check.offence)
    listed_.push_back({ check.verdict, *check.offence });
}

void Job::addTo(Json& json) const
{
  json["lines"] = lines_;
  json["moves"] = summary_.moves;
  json["unknown_moves"] = summary_.unknown_moves;
  json["first_unknown"] = summary_.first_unknown == 0 ? Json() : Json(summary_.first_unknown);
  json["moves_without_feed"] = without_feed_;
  json["ignored"] = summary_.ignored;
}

void Job::addOffencesTo(const Machine& machine, Json& json) const
{
  json["outside"] = outside_;
  json["undecided"] = undecided_;
  json["offences"] = Json::array();
  for (const auto& [verdict, offence] : listed_)
    json["offences"].push_back({ { "line", offence.segment },
                                 { "verdict", name(verdict) },
                                 { "good_until", offence.good_until },
                                 { "bad_at", offence.bad_at ? Json(*offence.bad_at) : Json() },
                                 { "point", toJson(offence.point) },
                                 { "tool_speed", offence.tool_speed.upper() },
                                 { "binding", toJson(machine, offence.limit) },
                                 { "reason", pkm_workspace::describe(offence.limit, machine) } });
}

void Job::addRows(std::vector<Words>& rows) const
{
  rows.push_back({ "lines", std::to_string(lines_) });
  rows.push_back({ "moves", std::to_string(summary_.moves) });
  Words ignored;
  for (const auto& [word, count] : summary_.ignored)
    ignored.push_back(word + " (" + std::to_string(count) + ")");
  if (!ignored.empty())
    rows.push_back({ "ignored", joined(ignored, ", ") });
}

void Job::addOffenceRows(std::vector<Words>& rows) const
{
  rows.push_back({ "offending lines", std::to_string(outside_ + undecided_) });
}

std::string Job::offences(const Machine& machine) const
{
  std::string text;
  for (const auto& [verdict, offence] : listed_)
    text += place(offence.segment) + ": " + name(verdict) +
            " near t = " + nearly(offence.bad_at.value_or(offence.good_until), 6) + " of its way, about " +
            nearly(offence.point.x(), 6) + " " + nearly(offence.point.y(), 6) + " " + nearly(offence.point.z(), 6) +
            " m: " + pkm_workspace::describe(offence.limit, machine) + "\n";
  const std::size_t others = outside_ + undecided_ - listed_.size();
  return text + (others == 0 ? "" : counted(others, "more line offends", "more lines offend") + " (--most-listed)\n");
}

std::string Job::remark() const
{
  std::string text;
  const auto say = [&text](const std::string& sentence) { text += (text.empty() ? "" : " ") + sentence; };
  if (outside_ + undecided_ > 1)
    say(std::to_string(outside_ + undecided_) + " lines offend: " + std::to_string(outside_) + " outside, " +
        std::to_string(undecided_) + " undecided.");
  if (summary_.unknown_moves > 0)
    say(counted(summary_.unknown_moves, "move begins or ends", "moves begin or end") +
        " where the job does not say, the first on " + place(summary_.first_unknown) + ": nothing is said of " +
        (summary_.unknown_moves == 1 ? "it." : "them."));
  if (without_feed_ > 0)
    say("The speeds of " + counted(without_feed_, "rapid move", "rapid moves") +
        " (G0) are not held against a limit: --rapid-feed gives them one.");
  return text;
}
}  // namespace cli
}  // namespace pkm_workspace
