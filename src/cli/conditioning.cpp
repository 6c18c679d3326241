// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/tasks/conditioning.h"
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
class Conditioning : public Command
{
public:
  std::string description() const override
  {
    return "Encloses the global conditioning index: the mean of 1 / kappa, kappa the condition number of J, over a "
           "region given by --center and --size, --sides or --radius, or over all points of the criterion's set. 1 is "
           "isotropic everywhere, 0 singular everywhere. Flat regions, and the sections of machines that do not change "
           "along their rails, are averaged over their area. With --json: index and measure (the volume of what was "
           "averaged over) as [lower, upper], complete, boxes, seconds.";
  }

  Words examples() const override
  {
    return { "pkm conditioning --urdf orthoglide.urdf --shape cube --center 0.0863 0.0863 0.0863 --size 0.6439",
             "pkm conditioning --urdf orthoglide.urdf --accuracy 0.05" };
  }

  void declare(Options& options) override
  {
    machine_.declare(options);
    region_.declare(options, task_.region);
    declareCriterion(options, task_.criterion, machine_, [this] { return !task_.region; });
    options.check({ "center" }, [this, &options](Problems& problems) {
      Words names = criterionOptions();
      names.push_back("psi");
      for (const std::string& name : names)
        if (task_.region && options.given(name))
          problems.push_back("all points of a region count: leave out --" + name);
    });
    options.number("accuracy", task_.query.accuracy, NUMBER_POSITIVE, "wanted width of the enclosure");
    declareBudget(options, task_.query.budget);
    options.flag("progress", progress_, PROGRESS_HELP);
  }

  Words warnings() const override { return machine_.warnings(); }
  Words notes() const override { return machine_.notes(); }

  Remedy remedy() const override { return { "--joint-limits on", REGION_REMEDY }; }

  Answer answer() override
  {
    task_.query.budget.stop = caller().stop();
    const Progress progress = caller().progress(progress_);
    const Machine& machine = machine_.machine();
    const ConditioningReport report = globalConditioning(machine, task_);
    const GlobalConditioning& found = report.found;
    Json json = task_.region ? contextOf(machine) : contextOf(machine, task_.criterion);
    json["over"] = task_.region ? "region" : "set";
    json["index"] = toJson(found.index);
    json["measure"] = toJson(found.measure);
    json["accuracy"] = task_.query.accuracy;
    json["complete"] = found.complete;
    json["boxes"] = found.boxes;
    json["seconds"] = found.seconds;
    if (!task_.region)
      addLimits(machine, task_.criterion, report.reaches, json);
    json["message"] = report.message;
    return { json, Text([this, report] { return print(report.found, report.message); }) };
  }

private:
  std::string print(const GlobalConditioning& found, const std::string& message) const
  {
    const std::string over = task_.region ? "the " + task_.region->solid.shape->name() : "the set";
    const std::vector<Words> rows = { { "global conditioning index", describe(found.index) },
                                      { "averaged over", describe(found.measure) + " m^" +
                                                             std::to_string(found.dimension) + ", the measure of " +
                                                             over },
                                      { "effort", std::to_string(found.boxes) + " boxes, " + seconds(found.seconds) } };
    return aligned(rows, Align::LEFT) + "\n" + wrapped(message) +
           (task_.region ? "" : wrapped(definition(machine_.machine(), task_.criterion)));
  }

  MachineOptions machine_;
  RegionOption region_;
  ConditioningTask task_;
  bool progress_ = false;
};
}  // namespace

std::unique_ptr<Command> makeConditioning()
{
  return std::make_unique<Conditioning>();
}
}  // namespace cli
}  // namespace pkm_workspace
