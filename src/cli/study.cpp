// SPDX-License-Identifier: BSD-3-Clause
#include <stdexcept>

#include "command.h"
#include "common_options.h"
#include "comparison.h"
#include "named_families.h"
#include "pkm_workspace/dexterity/joint_data.h"
#include "pkm_workspace/interval/decimal.h"
#include "pkm_workspace/report/largest_sentence.h"
#include "pkm_workspace/study/best_parameter.h"
#include "progress.h"
#include "shape_options.h"

namespace pkm_workspace
{
namespace cli
{
namespace
{
Json candidatesJson(const std::vector<StudyPart>& candidates)
{
  Json json = Json::array();
  for (const StudyPart& part : candidates)
    json.push_back({ { "lower", part.parameters.lower() },
                     { "upper", part.parameters.upper() },
                     { "size_upper_bound", finite(part.size_upper_bound) } });
  return json;
}

Json partsJson(const std::vector<BestParameter>& parts)
{
  Json json = Json::array();
  for (const BestParameter& part : parts)
    json.push_back({ { "lower", part.range.lower() },
                     { "upper", part.range.upper() },
                     { "parameter", part.region.size > 0.0 ? Json(part.parameter) : Json() },
                     { "size", part.region.size },
                     { "size_upper_bound", finite(part.region.size_upper_bound) } });
  return json;
}

class Study : public Command
{
public:
  std::string description() const override
  {
    return "With a FILE in place of options, it evaluates the designs that the file lists, one row for each "
           "(docs/study.md; pkm study FILE --help). "
           "Finds the machine with the largest region in a family of machines that differ by one parameter: the "
           "UraneSX by R - r or by the paper's lambda, the Delta or the tripod of the catalogue by one of their "
           "dimensions, or all machines on the way from one URDF (share 0) to another "
           "one (share 1). Proved are the region of the best machine found, an upper bound of the regions of all "
           "machines of the range, and outside of which parameters no machine has a larger region. With --parts, also "
           "the bracket of the largest size in each of so many parts of the range. Ctrl-C ends it with what is proved. "
           "With --json: status, parameter (of the best machine), center, dimensions, size, size_upper_bound, "
           "joint_ranges as of pkm largest; candidates: lower, upper and size_upper_bound of the parameters that may "
           "have a larger region; parts: lower, upper, and parameter, size, size_upper_bound in each; boxes, seconds, "
           "message.";
  }

  Words examples() const override
  {
    return { "pkm study --machine uranesx --parameter R-r --range 0.3 0.5 --shape square --accuracy 1e-4",
             "pkm study --machine uranesx --parameter lambda --range 0 0.2 --shape square --parts 20 --json",
             "pkm study --urdf orthoglide.urdf --urdf orthoglide.urdf --range 0 1 --accuracy 0.01" };
  }

  void declare(Options& options) override
  {
    options.choice("machine", machine_, familyMachines(), "a machine of the catalogue, with --parameter");
    options.choice(
        "parameter", parameter_, familyParameters(),
        "of the uranesx: R - r in metres for L = 1 m, or the paper's lambda in metres, R = 7/13 m + lambda; of "
        "the others: one of their dimensions in metres, as pkm urdf has them");
    machines_.declare(options);
    declareTolerances(
        options, [this]() -> ToleranceWish& { return tolerances_; }, "; of every machine of the family");
    options.range("range", range_, Quantity(), "least and largest parameter, in metres; of a share, without unit");
    options.require({ "range" });
    shape_.declareOfSize(options, query_.region);
    declareCriterion(options, query_.region.criterion);
    accuracy_.declare(options, "largest difference between the best machine's proved size and the upper bound of all");
    options.count("parts", parts_, 100000, "parts of the range whose largest sizes are told too; without it, none");
    declareBudget(options, query_.region.budget);
    options.flag("progress", progress_, PROGRESS_HELP);
    declareConditions(options);
  }

  Words warnings() const override { return machines_.warnings(); }

  Answer answer() override
  {
    Progress progress = caller().progress(progress_);
    query_.region.budget.stop = caller().stop();
    if (parts_ > 0)
      query_.region.budget = query_.region.budget.inTurns(2.0);
    query_.progress = [&progress, this](const StudyProgress& state) {
      progress.tell(query_.family.parameter + " " + nearly(state.parameter) + ", size " +
                    describe(Interval(state.size, state.size_upper_bound)) + ", " + std::to_string(state.parts_open) +
                    " parts open");
    };
    const BestParameter best = findBestParameter(query_);
    std::vector<BestParameter> parts;
    if (parts_ > 0)
      parts = bestOfParts(query_, parts_, best);
    return { json(best, parts), print(best, parts) };
  }

private:
  void declareConditions(Options& options)
  {
    options.check({ "machine", "parameter", "urdf" }, [this](Problems& problems) {
      const bool of_catalogue = !machine_.empty() && !parameter_.empty() && machines_.count() == 0;
      const bool between = machine_.empty() && parameter_.empty() && machines_.count() == 2;
      if (!of_catalogue && !between)
        problems.push_back("give either --machine and --parameter, or two machines with --urdf FILE --urdf FILE");
    });
    options.check({ "shape", "ratio" }, [this](Problems& problems) {
      if (query_.region.ratio)
        problems.push_back("a study compares regions of one shape: give a cylinder the same ratio twice");
    });
    Words names = toleranceOptions();
    names.insert(names.end(), { "range", "machine", "parameter", "urdf", "joint-limits" });
    options.check(names, [this](Problems& problems) {
      try
      {
        makeFamily();
      }
      catch (const std::invalid_argument& reason)
      {
        problems.push_back(reason.what());
      }
    });
  }

  /// Also makes the machines at both ends of the range, to refuse what is beyond the family.
  void makeFamily()
  {
    query_.range = Interval(range_->lower, range_->upper);
    const GivenTolerances tolerances = tolerances_.both();
    if (const auto& ends = machines_.machines(); ends.size() == 2)
      query_.family =
          familyBetween(withGivenTolerances(ends[0].machine, tolerances),
                        withGivenTolerances(ends[1].machine, tolerances), query_.region.criterion.joint_limits);
    else if (!parameter_.empty() && !machine_.empty())
      query_.family = withinTolerances(familyNamed(machine_, parameter_), tolerances);
    else
      return;
    const Machine first = query_.family.at(Interval(range_->lower));
    query_.region.criterion = withJointData(first, query_.region.criterion);
    Problems missing;
    requireProvable(first, query_.region.criterion, missing);
    throwProblems(missing);
    query_.region.accuracy = accuracy_.valueFor(first, *query_.region.shape);
    query_.family.at(Interval(range_->upper));
  }

  Machine bestMachine(const BestParameter& best) const { return query_.family.at(Interval(best.parameter)); }

  Json json(const BestParameter& best, const std::vector<BestParameter>& parts) const
  {
    const LargestRegion& region = best.region;
    const bool found = region.size > 0.0;
    const Machine machine = bestMachine(best);
    Json json = contextOf(machine, query_.region.criterion);
    json["family"] = { { "parameter", query_.family.parameter }, { "unit", query_.family.unit } };
    json["range"] = { query_.range.lower(), query_.range.upper() };
    json["shape"] = region.shape->name();
    json["accuracy"] = query_.region.accuracy;
    json["status"] = name(region.status);
    json["parameter"] = found ? Json(best.parameter) : Json();
    json["center"] = found ? toJson(region.center) : Json();
    json["dimensions"] = found ? Json(region.shape->dimensions(region.size)) : Json();
    json["size"] = region.size;
    json["size_upper_bound"] = finite(region.size_upper_bound);
    json["joint_ranges"] = found ? toJson(machine, region.joint_ranges) : Json::array();
    if (found)
      addLimits(machine, query_.region.criterion, reachOver(region), json);
    json["candidates"] = candidatesJson(best.candidates);
    json["parts"] = partsJson(parts);
    json["boxes"] = region.boxes;
    json["seconds"] = region.seconds;
    json["message"] = endingOf(region, machine, query_.region.criterion);
    return json;
  }

  std::string print(const BestParameter& best, const std::vector<BestParameter>& parts) const
  {
    const LargestRegion& region = best.region;
    const Machine machine = bestMachine(best);
    const std::string unit = query_.family.unit.empty() ? "" : " " + query_.family.unit;
    const std::string parameter = query_.family.parameter;
    std::vector<Words> rows = { { "status", name(region.status) + " (" + region.message + ")" } };
    if (region.size > 0.0)
      rows.push_back({ parameter, exact(best.parameter) + unit });
    rows.push_back({ region.shape->sizeMeaning(), describe(Interval(region.size, region.size_upper_bound)) });
    if (region.size > 0.0)
      rows.push_back({ "center", cli::describe(region.center) });
    for (const StudyPart& part : best.candidates)
      rows.push_back(
          { "larger at most at", describe(part.parameters) + unit + ", below " + roundedUp(part.size_upper_bound, 9) });
    rows.push_back({ "effort", std::to_string(region.boxes) + " boxes of centers, " + seconds(region.seconds) });
    return "Largest " + region.shape->name() + " of a machine with " + parameter + " from " +
           exact(query_.range.lower()) + " to " + exact(query_.range.upper()) + unit + "\n\n" +
           aligned(rows, Align::LEFT) + "\n" + table(parts) + wrapped(proof(best)) +
           wrapped(machine.hasTolerances()
                       ? "Here a machine has a region when every machine within its tolerances has it."
                       : "") +
           wrapped(definition(machine, query_.region.criterion)) +
           wrapped(remarkOnLimits(machine, query_.region.criterion, reachOver(region)));
  }

  std::string table(const std::vector<BestParameter>& parts) const
  {
    if (parts.empty())
      return "";
    std::vector<Words> rows = { { query_.family.parameter + " from", "to", "largest at", "size", "upper bound" } };
    for (const BestParameter& part : parts)
    {
      const LargestRegion& region = part.region;
      const int decimals = decimalsFor(region.size, region.size_upper_bound);
      rows.push_back({ exact(part.range.lower()), exact(part.range.upper()),
                       region.size > 0.0 ? nearly(part.parameter, 9) : "-", roundedDown(region.size, decimals),
                       roundedUp(region.size_upper_bound, decimals) });
    }
    return aligned(rows, Align::RIGHT) + "\n";
  }

  std::string proof(const BestParameter& best) const
  {
    const LargestRegion& region = best.region;
    const std::string shape = region.shape->name();
    const int decimals = decimalsFor(region.size, region.size_upper_bound);
    const std::string above = " of a size above " + roundedUp(region.size_upper_bound, decimals);
    if (region.size == 0.0)
      return "Proved: no machine of the range has a " + shape + above + ".";
    const std::string unit = query_.family.unit.empty() ? "" : " " + query_.family.unit;
    Words where;
    for (const StudyPart& part : best.candidates)
      where.push_back("from " + describe(part.parameters) + unit);
    return "Proved: the machine with " + query_.family.parameter + " = " + exact(best.parameter) + unit + " has the " +
           shape + " of size " + roundedDown(region.size, decimals) + " with its center at " +
           cli::describe(region.center) + "; no machine of the range has one" + above + "; and none has a larger one" +
           (where.empty()
                ? "."
                : " than this machine but with " + query_.family.parameter + " " + joined(where, " or ") + ".");
  }

  std::string machine_;
  std::string parameter_;
  MachinesOptions machines_;
  ToleranceWish tolerances_;
  std::optional<RatioRange> range_;
  StudyQuery query_;
  ShapeOptions shape_;
  AccuracyOption accuracy_;
  int parts_ = 0;
  bool progress_ = false;
};
}  // namespace

std::unique_ptr<Command> makeStudy()
{
  return std::make_unique<Study>();
}
}  // namespace cli
}  // namespace pkm_workspace
