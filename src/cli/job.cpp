// SPDX-License-Identifier: BSD-3-Clause
#include "job.h"

#include <algorithm>

#include "pkm_workspace/interval/decimal.h"
#include "pkm_workspace/report/binding_limit.h"

namespace pkm_workspace
{
namespace cli
{
namespace
{
constexpr std::size_t MOST_OFFENCES = 1000000;
constexpr std::int64_t MOST_TOOL = 1000000;

Eigen::Vector3d pointOf(const Words& words, std::size_t first)
{
  const auto numbers = readNumbers({ words.begin() + static_cast<std::ptrdiff_t>(first), words.end() },
                                   Quantity{ "m", -FARTHEST_SETUP, true, FARTHEST_SETUP });
  return { numbers[0], numbers[1], numbers[2] };
}

std::size_t systemOf(const std::string& name)
{
  const std::string known = readChoice(name, { WORK_OFFSETS.begin(), WORK_OFFSETS.end() });
  return static_cast<std::size_t>(std::find(WORK_OFFSETS.begin(), WORK_OFFSETS.end(), known) - WORK_OFFSETS.begin());
}
void readTool(const Words& words, const Quantity& quantity, std::map<int, double>& tools)
{
  tools[static_cast<int>(readCount(words[0], MOST_TOOL))] = readNumbers({ words[1] }, quantity)[0];
}
}  // namespace

void JobOption::declare(Options& options, bool lists_lines)
{
  options.text(
      "gcode", job_.name, "FILE",
      std::string("job in G-code, in place of a file (docs/gcode.md lists what is read): each move at its feed") +
          (lists_lines ? ", every line that offends is listed" : ""));
  options.choice("interpreter", interpreter_, INTERPRETERS,
                 "who reads the job: this program the words that docs/gcode.md lists, or LinuxCNC's rs274, where it is "
                 "installed, the whole language");
  declareSetup(options);
  if (lists_lines)
    options.count("most-listed", job_.most_listed, MOST_OFFENCES, "offending lines of a job that are listed");
  options.check({ "gcode" }, [this, &options](Problems& problems) {
    for (const char* const name : { "origin", "tool-at", "work-offset", "tool-length", "tool-diameter", "rapid-feed",
                                    "most-listed", "interpreter" })
      if (!isGiven() && options.given(name))
        problems.push_back("--" + std::string(name) + " is without effect: it is about a job in G-code (--gcode)");
    if (isGiven() && options.given("tool-diameter") && interpreter_ == Interpreter::OWN)
      problems.push_back("--tool-diameter is without effect: G41 and G42 are read with --interpreter rs274 only");
  });
}

void JobOption::declareSetup(Options& options)
{
  options.words("origin", "X Y Z",
                "where the controller's zero is, in the frame of the root link [m]; 0 0 0 without it",
                [this](const Words& words) { job_.setup.origin = pointOf(words, 0); });
  options.words("tool-at", "X Y Z",
                "where the tool is before the job, in the frame of the root link [m]; unknown without "
                "it, until the job says X, Y and Z",
                [this](const Words& words) { job_.setup.start = pointOf(words, 0); });
  options.repeated("work-offset", "SYSTEM X Y Z", "offset of G54, ... G59.3 before the job [m]; 0 0 0 without it",
                   [this](const Words& words) { job_.setup.work_offsets[systemOf(words[0])] = pointOf(words, 1); });
  options.repeated("tool-length", "NUMBER LENGTH", "length of the tool that G43 H names by its number [m]",
                   [this](const Words& words) {
                     readTool(words, Quantity{ "m", -FARTHEST_SETUP, true, FARTHEST_SETUP }, job_.setup.tool_lengths);
                   });
  options.repeated("tool-diameter", "NUMBER DIAMETER",
                   "diameter of the tool that G41 D and G42 D name by its number [m]; for rs274",
                   [this](const Words& words) {
                     readTool(words, Quantity{ "m", 0.0, true, FARTHEST_SETUP }, job_.setup.tool_diameters);
                   });
  options.words("rapid-feed", "V",
                "speed of G0 [m/s], or 'programmed' where G0 goes at the feed in effect, as printers "
                "have it; without it G0 is held against no limit of speed",
                [this](const Words& words) {
                  job_.setup.rapids_have_feed = words[0] == "programmed";
                  if (!job_.setup.rapids_have_feed)
                    job_.rapid_feed = readNumbers(words, Quantity{ "m/s", SLOWEST_TOOL, true, FASTEST_TOOL })[0];
                });
}

void JobOption::describeTo(PathTask& task, Progress& progress, const End& end)
{
  job_.is_for_rs274 = interpreter_ == Interpreter::RS274;
  job_.is_over = end.is_over;
  job_.ended_by = end.ended_by;
  job_.read_lines = [this](const LineTaker& take) { readLines(job_.name, take); };
  job_.tell = [&progress](std::size_t lines, std::size_t offending) {
    progress.tell(std::to_string(lines) + " lines, " + std::to_string(offending) +
                  (offending == 1 ? " offends" : " offend"));
  };
  job_.remedies = { "--tool-at X Y Z", "--rapid-feed" };
  job_.describeTo(task);
}

void JobOption::addTo(Json& json) const
{
  json["interpreter"] = INTERPRETERS[static_cast<std::size_t>(interpreter_)];
  json["lines"] = job_.findings().lines;
  json["moves"] = job_.findings().summary.moves;
  json["unknown_moves"] = job_.findings().summary.unknown_moves;
  json["first_unknown"] =
      job_.findings().summary.first_unknown == 0 ? Json() : Json(job_.findings().summary.first_unknown);
  json["moves_without_feed"] = job_.findings().without_feed;
  json["ignored"] = job_.findings().summary.ignored;
}

void JobOption::addOffencesTo(const Machine& machine, Json& json) const
{
  json["outside"] = job_.findings().outside;
  json["undecided"] = job_.findings().undecided;
  json["offences"] = Json::array();
  for (const auto& [verdict, offence] : job_.findings().listed)
    json["offences"].push_back({ { "line", offence.segment },
                                 { "verdict", name(verdict) },
                                 { "good_until", offence.good_until },
                                 { "bad_at", offence.bad_at ? Json(*offence.bad_at) : Json() },
                                 { "point", toJson(offence.point) },
                                 { "tool_speed", offence.tool_speed.upper() },
                                 { "binding", toJson(machine, offence.limit) },
                                 { "reason", pkm_workspace::describe(offence.limit, machine) } });
}

void JobOption::addRows(std::vector<Words>& rows) const
{
  rows.push_back({ "lines", std::to_string(job_.findings().lines) });
  rows.push_back({ "moves", std::to_string(job_.findings().summary.moves) });
  Words ignored;
  for (const auto& [word, count] : job_.findings().summary.ignored)
    ignored.push_back(word + " (" + std::to_string(count) + ")");
  if (!ignored.empty())
    rows.push_back({ "ignored", joined(ignored, ", ") });
}

void JobOption::addOffenceRows(std::vector<Words>& rows) const
{
  rows.push_back({ "offending lines", std::to_string(job_.findings().offending()) });
}

std::string JobOption::offences(const Machine& machine) const
{
  std::string text;
  for (const auto& [verdict, offence] : job_.findings().listed)
    text += job_.place(offence.segment) + ": " + name(verdict) +
            " near t = " + nearly(offence.bad_at.value_or(offence.good_until), 6) + " of its way, about " +
            nearly(offence.point.x(), 6) + " " + nearly(offence.point.y(), 6) + " " + nearly(offence.point.z(), 6) +
            " m: " + pkm_workspace::describe(offence.limit, machine) + "\n";
  const std::size_t others = job_.findings().offending() - job_.findings().listed.size();
  return text + (others == 0 ? ""
                             : std::to_string(others) + (others == 1 ? " more line offends" : " more lines offend") +
                                   " (--most-listed)\n");
}
}  // namespace cli
}  // namespace pkm_workspace
