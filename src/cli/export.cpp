// SPDX-License-Identifier: BSD-3-Clause
#include "command.h"
#include "common_options.h"
#include "output.h"
#include "pkm_workspace/interval/decimal.h"
#include "pkm_workspace/tasks/limits_export.h"
#include "progress.h"
#include "region_option.h"

namespace pkm_workspace
{
namespace cli
{
namespace
{
class Export : public Command
{
public:
  std::string description() const override
  {
    return "Writes a region, once it is proved that every point of it is dextrous, as limits for the configuration of "
           "a controller: klipper, marlin and reprapfirmware hold a cylinder about the z axis (--radius, --height), "
           "linuxcnc a box (--sides). Limits are rounded inward to the micrometre. What a firmware cannot hold is "
           "refused. With --json: format, values [mm], text.";
  }

  Words examples() const override
  {
    return {
      "pkm export --urdf delta.urdf --psi auto --joint-limits off --center 0 0 0.15 --radius 0.08 --height 0.3 "
      "--format klipper",
      "pkm export --urdf delta.urdf --psi auto --center 0 0 0.1 --sides 0.1 0.1 0.1 --format linuxcnc --output "
      "limits.ini"
    };
  }

  void declare(Options& options) override
  {
    machine_.declare(options);
    options.choice("format", task_.format, limitFormats(), "whose words the limits are written in");
    options.vector("center", center_, "X Y Z", LENGTH, "center of the region, in the frame of the root link");
    body_.declare(options);
    options.words("origin", "X Y Z",
                  "where the controller's zero is, in the frame of the root link [m]; 0 0 0 without it, as pkm import "
                  "has it. The limits are seen from there",
                  [this](const Words& words) {
                    const auto numbers = readNumbers(words, LENGTH);
                    task_.origin = { numbers[0], numbers[1], numbers[2] };
                  });
    options.flag("top-by-slicer", task_.top_by_slicer,
                 "writes the radius and the lower end of a cylinder that ends below where the switches are, although "
                 "nothing but the build height of the slicer keeps the tool below its top");
    declareCriterion(options, criterion_, machine_);
    declareTimeLimit(options, task_.budget.time_limit);
    declareOutput(options, "output", output_, "file to write; without it, standard output");
    options.require({ "format", "center" });
    options.check({ "format", "center", "origin", "size", "sides", "radius", "height" },
                  [this](Problems& problems) { checkBody(problems); });
    options.check({ "urdf", "format", "center", "origin", "size", "sides", "radius", "height", "rails", "tcp-links",
                    "tool-link", "tool", "ball-axes" },
                  [this](Problems& problems) {
                    if (body_.given())
                      task_.validateMachine(machine_.machine(), problems);
                  });
  }

  Words warnings() const override { return machine_.warnings(); }
  Words notes() const override { return machine_.notes(); }

  Answer answer() override
  {
    const Progress progress = caller().progress(false);
    task_.budget.stop = caller().stop();
    task_.budget.max_boxes = DEFAULT_CHECK_BOXES;
    const FirmwareLimits limits = exportLimits(PointEvaluator(machine_.machine(), criterion_), task_).limits;
    Json json = contextOf(machine_.machine(), criterion_);
    json["format"] = task_.format;
    json["values"] = Json::object();
    for (const auto& value : limits.values)
      json["values"][value.first] = *parseNumber(value.second);
    json["text"] = limits.text;
    if (output_.empty())
      return { json, limits.text };
    writeOutput(output_, limits.text);
    json["output"] = output_;
    return { json, "Wrote limits for " + task_.format + " to " + output_ + "\n" };
  }

private:
  void checkBody(Problems& problems)
  {
    task_.region = { body_.solid(), *center_ };
    if (!body_.given())
      problems.push_back("give the region: " + task_.remedies.cylinder + ", or " + task_.remedies.box);
    else
      task_.validateBody(problems);
  }

  MachineOptions machine_;
  ExportTask task_ = { {},
                       {},
                       Eigen::Vector3d::Zero(),
                       false,
                       {},
                       { "--radius R --height H", "a --center above the --origin", "--sides A B C",
                         "--joint-limits off", "--top-by-slicer", "--origin X Y Z" } };
  BodyOption body_;
  std::optional<Eigen::Vector3d> center_;
  Criterion criterion_;
  std::string output_;
};
}  // namespace

std::unique_ptr<Command> makeExport()
{
  return std::make_unique<Export>();
}
}  // namespace cli
}  // namespace pkm_workspace
