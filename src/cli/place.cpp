// SPDX-License-Identifier: BSD-3-Clause
#include "command.h"
#include "common_options.h"
#include "output.h"
#include "path_source.h"
#include "pkm_workspace/import/vertices_file.h"
#include "pkm_workspace/interval/decimal.h"
#include "pkm_workspace/tasks/placement.h"
#include "progress.h"

namespace pkm_workspace
{
namespace cli
{
namespace
{
Json scaleJson(const LargestScale& largest)
{
  return { { "least", largest.least },
           { "scale", largest.scale },
           { "upper_bound", largest.upper_bound },
           { "translation", largest.scale > 0.0 ? toJson(largest.translation) : Json() },
           { "status", name(largest.search.status) },
           { "boxes", largest.search.boxes },
           { "verification_boxes", largest.search.verification_boxes },
           { "seconds", largest.search.seconds } };
}

std::string effortOf(const LargestRegion& search)
{
  return std::to_string(search.boxes) + " boxes of translations, " + seconds(search.seconds);
}

/// Of all joints; null where there is none.
Json limitsJson(const std::array<double, 3>& limits)
{
  return Json::array({ finite(limits[0]), finite(limits[1]), finite(limits[2]) });
}

class Place : public Command
{
public:
  std::string description() const override
  {
    return "Finds where to put a job: the translation with which every point of a path, of a job in G-code or of a "
           "solid "
           "part is dextrous with the largest margin, by which it may be off along each axis. An upper bound of the "
           "margins of all translations is proved, too, or that there is no such translation. Joint speeds at the "
           "feeds of a "
           "job, or at --tool-speed, count as pkm path has them. With --largest-scale also how much larger the path "
           "or the part may be. Nothing is turned. The translation adds to --origin. A path is written in lines: " +
           std::string(PATH_GRAMMAR) + ". Ctrl-C ends the search with the best proved so far.";
  }

  Words examples() const override
  {
    return { "pkm place --urdf delta.urdf --gcode part.gcode --base-z 0",
             "pkm place --urdf orthoglide.urdf --segment 'start 0 0 0' --segment 'line 0.4 0.2 0' --largest-scale",
             "pkm place --urdf orthoglide.urdf --vertices part.stl --within -0.2 0.2 -0.2 0.2 0 0.1 --json" };
  }

  void declare(Options& options) override
  {
    machine_.declare(options);
    source_.declare(options, { "vertices" });
    options.words("vertices", "FILE",
                  "in place of a path, a solid part: an STL, or lines of X Y Z [m]; all points of their convex hull",
                  [this](const Words& words) {
                    task_.vertices = readVertices(words[0]);
                    task_.part = "--vertices " + words[0] + ": the part";
                  });
    source_.declareRates(options, task_.rates, false);
    options.box("within", task_.query.translations, "translations that may be chosen; without it, any");
    options.number("base-z", task_.base_z, LENGTH, "height that the lowest point comes to lie at");
    options.flag(
        "largest-scale", task_.query.wants_scale,
        "find the largest scale, too, up to which all points of the path or part are dextrous at every scale in "
        "one place; feeds do not count. It takes up to --time-limit once more");
    options.vector("reference", task_.reference, "X Y Z", LENGTH,
                   "point about which it is scaled; without it the middle of the bounds of a path, with --base-z "
                   "of their lowest face, and the mean of the vertices of a part, with --base-z of the lowest ones");
    options.number(
        "accuracy", accuracy_, LENGTH_POSITIVE,
        "largest difference between the margin and its upper bound; without it, 1e-4 of the longest strut, to one "
        "digit");
    options.number("scale-accuracy", task_.query.scale_accuracy, NUMBER_POSITIVE, "the same of the largest scale");
    declareCriterion(options, task_.query.criterion, machine_);
    declareBudget(options, task_.query.budget);
    options.flag("progress", progress_, PROGRESS_HELP);
    options.check({ "largest-scale", "reference", "scale-accuracy" }, [this, &options](Problems& problems) {
      for (const char* const name : { "reference", "scale-accuracy" })
        if (options.given(name) && !task_.query.wants_scale)
          problems.push_back("--" + std::string(name) + " is without effect: it is about --largest-scale");
    });
    options.check({ "vertices" }, [&options](Problems& problems) {
      for (const char* const name : { "tool-speed", "joint-speeds-off", "joint-acceleration-max" })
        if (options.given(name) && options.given("vertices"))
          problems.push_back("--" + std::string(name) + " is without effect: a part of --vertices has no speed");
    });
  }

  Words warnings() const override { return machine_.warnings(); }
  Words notes() const override { return machine_.notes(); }
  Remedy remedy() const override { return { "--joint-limits on", "--within, translations within 1000 struts" }; }

  Answer answer() override
  {
    const Machine& machine = machine_.machine();
    Progress progress = caller().progress(progress_);
    PathTask path;
    task_.query.budget.stop = caller().stop();
    const RunningBudget reading(task_.query.budget);
    if (source_.job().isGiven())
      source_.job().describeTo(path, progress,
                               { [&reading] { return reading.isOver(); }, [&reading] { return reading.endedBy(0); } });
    else if (source_.isGiven())
      path.for_each = [this](const auto& use) { source_.text().handOver(use); };
    task_.for_each = path.for_each;
    task_.query.accuracy = accuracy_.value_or(0.1 * defaultAccuracy(machine));
    task_.query.progress = [&progress](const RegionProgress& state) {
      progress.tell("margin [m], or growth of the scale " + bracket(state.size, state.size_upper_bound) + ", " +
                    std::to_string(state.boxes_done) + " boxes done, " + std::to_string(state.boxes_open) + " open");
    };
    PlacementReport report = place(machine, task_);
    if (source_.job().isGiven())
      report.message = withRemark(report.message, source_.job().remark());
    return { toJson(report), print(report) };
  }

private:
  Json toJson(const PlacementReport& report) const
  {
    const LargestRegion& found = report.placement.found;
    Json json = contextOf(machine_.machine(), report.query.criterion);
    json["status"] = name(found.status);
    json["accuracy"] = report.query.accuracy;
    json["translation"] = found.size > 0.0 ? cli::toJson(found.center) : Json();
    json["margin"] = found.size;
    json["margin_upper_bound"] = found.size_upper_bound;
    json["translations"] =
        report.placement.translations.isValid() ? cli::toJson(report.placement.translations) : Json();
    json["holds_limits"] = report.query.limits.any();
    json["joint_speed_limits"] = limitsJson(report.query.limits.speed);
    json["joint_acceleration_limits"] = limitsJson(report.query.limits.acceleration);
    json["tool_speed"] = task_.rates.tool_speed ? Json(*task_.rates.tool_speed) : Json();
    json["reference"] = cli::toJson(report.query.workpiece->reference);
    json["largest_scale"] = report.placement.largest ? scaleJson(*report.placement.largest) : Json();
    json["boxes"] = found.boxes;
    json["verification_boxes"] = found.verification_boxes;
    json["seconds"] = found.seconds;
    if (source_.job().isGiven())
      source_.job().addTo(json);
    json["message"] = report.message;
    return json;
  }

  std::string print(const PlacementReport& report) const
  {
    const LargestRegion& found = report.placement.found;
    const Machine& machine = machine_.machine();
    const int decimals = decimalsFor(found.size, found.size_upper_bound);
    std::vector<Words> rows = { { "status", name(found.status) } };
    if (found.size > 0.0)
      rows.push_back({ "translation", pkm_workspace::cli::describe(found.center) });
    if (source_.job().isGiven())
      source_.job().addRows(rows);
    rows.push_back({ "margin [m]", roundedDown(found.size, decimals) });
    rows.push_back({ "upper bound", roundedUp(found.size_upper_bound, decimals) });
    rows.push_back({ "effort", effortOf(found) });
    if (const auto& largest = report.placement.largest)
    {
      rows.push_back(
          { "largest scale", bracket(largest->scale, largest->upper_bound) + ", " + name(largest->search.status) });
      rows.push_back({ "its effort", effortOf(largest->search) });
    }
    return "Placement for machine '" + machine.name() + "'\n\n" + aligned(rows, Align::LEFT) + "\n" +
           wrapped(report.message) + wrapped(definition(machine, report.query.criterion));
  }

  MachineOptions machine_;
  PathSource source_;
  PlacementTask task_;
  std::optional<double> accuracy_;
  bool progress_ = false;
};
}  // namespace

std::unique_ptr<Command> makePlace()
{
  return std::make_unique<Place>();
}
}  // namespace cli
}  // namespace pkm_workspace
