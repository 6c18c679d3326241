// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/tasks/guarantee.h"

#include <cmath>

#include "command.h"
#include "common_options.h"
#include "output.h"
#include "pkm_workspace/dexterity/joint_data.h"
#include "pkm_workspace/interval/decimal.h"
#include "progress.h"
#include "region_option.h"

namespace pkm_workspace
{
namespace cli
{
namespace
{
class GuaranteeCommand : public Command
{
public:
  std::string description() const override
  {
    return "Tells how fast, strongly, stiffly and exactly the tool can be relied on everywhere in a region: of each "
           "quantity the best value that every point keeps, as a bracket. One end is proved for all points; at the "
           "place that is told, no better one than the other end is kept, and the leg that is told is why. Quantities "
           "are those of the criterion's options; without --quantity, all of which enough is known.";
  }

  Words examples() const override
  {
    return { "pkm guarantee --urdf orthoglide.urdf --center 0.08 0.08 0.08 --sides 0.6 0.6 0.6",
             "pkm guarantee --urdf orthoglide.urdf --center 0 0 0 --radius 0.2 --quantity stiffness_min "
             "--joint-stiffness 1e6" };
  }

  void declare(Options& options) override
  {
    machine_.declare(options);
    options.vector("center", center_, "X Y Z", LENGTH, "center of the region, in the frame of the root link");
    body_.declare(options);
    options.repeated(
        "quantity", "NAME", "one of " + joined(GuaranteeTask::names(), ", ") + "; may be given several times",
        [this](const Words& words) { task_.quantities.push_back(readChoice(words[0], GuaranteeTask::names())); });
    options.choice("aspect", task_.query.criterion.aspect, ASPECT_NAMES,
                   "sign of det A in the region: that of the machine's zero configuration, the other, or any");
    const auto counts = [](const JointDatum& datum) { return !datum.isBound(); };
    declareJointData(options, task_.query.criterion, counts);
    options.number("accuracy", task_.query.accuracy, Quantity{ "", 1e-12, true, 1.0 },
                   "wanted relative width of a bracket");
    declareBudget(options, task_.query.budget);
    options.flag("progress", progress_, PROGRESS_HELP);
    options.require({ "center" });
    options.check({ "size", "sides", "radius", "height" }, [this, &options](Problems& problems) {
      if (!body_.given() && !options.given("shape"))
        problems.push_back("give the region: --sides A B C, --radius R, --radius R --height H, or --shape and --size");
    });
    Words names = { "quantity", "urdf", "rails", "tcp-links", "tool-link", "tool", "ball-axes" };
    for (const JointDatum& datum : JOINT_DATA)
      if (counts(datum))
        names.push_back(optionOf(datum.name));
    options.check(names, [this](Problems& problems) { task_.bounds(machine_.machine(), left_out_, problems); });
  }

  Words warnings() const override { return machine_.warnings(); }
  Words notes() const override
  {
    Words notes = machine_.notes();
    notes.insert(notes.end(), left_out_.begin(), left_out_.end());
    return notes;
  }

  Answer answer() override
  {
    task_.query.budget.stop = caller().stop();
    Progress progress = caller().progress(progress_);
    task_.region = { body_.solid(), *center_ };
    task_.tell = [&progress](const Guarantee& found) {
      progress.tell(std::string(found.bound->name) + " " + bracket(found.value.lower(), found.value.upper()));
    };
    const Machine& machine = machine_.machine();
    const Solid& solid = body_.solid();
    Json json = contextOf(machine);
    json["center"] = toJson(*center_);
    json["shape"] = solid.shape->name();
    json["dimensions"] = solid.shape->dimensions(solid.size);
    json["aspect"] = name(task_.query.criterion.aspect);
    json["accuracy"] = task_.query.accuracy;
    json["guarantees"] = Json::array();
    std::vector<Words> rows = { { "quantity", "guaranteed", "not better than", "unit", "place", "leg" } };
    std::string sentences;
    const GuaranteeReport report = guaranteed(machine, task_);
    for (std::size_t k = 0; k < report.found.size(); ++k)
    {
      rows.push_back(rowOf(report.found[k]));
      json["guarantees"].push_back(jsonOf(report.found[k], report.messages[k]));
      sentences += wrapped(report.messages[k]);
    }
    return { json, "Machine '" + machine.name() + "', " + solid.shape->name() + " with center " +
                       pkm_workspace::cli::describe(*center_) + "\n\n" + aligned(rows, Align::LEFT) + "\n" +
                       sentences };
  }

private:
  std::string legOf(const Guarantee& found) const
  {
    return found.limit && found.limit->leg >= 0 ? machine_.machine().leg(found.limit->leg).joint : "";
  }

  Words rowOf(const Guarantee& found) const
  {
    const bool is_lower = found.bound->is_lower;
    const double proved = found.proved();
    const double other = is_lower ? found.value.upper() : found.value.lower();
    return { found.bound->name,
             proved > 0.0 && std::isfinite(proved) ? towards(proved, is_lower) : "nothing",
             other > 0.0 && std::isfinite(other) ? towards(other, !is_lower) : "-",
             found.bound->unit,
             placeOf(found.place),
             legOf(found) };
  }

  static std::string placeOf(const Eigen::Vector3d& p)
  {
    constexpr int DIGITS = 6;
    return "(" + nearly(p.x(), DIGITS) + ", " + nearly(p.y(), DIGITS) + ", " + nearly(p.z(), DIGITS) + ") m";
  }

  static std::string towards(double value, bool down)
  {
    constexpr int DIGITS = 6;
    return down ? significantBelow(value, DIGITS) : significantAbove(value, DIGITS);
  }

  Json jsonOf(const Guarantee& found, const std::string& message) const
  {
    return { { "quantity", found.bound->name },
             { "unit", found.bound->unit },
             { "value", toJson(found.value) },
             { "proved", found.is_reached && found.proved() > 0.0 && std::isfinite(found.proved())
                             ? Json(found.proved())
                             : Json() },
             { "place", toJson(found.place) },
             { "joint", legOf(found).empty() ? Json() : Json(legOf(found)) },
             { "complete", found.complete },
             { "boxes", found.boxes },
             { "seconds", found.seconds },
             { "message", message } };
  }

  MachineOptions machine_;
  BodyOption body_;
  std::optional<Eigen::Vector3d> center_;
  GuaranteeTask task_;
  Words left_out_;
  bool progress_ = false;
};
}  // namespace

std::unique_ptr<Command> makeGuarantee()
{
  return std::make_unique<GuaranteeCommand>();
}
}  // namespace cli
}  // namespace pkm_workspace
