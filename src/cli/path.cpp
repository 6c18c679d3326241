// SPDX-License-Identifier: BSD-3-Clause
#include <deque>

#include "certificate_option.h"
#include "command.h"
#include "common_options.h"
#include "output.h"
#include "path_answer.h"
#include "path_source.h"
#include "pkm_workspace/interval/decimal.h"
#include "pkm_workspace/tasks/path.h"
#include "progress.h"

namespace pkm_workspace
{
namespace cli
{
namespace
{
const char* endName(PathResult::End end)
{
  constexpr const char* NAMES[] = { "complete", "looks", "stopped" };  // as PathResult::End
  return NAMES[static_cast<std::size_t>(end)];
}

class Path : public Command
{
public:
  std::string description() const override
  {
    return "Tells whether every point of a path is dextrous: inside, outside or undecided, for the path and each of "
           "its segments; where it first offends, and which condition binds there; and over the whole path bounds of "
           "the velocity transmission factors, of the joint values, and of the joint speeds at the tool's speed. With "
           "a tool speed the joints have to keep within their limits too: joint speeds within the velocity of the "
           "URDF, "
           "accelerations at that constant speed within those given; and the largest feed is told, for the path and "
           "each "
           "segment. Where segments meet at an angle, nothing is said of the turn. All of this is proved, and there is "
           "no tolerance. A path is written in lines: " +
           std::string(PATH_GRAMMAR) +
           ". Or it is a job in G-code, whose feeds are the tool's speeds: then every line that offends is listed.";
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
    source_.declare(options);
    source_.declareRates(options, task_.rates, true);
    options.count("max-looks", task_.query.max_looks, MOST_BOXES,
                  "pieces looked at before the rest stays undecided, beside what the length of the path calls for");
    declareTimeLimit(options, time_limit_);
    certificate_.declare(options);
    options.flag("progress", progress_, PROGRESS_HELP);
    declareCriterion(options, criterion_, machine_);
  }

  Words warnings() const override { return machine_.warnings(); }
  Words notes() const override { return machine_.notes(); }

  Answer answer() override
  {
    const Machine& machine = machine_.machine();
    certificate_.validate(machine, criterion_);
    const PathReport report = check();
    verdict_ = report.result.verdict;
    const PathResult& result = report.result;
    Json json = contextOf(machine, criterion_);
    json["verdict"] = name(result.verdict);
    json["looks"] = result.looks;
    json["end"] = endName(result.end);
    if (source_.job().isGiven())
    {
      source_.job().addTo(json);
      source_.job().addOffencesTo(machine, json);
    }
    else
    {
      json["tool_speed"] = report.query.tool_speed;
      json["first"] = result.first ? firstOf(result) : Json();
    }
    json["motion"] = result.motion ? motionJson(*result.motion) : Json();
    if (result.motion)
      addLimits(machine, criterion_, report.reaches, json);
    if (result.rates)
      json["rates"] = ratesOf(report);
    json["message"] = report.message;
    Answer answer{ json, Text([this, report] { return print(report); }) };
    if (source_.job().isGiven())
      return answer;
    const auto next = std::make_shared<std::size_t>(0);
    answer.long_members["segments"] =
        LongList{ [this, next] { return *next < checks_.size(); }, [this, next] { return segmentOf((*next)++); } };
    return answer;
  }

  void save() override
  {
    if (certificate_.given() && source_.job().isGiven())
      throw std::invalid_argument("certificates do not know jobs in G-code yet");
    certificate_.save(caller(), machine_.machine(), criterion_, verdict_, segments_, task_.rates.isHeld());
  }

private:
  PathReport check()
  {
    Progress progress = caller().progress(progress_);
    task_.query.stop = caller().stopAfter(time_limit_);
    task_.stopped_by = [this] { return caller().stoppedBy(time_limit_); };
    if (source_.job().isGiven())
      source_.job().describeTo(task_, progress, { [this] { return task_.query.stop->load(); }, task_.stopped_by });
    else
      describePath();
    PathReport report = checkPath(PointEvaluator(machine_.machine(), criterion_), task_);
    if (source_.job().isGiven())
      report.message = withRemark(report.message, source_.job().remark());
    return report;
  }

  void describePath()
  {
    task_.for_each = [this](const auto& use) {
      source_.text().handOver([&](const PathSegment& segment) {
        if (certificate_.given())
          segments_.push_back(segment);
        use(segment);
      });
    };
    task_.tell = [this](const SegmentCheck& check) {
      checks_.emplace_back(check);
      if (check.rates)
        rates_.push_back(*check.rates);
    };
    task_.place = [this](std::size_t segment) { return source_.text().place(segment); };
  }

  Json segmentOf(std::size_t segment) const
  {
    Json json = segmentJson(checks_[segment].check(), source_.text().place(segment));
    if (!rates_.empty())
      json["rates"] = ratesJson(rates_[segment], machine_.machine());
    return json;
  }

  /// Over the whole path, with what the joints were held against.
  Json ratesOf(const PathReport& report) const
  {
    Json json = ratesJson(*report.result.rates, machine_.machine());
    json["joint_speed_max"] = limitsJson(report.query.limits.speed);
    json["joint_acceleration_max"] = limitsJson(report.query.limits.acceleration);
    json["slowest_segment"] = report.result.slowest;
    return json;
  }

  Json firstOf(const PathResult& result) const
  {
    Json json = segmentJson(checks_[result.first->segment].check(), source_.text().place(result.first->segment));
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
    if (source_.job().isGiven())
    {
      source_.job().addRows(rows);
      source_.job().addOffenceRows(rows);
    }
    if (result.motion)
      addMotion(*result.motion, machine_.machine(), rows);
    if (result.rates)
      addRates(*result.rates, machine_.machine(), rows);
    rows.push_back({ "effort", std::to_string(result.looks) + " looks" });
    const std::string size = source_.job().isGiven()
                                 ? "a job"
                                 : std::to_string(checks_.size()) + (checks_.size() == 1 ? " segment" : " segments");
    const std::string offences = source_.job().isGiven() ? source_.job().offences(machine_.machine()) : "";
    return "Path of machine '" + machine_.machine().name() + "', " + size + "\n\n" + aligned(rows, Align::LEFT) + "\n" +
           feedTable(
               rates_, [this](std::size_t k) { return source_.text().place(k); }, machine_.machine()) +
           offences + (offences.empty() ? "" : "\n") + wrapped(report.message) +
           wrapped(definition(machine_.machine(), criterion_));
  }

  MachineOptions machine_;
  Criterion criterion_;
  PathTask task_;
  PathSource source_;
  CertificateOption certificate_;
  std::vector<PathSegment> segments_;  ///< for the certificate
  Containment verdict_ = Containment::UNDECIDED;
  double time_limit_;
  bool progress_ = false;
  std::deque<KeptCheck> checks_;  ///< one for each segment
  std::deque<PathRates> rates_;   ///< the same, where they are asked for
};
}  // namespace

std::unique_ptr<Command> makePath()
{
  return std::make_unique<Path>();
}
}  // namespace cli
}  // namespace pkm_workspace
