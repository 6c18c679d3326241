// SPDX-License-Identifier: BSD-3-Clause
#include "command.h"
#include "common_options.h"
#include "output.h"
#include "pkm_workspace/interval/decimal.h"
#include "pkm_workspace/report/tolerate_sentence.h"
#include "progress.h"
#include "region_option.h"

namespace pkm_workspace
{
namespace cli
{
namespace
{
/// Columns of a whole bar.
constexpr double BAR = 30.0;

class Tolerate : public Command
{
public:
  std::string description() const override
  {
    return "Tells how exactly a machine has to be built for a region: by how much its tolerances may be multiplied so "
           "that every point is still good on every machine within them, as a bracket; and which tolerance of which "
           "leg takes how much where the region fails first.";
  }

  Words examples() const override
  {
    return {
      "pkm tolerate --urdf orthoglide.urdf --center 0.08 0.08 0.08 --sides 0.6 0.6 0.6 "
      "--tolerance-length 1e-4 --tolerance-slider 1e-4"
    };
  }

  void declare(Options& options) override
  {
    machine_.declare(options);
    options.vector("center", center_, "X Y Z", LENGTH, "center of the region, in the frame of the root link");
    body_.declare(options);
    declareCriterion(options, query_.criterion, machine_);
    options.number("accuracy", query_.accuracy, Quantity{ "", 1e-9, true, 1.0 }, "wanted ratio of the bounds, less 1");
    declareBudget(options, query_.budget);
    options.flag("progress", progress_, PROGRESS_HELP);
    options.require({ "center" });
    options.check({ "size", "sides", "radius", "height" }, [this, &options](Problems& problems) {
      if (!body_.given() && !options.given("shape"))
        problems.push_back("give the region: --sides A B C, --radius R, --radius R --height H, or --shape and --size");
    });
    Words names = toleranceOptions();
    names.push_back("urdf");
    options.check(names, [this](Problems& problems) {
      if (!machine_.machine().hasTolerances())
        problems.push_back("give one tolerance at least, such as --tolerance-length 1e-4: they are multiplied");
    });
  }

  Words warnings() const override { return machine_.warnings(); }
  Words notes() const override { return machine_.notes(); }

  Answer answer() override
  {
    query_.budget.stop = caller().stop();
    query_.solid = body_.solid();
    query_.center = *center_;
    Progress progress = caller().progress(progress_);
    query_.tell = [&progress](double holds, double fails) {
      progress.tell("holds " + significantBelow(holds, 6) + " times" +
                    (std::isfinite(fails) ? ", fails " + significantAbove(fails, 6) + " times" : ""));
    };
    const Machine& machine = machine_.machine();
    const TolerableFactor found = tolerableFactor(machine, query_);
    return { jsonOf(found), print(found) };
  }

private:
  Json jsonOf(const TolerableFactor& found) const
  {
    const Machine& machine = machine_.machine();
    Json json = contextOf(machine, query_.criterion);
    json["center"] = toJson(query_.center);
    json["shape"] = query_.solid.shape->name();
    json["dimensions"] = query_.solid.shape->dimensions(query_.solid.size);
    json["holds"] = found.holds;
    json["fails"] = finite(found.fails);
    json["closed"] = found.is_closed;
    json["bad_point"] = found.bad_point ? toJson(*found.bad_point) : Json();
    json["bad_machine"] = found.bad_machine ? differencesJson(*found.bad_machine, machine) : Json();
    json["shares"] = Json::array();
    for (const ToleranceShare& share : found.shares)
      json["shares"].push_back(
          { { "tolerance", share.kind->name }, { "joint", machine.leg(share.leg).joint }, { "share", share.share } });
    json["boxes"] = found.boxes;
    json["seconds"] = found.seconds;
    json["message"] = pkm_workspace::describe(found, machine, query_);
    return json;
  }

  std::string print(const TolerableFactor& found) const
  {
    const Machine& machine = machine_.machine();
    std::vector<Words> rows = { { "holds", significantBelow(found.holds, 6) + " times the tolerances" },
                                { "fails", std::isfinite(found.fails)
                                               ? significantAbove(found.fails, 6) + " times the tolerances"
                                               : "not proved" },
                                { "effort", std::to_string(found.boxes) + " boxes, " + seconds(found.seconds) } };
    std::string text = "Machine '" + machine.name() + "', " + query_.solid.shape->name() + " with center " +
                       pkm_workspace::cli::describe(query_.center) + "\n\n" + aligned(rows, Align::LEFT) + "\n";
    std::vector<Words> shares = { { "tolerance", "joint", "share", "" } };
    for (const ToleranceShare& share : found.shares)
      shares.push_back({ share.kind->name, machine.leg(share.leg).joint, nearly(100.0 * share.share, 3) + " %",
                         std::string(static_cast<std::size_t>(std::max(1.0, BAR * share.share)), '#') });
    if (!found.shares.empty())
      text += aligned(shares, Align::LEFT) + "\n";
    text += wrapped(pkm_workspace::describe(found, machine, query_));
    if (found.bad_machine)
      for (const std::string& leg : differencesInWords(*found.bad_machine, machine))
        text += wrapped("  " + leg);
    return text + wrapped(definition(machine, query_.criterion));
  }

  MachineOptions machine_;
  BodyOption body_;
  std::optional<Eigen::Vector3d> center_;
  FactorQuery query_;
  bool progress_ = false;
};
}  // namespace

std::unique_ptr<Command> makeTolerate()
{
  return std::make_unique<Tolerate>();
}
}  // namespace cli
}  // namespace pkm_workspace
