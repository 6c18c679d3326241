// SPDX-License-Identifier: BSD-3-Clause
#include "command.h"
#include "comparison.h"
#include "output.h"
#include "pkm_workspace/region/region_parts.h"
#include "pkm_workspace/report/set_reach.h"
#include "pkm_workspace/report/singularity_sentence.h"
#include "progress.h"
#include "region_option.h"

namespace pkm_workspace
{
namespace cli
{
namespace
{
Criterion reachableAnywhere()
{
  Criterion criterion = anyReachable();
  criterion.joint_limits = defaultCriterion().joint_limits;
  return criterion;
}

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
    region_.declare(options);
    options.choice("aspect", criterion_.aspect, ASPECT_NAMES,
                   "sign of det A at the points that count: that of the machine's zero configuration, the other, or "
                   "any; points where it is 0, the parallel singularities, count in each");
    options.onOff("joint-limits", criterion_.joint_limits, "whether only points within the URDF's joint limits count");
    options.number("accuracy", query_.accuracy, NUMBER_POSITIVE,
                   "wanted width of each enclosure, relative to its upper end");
    declareBudget(options, query_.budget);
    options.flag("progress", progress_, PROGRESS_HELP);
  }

  Words warnings() const override { return machine_.warnings(); }

  Remedy remedy() const override { return { "--joint-limits on", REGION_REMEDY }; }

  Answer answer() override
  {
    const Machine& machine = machine_.machine();
    SingularityQuery query = query_;
    if (region_.given())
    {
      const SingularityQuery within = singularitiesOver(region_.shape(), region_.center(), region_.size());
      query.box = within.box;
      query.part = within.part;
    }
    query.joint_limits = criterion_.joint_limits;
    query.aspect = criterion_.aspect;
    query.budget.stop = stopOnSignal();
    const Progress progress(progress_);
    const Singularities found = findSingularities(machine, query);
    const std::optional<JointReaches> reaches = this->reaches();
    Json json = contextOf(machine, criterion_);
    json["over"] = region_.given() ? "region" : "set";
    json["serial"] = Json::array();
    for (const SingularityAnswer& leg : found.serial)
      json["serial"].push_back(toJson(leg));
    json["parallel"] = toJson(found.parallel);
    json["seconds"] = found.seconds;
    const std::string message = describe(found, machine, query.budget);
    const std::string remark = remarkOnLimits(machine, criterion_, reaches);
    addLimits(machine, criterion_, reaches, json);
    json["message"] = withRemark(message, remark);
    return { json, print(found, message) + wrapped(remark) };
  }

private:
  /// How far the rails go for the points that count, where limits are left aside.
  std::optional<JointReaches> reaches() const
  {
    const Machine& machine = machine_.machine();
    return region_.given() ? reachOver(machine, criterion_, *region_.shape(), region_.center(), region_.size())
                           : reachOver(machine, criterion_);
  }

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
           (region_.given() ? "in the " + region_.shape()->name() : "at all points that the struts reach") +
           (criterion_.joint_limits ? " within the joint limits" : "") + "\n\n" + aligned(rows, Align::LEFT) + "\n" +
           wrapped(definition(machine, criterion_)) + wrapped(message + " " + seconds(found.seconds) + ".");
  }

  MachineOptions machine_;
  RegionOption region_;
  SingularityQuery query_;
  Criterion criterion_ = reachableAnywhere();
  bool progress_ = false;
};
}  // namespace

std::unique_ptr<Command> makeSingularities()
{
  return std::make_unique<FindThem>();
}
}  // namespace cli
}  // namespace pkm_workspace
