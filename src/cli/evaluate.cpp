// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/LU>
#include <algorithm>
#include <ostream>

#include "command.h"
#include "common_options.h"
#include "output.h"
#include "pkm_workspace/interval/decimal.h"
#include "pkm_workspace/report/point_sentence.h"
#include "progress.h"

namespace pkm_workspace
{
namespace cli
{
namespace
{
/// Whether det A has the sign of the machine's own aspect.
BoxVerdict ownAspect(const Machine& machine, const PointEvaluation& there)
{
  if (!there.has_values || there.det_a.contains(0.0))
    return BoxVerdict::UNDECIDED;
  const int sign = there.det_a.certainlyPositive() ? 1 : -1;
  return sign == machine.aspect() ? BoxVerdict::INSIDE : BoxVerdict::OUTSIDE;
}

/// In floating point.
Json numbersOf(const Machine& machine, const Eigen::Vector3d& point)
{
  Json json = { { "psi", Json() },
                { "rho", Json() },
                { "condition", Json() },
                { "det_a", Json() },
                { "serial_singularity", Json() },
                { "parallel_singularity", Json() } };
  const auto rho = inverseKinematics(machine, point);
  if (rho)
    json["rho"] = toJson(*rho);
  const auto jacobian = jacobians(machine, point);
  if (!jacobian)
    return json;
  const Eigen::Vector3d psi = transmissionFactors(*jacobian);
  const SingularityMeasures measures = singularityMeasures(*jacobian);
  json["psi"] = toJson(psi);
  json["condition"] = psi[2] / psi[0];
  json["det_a"] = jacobian->a.determinant();
  json["serial_singularity"] = measures.serial;
  json["parallel_singularity"] = measures.parallel;
  return json;
}

/// A boolean, a number or a list of numbers, for people.
std::string text(const Json& value, const std::string& unit)
{
  if (value.is_boolean())
    return (value.get<bool>() ? "yes" : "no") + unit;
  if (value.is_number())
    return nearly(value) + unit;
  Words words;
  for (const Json& entry : value)
    words.push_back(text(entry, unit));
  return joined(words, "  ");
}

/// The joint values, each in its unit.
std::string jointsText(const Json& values, const Machine& machine)
{
  Words words;
  for (std::size_t i = 0; i < 3; ++i)
    words.push_back(text(values[i], std::string(" ") + unitOf(machine.legs()[i])));
  return joined(words, "  ");
}

std::string padded(const std::string& text, std::size_t width)
{
  return std::string(width - std::min(width, text.size()), ' ') + text;
}

std::string bindingText(const Json& binding)
{
  const Json& joint = binding["joint"];
  const Json& margin = binding["margin"];
  return binding["limit"].get<std::string>() + (joint.is_null() ? "" : " of '" + joint.get<std::string>() + "'") +
         (margin.is_null() ? "" : "   (margin " + nearly(margin) + ")");
}

std::string verdictText(const Json& value)
{
  return value.is_null() ? "undecided" : text(value, " (proved)");
}

class Evaluate : public Command
{
public:
  std::string description() const override
  {
    return "Tells how the machine stands at one tool point: joint values, velocity transmission factors psi "
           "(singular values of J^-1), condition number of J, nearness to singularities, and whether the "
           "point is dextrous, or satisfies whatever is asked for, with the condition that binds there. The verdicts "
           "and the bounds that --json adds are proved; the other numbers are in floating point. With --points, the "
           "same for every point of a file.";
  }

  Words examples() const override { return { "pkm evaluate --urdf orthoglide.urdf --point -0.1 0 0.2" }; }

  void declare(Options& options) override
  {
    machine_.declare(options);
    options.vector("point", point_, "X Y Z", LENGTH, "tool point, in the frame of the root link");
    options.points("points", points_, "file of tool points in place of --point: one a line, as X Y Z [m]");
    options.check({ "point", "points" }, [this](Problems& problems) {
      if (point_.has_value() != points_.empty())
        problems.push_back("give either --point X Y Z, or --points FILE with one point or more");
    });
    declareCriterion(options, criterion_, machine_);
    declareTimeLimit(options, time_limit_);
    options.flag("progress", progress_, PROGRESS_HELP);
  }

  Words warnings() const override { return machine_.warnings(); }
  Words notes() const override { return machine_.notes(); }

  Answer answer() override
  {
    Json json = contextOf(machine_.machine(), criterion_);
    json["joints"] = Json::array();
    for (const Leg& leg : machine_.machine().legs())
      json["joints"].push_back(leg.joint);
    const auto evaluator = std::make_shared<const PointEvaluator>(machine_.machine(), criterion_);
    if (point_)
    {
      json.update(stateAt(*evaluator, *point_));
      return { json, Text([this, json] { return print(json); }) };
    }
    const std::atomic<bool>* const stop = caller().stopAfter(time_limit_);
    const auto progress = std::shared_ptr<const Progress>(new Progress(caller().progress(progress_)));
    goes_on_ = [this, stop, progress] { return evaluated_ < points_.size() && !*stop; };
    Answer answer{ json, "" };
    answer.long_members["points"] =
        LongList{ goes_on_, [this, evaluator] { return stateAt(*evaluator, points_[evaluated_++]); } };
    answer.long_members["points_left"] = [this] { return Json(points_.size() - evaluated_); };
    answer.long_text = [this, evaluator](std::ostream& out) { writeTable(*evaluator, out); };
    return answer;
  }

private:
  Json stateAt(const PointEvaluator& evaluator, const Eigen::Vector3d& point) const
  {
    const Machine& machine = machine_.machine();
    const PointEvaluation there = evaluator(point);
    Json json = numbersOf(machine, point);
    json["point"] = toJson(point);
    json["within_reach"] = toJson(there.within_reach);
    json["satisfies"] = toJson(there.verdict);
    if (criterion_.set == Criterion::Set::DEXTROUS)
      json["dextrous"] = json["satisfies"];
    json["aspect_ok"] = there.within_reach == BoxVerdict::OUTSIDE ? Json() : toJson(ownAspect(machine, there));
    json["psi_bounds"] = there.has_values ? toJson(there.psi) : Json();
    json["rho_bounds"] = there.has_values ? toJson(there.rho) : Json();
    json["binding"] = toJson(machine, there.binding());
    json["message"] = pkm_workspace::describe(there, evaluator);
    if (there.verdict == BoxVerdict::INSIDE)
      addLimits(machine, criterion_, reachAt(there.rho), json);
    return json;
  }

  /// A row for each point; only the columns' widths are known before.
  void writeTable(const PointEvaluator& evaluator, std::ostream& out)
  {
    constexpr std::size_t PSI_WIDTH = 11, VERDICT_WIDTH = 9;
    std::size_t point_width = std::string("point [m]").size();
    for (const Eigen::Vector3d& point : points_)
      for (const double x : { point.x(), point.y(), point.z() })
        point_width = std::max(point_width, exact(x).size());
    const auto write = [&](const Words& row) {
      out << "  " << row[0] << std::string(point_width - row[0].size(), ' ');
      for (std::size_t k = 1; k < row.size(); ++k)
        out << "   " << padded(row[k], k < 3 ? point_width : k < 6 ? PSI_WIDTH : VERDICT_WIDTH);
      out << '\n';
    };
    write({ "point [m]", "", "", "psi", "", "", name(criterion_.set) });
    std::optional<JointReaches> reaches;
    while (goes_on_())
      write(rowAt(evaluator, points_[evaluated_++], reaches));
    out << '\n' << wrapped(conclusion(reaches)) << wrapped(definition(machine_.machine(), criterion_));
  }

  /// What ended the table early, and what is told of joint limits that nobody asked for.
  std::string conclusion(const std::optional<JointReaches>& reaches) const
  {
    const std::size_t left = points_.size() - evaluated_;
    const std::string text =
        left == 0
            ? ""
            : std::to_string(left) + " points are left out: " + caller().stoppedBy(time_limit_) + " ended the proof.";
    const std::string remark = remarkOnLimits(machine_.machine(), criterion_, reaches);
    return text.empty() ? remark : withRemark(text, remark);
  }

  /// @param reaches takes those of points that satisfy the criterion in
  Words rowAt(const PointEvaluator& evaluator, const Eigen::Vector3d& point, std::optional<JointReaches>& reaches) const
  {
    Words row = { exact(point.x()), exact(point.y()), exact(point.z()), "-", "-", "-" };
    if (const auto jacobian = jacobians(machine_.machine(), point))
    {
      const Eigen::Vector3d psi = transmissionFactors(*jacobian);
      for (int k = 0; k < 3; ++k)
        row[static_cast<std::size_t>(3 + k)] = nearly(psi[k], 6);
    }
    const PointEvaluation there = evaluator(point);
    const BoxVerdict verdict = there.verdict;
    if (verdict == BoxVerdict::INSIDE)
      reaches = reaches ? united(*reaches, reachAt(there.rho)) : reachAt(there.rho);
    row.push_back(verdict == BoxVerdict::UNDECIDED ? "undecided" : verdict == BoxVerdict::INSIDE ? "yes" : "no");
    return row;
  }

  std::string print(const Json& json) const
  {
    std::vector<Words> rows = { { "within reach", verdictText(json["within_reach"]) },
                                { name(criterion_.set), verdictText(json["satisfies"]) } };
    const auto add = [&](const char* label, const char* key, const std::string& unit) {
      if (!json[key].is_null())
        rows.push_back({ label, text(json[key], unit) });
    };
    add("own aspect", "aspect_ok", " (proved)");
    add("psi", "psi", "");
    add("condition of J", "condition", "");
    if (!json["rho"].is_null())
      rows.push_back({ "rho", jointsText(json["rho"], machine_.machine()) });
    add("serial", "serial_singularity", "   (least |eta| / L; 0 at a serial singularity)");
    add("parallel", "parallel_singularity", "   (|det A| / (L1 L2 L3); 0 at a parallel singularity)");
    add("det A", "det_a", " m^3");
    rows.push_back({ "binding", bindingText(json["binding"]) });
    return "Machine '" + machine_.machine().name() + "' at the tool point " + describe(*point_) + "\n\n" +
           aligned(rows, Align::LEFT) + "\n" + wrapped(json["message"]) +
           wrapped(definition(machine_.machine(), criterion_));
  }

  MachineOptions machine_;
  Criterion criterion_;
  std::optional<Eigen::Vector3d> point_;
  std::vector<Eigen::Vector3d> points_;
  double time_limit_;
  bool progress_ = false;
  std::size_t evaluated_ = 0;  ///< of the points
  std::function<bool()> goes_on_;
};
}  // namespace

std::unique_ptr<Command> makeEvaluate()
{
  return std::make_unique<Evaluate>();
}
}  // namespace cli
}  // namespace pkm_workspace
