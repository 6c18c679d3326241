// SPDX-License-Identifier: BSD-3-Clause
#include "command.h"
#include "comparison.h"
#include "output.h"
#include "pkm_workspace/paving/workspace_conditioning.h"
#include "pkm_workspace/region/region_parts.h"
#include "pkm_workspace/report/conditioning_sentence.h"
#include "pkm_workspace/report/set_reach.h"
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
    region_.declare(options);
    declareCriterion(options, criterion_);
    options.check({ "center" }, [this, &options](Problems& problems) {
      for (const std::string& name : criterionOptions())
        if (region_.given() && options.given(name))
          problems.push_back("all points of a region count: leave out --" + name);
    });
    options.number("accuracy", query_.accuracy, NUMBER_POSITIVE, "wanted width of the enclosure");
    declareBudget(options, query_.budget);
    options.flag("progress", progress_, PROGRESS_HELP);
  }

  Words warnings() const override { return machine_.warnings(); }

  Remedy remedy() const override { return { "--joint-limits on", REGION_REMEDY }; }

  Answer answer() override
  {
    query_.budget.stop = stopOnSignal();
    const Progress progress(progress_);
    const Machine& machine = machine_.machine();
    const GlobalConditioning found =
        region_.given() ? globalConditioning(machine, *region_.shape(), region_.center(), region_.size(), query_)
                        : workspaceConditioning(machine, criterion_, query_);
    const std::optional<JointReaches> reaches = region_.given() ? std::nullopt : reachOver(machine, criterion_);
    Json json = region_.given() ? contextOf(machine) : contextOf(machine, criterion_);
    json["over"] = region_.given() ? "region" : "set";
    json["index"] = toJson(found.index);
    json["measure"] = toJson(found.measure);
    json["accuracy"] = query_.accuracy;
    json["complete"] = found.complete;
    json["boxes"] = found.boxes;
    json["seconds"] = found.seconds;
    if (!region_.given())
      addLimits(machine, criterion_, reaches, json);
    const std::string message = pkm_workspace::describe(found, query_.budget);
    const std::string remark = remarkOnLimits(machine, criterion_, reaches);
    json["message"] = withRemark(message, remark);
    return { json, print(found, message) + wrapped(remark) };
  }

private:
  std::string print(const GlobalConditioning& found, const std::string& message) const
  {
    const std::string over = region_.given() ? "the " + region_.shape()->name() : "the set";
    const std::vector<Words> rows = { { "global conditioning index", describe(found.index) },
                                      { "averaged over", describe(found.measure) + " m^" +
                                                             std::to_string(found.dimension) + ", the measure of " +
                                                             over },
                                      { "effort", std::to_string(found.boxes) + " boxes, " + seconds(found.seconds) } };
    return aligned(rows, Align::LEFT) + "\n" + wrapped(message) +
           (region_.given() ? "" : wrapped(definition(machine_.machine(), criterion_)));
  }

  MachineOptions machine_;
  RegionOption region_;
  Criterion criterion_;
  ConditioningQuery query_;
  bool progress_ = false;
};
}  // namespace

std::unique_ptr<Command> makeConditioning()
{
  return std::make_unique<Conditioning>();
}
}  // namespace cli
}  // namespace pkm_workspace
