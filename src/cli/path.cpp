// SPDX-License-Identifier: BSD-3-Clause
#include <deque>
#include <variant>

#include "command.h"
#include "common_options.h"
#include "output.h"
#include "path_text.h"
#include "pkm_workspace/interval/decimal.h"
#include "pkm_workspace/tasks/path.h"
#include "progress.h"

namespace pkm_workspace
{
namespace cli
{
namespace
{
Json motionJson(const PathMotion& motion)
{
  return { { "psi", toJson(motion.psi) },
           { "rho", toJson(motion.joint) },
           { "joint_speed", { motion.joint_speed[0], motion.joint_speed[1], motion.joint_speed[2] } } };
}

const char* endName(PathResult::End end)
{
  constexpr const char* NAMES[] = { "complete", "looks", "stopped" };  // as PathResult::End
  return NAMES[static_cast<std::size_t>(end)];
}

/// A SegmentCheck in few bytes: a path may have millions of them.
class KeptCheck
{
public:
  explicit KeptCheck(const SegmentCheck& check)
  {
    if (check.motion)
      found_ = *check.motion;
    else
      found_ = Open{ check.verdict, check.good_until, check.bad_at };
  }

  SegmentCheck check() const
  {
    if (const auto* const motion = std::get_if<PathMotion>(&found_))
      return { Containment::INSIDE, 1.0, std::nullopt, *motion };
    const Open& open = std::get<Open>(found_);
    return { open.verdict, open.good_until, open.bad_at, std::nullopt };
  }

private:
  struct Open
  {
    Containment verdict;
    double good_until;
    std::optional<double> bad_at;
  };
  std::variant<PathMotion, Open> found_;
};

class Path : public Command
{
public:
  std::string description() const override
  {
    return "Tells whether every point of a path is dextrous: inside, outside or undecided, for the path and each of "
           "its segments; where it first offends, and which condition binds there; and over the whole path bounds of "
           "the velocity transmission factors, of the joint values, and of the joint speeds at the tool's speed. All "
           "of this is proved, and there is no tolerance. A path is written in lines: " +
           std::string(PATH_GRAMMAR) + ".";
  }

  Words examples() const override
  {
    return {
      "pkm path --urdf orthoglide.urdf --segment 'start 0 0 0' --segment 'line 0.1 0 0' --segment 'arc 0.2 0.1 "
      "0 0.1 0.2 0'"
    };
  }

  void declare(Options& options) override
  {
    machine_.declare(options);
    options.text("file", file_, "FILE", "file with the lines of the path, in metres, in the frame of the root link");
    options.repeated("segment", "LINE", "one line of the path, in place of a file", [this](const Words& words) {
      Problems problems;
      path_.read(words[0], problems);
      throwProblems(problems);
    });
    options.number("tool-speed", task_.query.tool_speed, Quantity{ "m/s", SLOWEST_TOOL, true, FASTEST_TOOL },
                   "speed of the tool along the path");
    options.count("max-looks", task_.query.max_looks, MOST_BOXES,
                  "pieces looked at before the rest stays undecided, beside what the length of the path calls for");
    declareTimeLimit(options, time_limit_);
    options.flag("progress", progress_, PROGRESS_HELP);
    declareCriterion(options, criterion_, machine_);
    options.check({ "file", "segment" }, [this](Problems& problems) { finishPath(problems); });
  }

  Words warnings() const override { return machine_.warnings(); }
  Words notes() const override { return machine_.notes(); }

  Answer answer() override
  {
    const Machine& machine = machine_.machine();
    const PathReport report = check();
    const PathResult& result = report.result;
    Json json = contextOf(machine, criterion_);
    json["verdict"] = name(result.verdict);
    json["tool_speed"] = task_.query.tool_speed;
    json["looks"] = result.looks;
    json["end"] = endName(result.end);
    json["first"] = result.first ? firstOf(result) : Json();
    json["motion"] = result.motion ? motionJson(*result.motion) : Json();
    if (result.motion)
      addLimits(machine, criterion_, report.reaches, json);
    json["message"] = report.message;
    Answer answer{ json, print(report) };
    answer.long_members["segments"] = [this](std::ostream& out) {
      writeList(
          checks_.size(), [this](std::size_t i) { return segmentOf(checks_[i].check(), path_.place(i)); }, 2, out);
    };
    return answer;
  }

private:
  PathReport check()
  {
    task_.query.stop = stopOnSignalOrAfter(time_limit_);
    task_.for_each = [this](const auto& use) { path_.handOver(use); };
    task_.tell = [this](const SegmentCheck& check) { checks_.emplace_back(check); };
    task_.place = [this](std::size_t segment) { return path_.place(segment); };
    task_.stopped_by = [this] { return stoppedBy(time_limit_); };
    const PointEvaluator evaluator(machine_.machine(), criterion_);
    const Progress progress(progress_);
    return checkPath(evaluator, task_);
  }

  void finishPath(Problems& problems)
  {
    const bool has_lines = path_.size() > 0;
    if (!file_.empty() && has_lines)
      problems.push_back("the path is given twice");
    else if (!file_.empty())
      path_.readFile(file_, problems);
    if (problems.empty() && path_.size() == 0)
      problems.push_back(
          (file_.empty() ? "" : file_ + " has no segment; ") +
          std::string("a path is missing: --file FILE, or --segment LINE for each line, with one segment at least"));
  }

  static Json segmentOf(const SegmentCheck& check, const std::string& place)
  {
    return { { "place", place },
             { "verdict", name(check.verdict) },
             { "good_until", check.good_until },
             { "bad_at", check.bad_at ? Json(*check.bad_at) : Json() },
             { "motion", check.motion ? motionJson(*check.motion) : Json() } };
  }

  Json firstOf(const PathResult& result) const
  {
    Json json = segmentOf(checks_[result.first->segment].check(), path_.place(result.first->segment));
    json.erase("motion");
    json["open"] = Json::array();
    for (const PathPart& part : result.first->open)
      json["open"].push_back({ part.first, part.last });
    json["segment"] = result.first->segment;
    json["point"] = toJson(result.first->point);
    json["binding"] = toJson(machine_.machine(), result.first->limit);
    return json;
  }

  std::string print(const PathReport& report) const
  {
    const PathResult& result = report.result;
    std::vector<Words> rows = { { "verdict", name(result.verdict) } };
    if (result.motion)
      addMotion(*result.motion, rows);
    rows.push_back({ "effort", std::to_string(result.looks) + " looks" });
    return "Path of machine '" + machine_.machine().name() + "', " + std::to_string(checks_.size()) +
           (checks_.size() == 1 ? " segment" : " segments") + "\n\n" + aligned(rows, Align::LEFT) + "\n" +
           wrapped(report.message) + wrapped(definition(machine_.machine(), criterion_));
  }

  /// The factors are those of the machine, the rest is told leg by leg.
  void addMotion(const PathMotion& motion, std::vector<Words>& rows) const
  {
    for (std::size_t i = 0; i < 3; ++i)
      rows.push_back({ "psi " + std::to_string(i + 1), bracket(motion.psi[i].lower(), motion.psi[i].upper()) });
    for (std::size_t i = 0; i < 3; ++i)
    {
      const std::string joint = "'" + machine_.machine().legs()[i].joint + "'";
      rows.push_back({ "rho of " + joint, bracket(motion.joint[i].lower(), motion.joint[i].upper()) + " m" });
      rows.push_back({ "speed of " + joint, "up to " + significantAbove(motion.joint_speed[i], 6) + " m/s" });
    }
  }

  MachineOptions machine_;
  Criterion criterion_;
  PathTask task_;
  PathText path_;
  std::string file_;
  double time_limit_;
  bool progress_ = false;
  std::deque<KeptCheck> checks_;  ///< one for each segment
};
}  // namespace

std::unique_ptr<Command> makePath()
{
  return std::make_unique<Path>();
}
}  // namespace cli
}  // namespace pkm_workspace
