// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/tasks/singularities.h"
#include "command.h"
#include "comparison.h"
#include "output.h"
#include "progress.h"
#include "region_option.h"

namespace pkm_workspace
{
namespace cli
{
namespace
{
class FindThem : public Command
{
public:
  std::string description() const override
  {
    return "Proves that no point of a region, or no point that the struts reach, is singular, or a box in which one "
           "is. Serial: a strut at right angles to its rail, eta_i = 0. Parallel: struts in parallel planes, "
           "det A = 0. With --json: serial (one for each leg) and parallel, each with exists (true, false, or null "
           "when undecided), least (bounds of the least |eta_i| or |det A|) and box.";
  }

  Words examples() const override
  {
    return { "pkm singularities --urdf orthoglide.urdf --joint-limits off",
             "pkm singularities --urdf orthoglide.urdf --shape cube --center 0.0863 0.0863 0.0863 --size 0.6439" };
  }

  void declare(Options& options) override
  {
    machine_.declare(options);
    region_.declare(options, task_.region);
    options.choice("aspect", task_.query.aspect, ASPECT_NAMES,
                   "sign of det A at the points that count: that of the machine's zero configuration, the other, or "
                   "any; points where it is 0, the parallel singularities, count in each");
    options.onOff("joint-limits", task_.query.joint_limits, "whether only points within the URDF's joint limits count");
    options.number("accuracy", task_.query.accuracy, NUMBER_POSITIVE,
                   "wanted width of each enclosure, relative to its upper end");
    declareBudget(options, task_.query.budget);
    options.flag("progress", progress_, PROGRESS_HELP);
  }

  Words warnings() const override { return machine_.warnings(); }

  Remedy remedy() const override { return { "--joint-limits on", REGION_REMEDY }; }

  Answer answer() override
  {
    const Machine& machine = machine_.machine();
    task_.query.budget.stop = caller().stop();
    const Progress progress = caller().progress(progress_);
    const SingularityReport report = findSingularities(machine, task_);
    Json json = contextOf(machine, task_.criterion());
    json["over"] = task_.region ? "region" : "set";
    json["serial"] = Json::array();
    for (const SingularityAnswer& leg : report.found.serial)
      json["serial"].push_back(toJson(leg));
    json["parallel"] = toJson(report.found.parallel);
    json["seconds"] = report.found.seconds;
    addLimits(machine, task_.criterion(), report.reaches, json);
    json["message"] = report.message;
    return { json, print(report.found, report.message) };
  }

private:
  std::string print(const Singularities& found, const std::string& message) const
  {
    const Machine& machine = machine_.machine();
    std::vector<Words> rows = { { "singularities", "exist", "least measure" } };
    const auto add = [&rows](const std::string& what, const SingularityAnswer& answer, const std::string& measure) {
      rows.push_back({ what, verdictOn(answer), measure + " " + describe(answer.least) });
    };
    for (int i = 0; i < 3; ++i)
      add("serial, " + machine.leg(i).joint, found.serial[static_cast<std::size_t>(i)], "|eta| [m]");
    add("parallel", found.parallel, "|det A| [m^3]");
    return "Singularities of machine '" + machine.name() + "' " +
           (task_.region ? "in the " + task_.region->solid.shape->name() : "at all points that the struts reach") +
           (task_.query.joint_limits ? " within the joint limits" : "") + "\n\n" + aligned(rows, Align::LEFT) + "\n" +
           wrapped(definition(machine, task_.criterion())) + wrapped(message + " " + seconds(found.seconds) + ".");
  }

  MachineOptions machine_;
  RegionOption region_;
  SingularityTask task_;
  bool progress_ = false;
};
}  // namespace

std::unique_ptr<Command> makeSingularities()
{
  return std::make_unique<FindThem>();
}
}  // namespace cli
}  // namespace pkm_workspace
