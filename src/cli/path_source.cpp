// SPDX-License-Identifier: BSD-3-Clause
#include "path_source.h"

#include <algorithm>

namespace pkm_workspace
{
namespace cli
{
void PathSource::declare(Options& options, const Words& others)
{
  options.text("file", file_, "FILE", "file with the lines of the path, in metres, in the frame of the root link");
  options.repeated("segment", "LINE", "one line of the path, in place of a file", [this](const Words& words) {
    Problems problems;
    path_.read(words[0], problems);
    throwProblems(problems);
  });
  job_.declare(options, others.empty());
  Words names = { "file", "segment", "gcode" };
  names.insert(names.end(), others.begin(), others.end());
  options.check(names, [this, &options, others](Problems& problems) { finish(options, others, problems); });
}

void PathSource::finish(const Options& options, const Words& others, Problems& problems)
{
  const bool has_other =
      std::any_of(others.begin(), others.end(), [&](const auto& name) { return options.given(name); });
  if (int(!file_.empty()) + int(options.given("segment")) + int(job_.isGiven()) + int(has_other) > 1)
    problems.push_back(others.empty() ? "the path is given twice" : "what is asked about is given twice");
  else if (!file_.empty())
    path_.readFile(file_, problems);
  if (!problems.empty() || isGiven() || has_other)
    return;
  std::string more;
  for (const std::string& name : others)
    more += ", --" + name + " FILE";
  problems.push_back((file_.empty() ? "" : file_ + " has no segment; ") +
                     std::string("a path is missing: --file FILE, --gcode FILE") + more +
                     ", or --segment LINE for each line, with one segment at least");
}

void PathSource::declareRates(Options& options, PathRatesTask& rates, bool may_ask_for_feed)
{
  options.number("tool-speed", rates.tool_speed, Quantity{ "m/s", SLOWEST_TOOL, true, FASTEST_TOOL },
                 std::string("constant speed of the tool along the path, at which the joints have to keep within their "
                             "limits; without it, ") +
                     (may_ask_for_feed ? "joint speeds are those for 1 m/s and are held against nothing"
                                       : "they count for nothing, but for the feeds of a job"));
  Words names = { "tool-speed", "joint-speeds-off", "joint-acceleration-max" };
  if (may_ask_for_feed)
  {
    options.flag("largest-feed", rates.largest_feed, "tell the largest feed without a tool speed, too");
    names.emplace_back("largest-feed");
  }
  options.flag("joint-speeds-off", rates.joint_speeds_off, "leave the velocity of the URDF aside");
  options.legs("joint-acceleration-max", "A", "largest acceleration of a joint [m/s^2], > 0; without it, any",
               [&rates](const Words& words) {
                 rates.joint_acceleration_max = readNumbers(words, Quantity{ "m/s^2", 0.0, false });
               });
  options.check(names, [this, &rates](Problems& problems) {
    rates.steps_have_speeds = job_.isGiven();
    rates.validate(problems);
  });
}
}  // namespace cli
}  // namespace pkm_workspace
