// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "command.h"
#include "common_options.h"
#include "comparison.h"
#include "paper_tables.h"
#include "pkm_workspace/machine/catalogue.h"
#include "pkm_workspace/report/largest_sentence.h"
#include "progress.h"
#include "shape_options.h"

namespace pkm_workspace
{
namespace cli
{
namespace
{
Json jsonOf(const Singularities& found)
{
  return { { "serial", toJson(least(found.serial)) }, { "parallel", toJson(found.parallel) } };
}

Json jsonOf(const Comparison& study)
{
  const bool found = study.region.size > 0.0;
  Json json = contextOf(study.machine, study.query.criterion);
  json["shape"] = study.region.shape->name();
  json["accuracy"] = study.query.accuracy;
  json["center"] = found ? toJson(study.region.center) : Json();
  json["size"] = study.region.size;
  json["size_upper_bound"] = study.region.size_upper_bound;
  json["status"] = name(study.region.status);
  json["message"] = endingOf(study.region, study.machine, study.query.criterion);
  if (isSolid(*study.region.shape))
  {
    json["volume"] = study.region.volume;
    json["volume_upper_bound"] = study.region.volume_upper_bound;
  }
  json["joint_ranges"] = Json::array();
  json["figures"] = Json::object();
  json["scaled"] = Json::object();
  for (std::size_t i = 0; found && i < 3; ++i)
    json["joint_ranges"].push_back({ { "joint", study.machine.leg(static_cast<int>(i)).joint },
                                     { "lower", study.ranges.outer[i].lower() },
                                     { "upper", study.ranges.outer[i].upper() },
                                     { "inner", toJson(study.ranges.inner[i]) } });
  if (found)
    addLimits(study.machine, study.query.criterion, reachOver(study.region), json);
  for (const Figure& figure : figuresOf(study))
  {
    json["figures"][figure.key] = toJson(figure.value);
    json["scaled"][figure.key] = toJson(figure.scaled(study.region.size));
  }
  if (found)
    json["singularities"] = { { "region", jsonOf(study.in_region) }, { "joint_ranges", jsonOf(study.in_ranges) } };
  return json;
}

Json jsonOf(const PaperRow& row)
{
  return { { "place", row.place },
           { "what", row.what },
           { "paper", row.paper },
           { "ours", row.ours },
           { "bracket", toJson(row.bracket) },
           { "holds", row.holds ? Json(*row.holds) : Json() } };
}

/// Lines of one quantity for each machine, so that what is compared stands together. Of a machine without a region
/// there is one, which says why.
std::string table(const std::vector<Comparison>& studies)
{
  std::vector<Words> rows = { { "quantity", "machine", "value", "scaled to size 1" } };
  std::vector<std::vector<Figure>> figures;
  std::size_t count = 1;
  for (const Comparison& study : studies)
  {
    figures.push_back(figuresOf(study));
    count = std::max(count, figures.back().size());
  }
  for (std::size_t k = 0; k < count; ++k)
    for (std::size_t m = 0; m < studies.size(); ++m)
      if (k < figures[m].size())
        rows.push_back({ figures[m][k].label, studies[m].machine.name(), describe(figures[m][k].value),
                         describe(figures[m][k].scaled(studies[m].region.size)) });
      else if (k == 0)
        rows.push_back({ sizeOf(*studies[m].region.shape), studies[m].machine.name(), "none",
                         "(" + studies[m].region.message + ")" });
  return aligned(rows, Align::LEFT);
}

std::string singularities(const std::vector<Comparison>& studies)
{
  std::vector<Words> rows = { { "singularities", "machine", "serial", "parallel" } };
  for (const Comparison& study : studies)
  {
    const std::string name = study.machine.name();
    if (study.region.size > 0.0)
    {
      rows.push_back(
          { "in the region", name, verdictOn(least(study.in_region.serial)), verdictOn(study.in_region.parallel) });
      rows.push_back({ "within the strokes", name, verdictOn(least(study.in_ranges.serial)),
                       verdictOn(study.in_ranges.parallel) });
    }
    else
      rows.push_back({ "in the region", name, "no region", "" });
  }
  return aligned(rows, Align::LEFT);
}

class Compare : public Command
{
public:
  std::string description() const override
  {
    return "Compares machines by the largest region of a shape in which every point is dextrous, as the paper does: "
           "its size, what the joints have to travel for it, the volume that can be reached with these strokes in the "
           "region's aspect, and "
           "the singularities in both; every number as a proved bracket, also scaled to a region of size 1. The "
           "strokes are equal: each begins at the least value of its own joint and has the largest length of the "
           "three. With --paper, the figures of the paper beside ours.";
  }

  Words examples() const override
  {
    return { "pkm compare --urdf orthoglide.urdf --urdf uranesx.urdf",
             "pkm compare --urdf orthoglide.urdf --urdf uranesx.urdf --shape square --json", "pkm compare --paper" };
  }

  void declare(Options& options) override
  {
    machines_.declare(options);
    machines_.declareTolerances(options);
    options.flag("paper", paper_, "compares with tables 1 to 4 of the paper, in place of --urdf");
    shape_.declare(options, query_);
    declareCriterion(options, query_.criterion);
    accuracy_.declare(options, "largest difference between the proved size and its upper bound");
    options.flag("multi-precision", multi_precision_, MULTI_PRECISION_HELP);
    declareBudget(options, query_.budget);
    options.flag("progress", progress_, PROGRESS_HELP);
    options.check({ "urdf", "paper" }, [this](Problems& problems) {
      if (paper_ != (machines_.count() == 0))
        problems.push_back("give either --urdf FILE, once for each machine, or --paper");
    });
    options.check({ "paper" }, [this, &options](Problems& problems) {
      Words fixed = criterionOptions();
      fixed.insert(fixed.end(),
                   { "shape", "proportions", "ratio", "radius", "height", "footprint", "vertices", "multi-precision" });
      for (const std::string& name : fixed)
        if (paper_ && options.given(name))
          problems.push_back("with --paper, all of this is as in the paper: leave out --" + name);
    });
  }

  Words warnings() const override { return machines_.warnings(); }

  Answer answer() override
  {
    query_.precision = multi_precision_ ? Precision::MULTIPLE : Precision::DOUBLE;
    query_.budget.stop = caller().stop();
    Progress progress = caller().progress(progress_);
    const Tell tell = [&](const std::string& text) { progress.tell(text); };
    return paper_ ? answerPaper(tell) : answerMachines(tell);
  }

private:
  Answer answerMachines(const Tell& tell)
  {
    query_.budget = query_.budget.inTurns(static_cast<double>(machines_.count()));
    std::vector<Comparison> studies;
    Json json = { { "machines", Json::array() } };
    std::string regions;
    for (const UrdfMachine& urdf : machines_.machines())
    {
      query_.accuracy = accuracy_.valueFor(urdf.machine, *query_.shape);
      studies.push_back(comparisonOf(urdf.machine, query_, VOLUME_ACCURACY, tell));
      json["machines"].push_back(jsonOf(studies.back()));
      regions +=
          wrapped("Largest " + studies.back().region.shape->name() + " of machine '" + urdf.machine.name() + "': " +
                  withRemark(studies.back().region.message + ".",
                             remarkOnLimits(urdf.machine, query_.criterion, reachOver(studies.back().region))));
    }
    return { json, regions + "\n" + table(studies) + "\n" + singularities(studies) + "\n" +
                       wrapped("The strokes are equalised: each begins at the least value of its own joint over the "
                               "region and has the largest length of the three. Singularities within the strokes are "
                               "looked for in both aspects.") +
                       definitions() };
  }

  /// Of each machine, which mostly is the same.
  std::string definitions() const
  {
    Words all;
    for (const UrdfMachine& urdf : machines_.machines())
      if (const std::string one = wrapped(definition(urdf.machine, query_.criterion)); all.empty() || all.back() != one)
        all.push_back(one);
    return joined(all, "");
  }

  Answer answerPaper(const Tell& tell)
  {
    const Criterion criterion;  // the paper's
    Json json = toJson(criterion);
    json["rows"] = Json::array();
    std::vector<Words> lines = { { "place", "what", "paper", "ours", "the paper's" } };
    for (const PaperRow& row : paperRows(accuracy_.valueFor(orthoglide(), *query_.shape), query_.budget, tell))
    {
      json["rows"].push_back(jsonOf(row));
      lines.push_back({ row.place, row.what, row.paper, row.ours, row.holds ? *row.holds ? "holds" : "fails" : "-" });
    }
    return { json, aligned(lines, Align::LEFT) + "\n" +
                       wrapped("A figure of the paper holds when it differs from ours by no more than one unit of the "
                               "last digit that is printed. Strokes, volumes and ratios are those of our largest "
                               "regions. Joint limits are off, as in the paper.") +
                       wrapped(definition(orthoglide(), criterion)) };
  }

  MachinesOptions machines_;
  bool paper_ = false;
  bool multi_precision_ = false;
  bool progress_ = false;
  RegionQuery query_;
  ShapeOptions shape_;
  AccuracyOption accuracy_;
};
}  // namespace

std::unique_ptr<Command> makeCompare()
{
  return std::make_unique<Compare>();
}
}  // namespace cli
}  // namespace pkm_workspace
