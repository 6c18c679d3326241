// SPDX-License-Identifier: BSD-3-Clause
#include <stdexcept>

#include "command.h"
#include "common_options.h"
#include "output.h"
#include "pkm_workspace/dexterity/region_check.h"
#include "pkm_workspace/import/firmware_limits.h"
#include "pkm_workspace/interval/decimal.h"
#include "pkm_workspace/region/containment.h"
#include "pkm_workspace/report/containment_sentence.h"
#include "progress.h"
#include "region_option.h"

namespace pkm_workspace
{
namespace cli
{
namespace
{
/// What pkm import leaves off a switch when it rounds it, and some more [m].
constexpr double SWITCH_SLACK = 3e-6;

/// Whether the z axis lies within the triangle of the rails, seen from the tool.
bool isAxisBetweenRails(const Machine& machine)
{
  int sum = 0;
  for (int i = 0; i < 3; ++i)
  {
    const IntervalVector& one = machine.center(i);
    const IntervalVector& next = machine.center((i + 1) % 3);
    const Interval turn = one[0] * next[1] - one[1] * next[0];
    sum += turn.certainlyPositive() ? 1 : turn.certainlyNegative() ? -1 : 0;
  }
  return sum == 3 || sum == -3;
}

/// No carriage lets the tool get above this: at any place some rail is no further away than at the z axis, so that the
/// carriage stands at least as far above the tool [m]. @pre the rails stand along z, with that axis between them
double ceilingOf(const Machine& machine)
{
  const auto level = configurationAt(machine, Eigen::Vector3d::Zero());
  double ceiling = level ? -INF : INF;
  for (int i = 0; level && i < 3; ++i)
  {
    const Interval top =
        Interval(machine.leg(i).limits.upper()) - level->rho[static_cast<std::size_t>(i)] + Interval(SWITCH_SLACK);
    ceiling = std::max(ceiling, top.upper());
  }
  return ceiling;
}

/// And hangs the strut below its carriage, as the deltas of firmwares do.
bool standsAlongZ(const Leg& leg)
{
  const auto* const strut = std::get_if<SlidingStrut>(&leg.kind);
  const auto is = [](const Interval& x, double value) { return x.lower() == value && x.upper() == value; };
  return strut != nullptr && strut->working_mode == -1 && is(strut->axis[0], 0.0) && is(strut->axis[1], 0.0) &&
         is(strut->axis[2], 1.0);
}

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
    options.choice("format", format_, limitFormats(), "whose words the limits are written in");
    options.vector("center", center_, "X Y Z", LENGTH, "center of the region, in the frame of the root link");
    body_.declare(options);
    options.flag("top-by-slicer", top_by_slicer_,
                 "writes the radius and the lower end of a cylinder that ends below where the switches are, although "
                 "nothing but the build height of the slicer keeps the tool below its top");
    declareCriterion(options, criterion_, machine_);
    declareTimeLimit(options, budget_.time_limit);
    declareOutput(options, "output", output_, "file to write; without it, standard output");
    options.require({ "format", "center" });
    options.check({ "format", "center", "size", "sides", "radius", "height" },
                  [this](Problems& problems) { checkBody(problems); });
    options.check({ "urdf", "format", "center", "size", "sides", "radius", "height", "rails", "tcp-links", "tool-link",
                    "tool", "ball-axes" },
                  [this](Problems& problems) { checkMachine(problems); });
  }

  Words warnings() const override { return machine_.warnings(); }
  Words notes() const override { return machine_.notes(); }

  Answer answer() override
  {
    prove();
    const FirmwareLimits limits = writeLimits(format_, region(), comments());
    Json json = contextOf(machine_.machine(), criterion_);
    json["format"] = format_;
    json["values"] = Json::object();
    for (const auto& value : limits.values)
      json["values"][value.first] = *parseNumber(value.second);
    json["text"] = limits.text;
    if (output_.empty())
      return { json, limits.text };
    writeOutput(output_, limits.text);
    json["output"] = output_;
    return { json, "Wrote limits for " + format_ + " to " + output_ + "\n" };
  }

private:
  bool isCylinder() const { return body_.solid().shape->kind() == "cylinder"; }
  const std::vector<double> measures() const { return body_.solid().shape->dimensions(body_.solid().size); }

  void checkBody(Problems& problems) const
  {
    if (!body_.given())
      problems.push_back("give the region: --radius R --height H, or --sides A B C");
    else if (holdsCylinders(format_) && !isCylinder())
      problems.push_back(format_ + " limits the distance from the z axis and the height: a " +
                         body_.solid().shape->kind() + " cannot be held; give a cylinder, --radius R --height H");
    else if (holdsCylinders(format_) && (center_->x() != 0.0 || center_->y() != 0.0))
      problems.push_back(format_ +
                         " limits the distance from the z axis: a cylinder about another axis cannot be "
                         "held; give --center 0 0 Z");
    else if (!holdsCylinders(format_) && (!body_.solid().shape->isBox() || measures().size() != 3))
      problems.push_back(format_ + " limits each coordinate: a " + body_.solid().shape->kind() +
                         " cannot be held; give a box, --sides A B C");
  }

  void checkMachine(Problems& problems) const
  {
    const Machine& machine = machine_.machine();
    if (!body_.given() || !holdsCylinders(format_))
      return;
    for (const Leg& leg : machine.legs())
      if (!standsAlongZ(leg))
        problems.push_back("joint '" + leg.joint +
                           "' is not along z with its carriage above the tool: the coordinates of " + format_ +
                           " are those of such rails, so its limits mean another region");
    if (!isAxisBetweenRails(machine))
      problems.push_back("the z axis is not between the rails: " + format_ + " limits the distance from it");
    const double ceiling = ceilingOf(machine);
    if (problems.empty() && !top_by_slicer_ && !(region().box.upper.z() > ceiling))
      problems.push_back(
          format_ + " has no limit for the upper end of a delta but its switches, which let the tool up to z = " +
          roundedUp(ceiling, 6) + " m, and the region ends at z = " + roundedDown(region().box.upper.z(), 6) +
          " m; give a region that ends above (with --joint-limits off: the switches hold those limits), or "
          "--top-by-slicer");
  }

  /// What is proved, rounded inward.
  HeldRegion region() const
  {
    const CenteredSolid solid = centeredSolid(*body_.solid().shape, *center_, body_.solid().size);
    HeldRegion region;
    if (isCylinder())
      region.radius = solid.dimensions[1];
    for (int axis = isCylinder() ? 2 : 0; axis < 3; ++axis)
    {
      const Interval half =
          Interval(0.5) * Interval(solid.dimensions[isCylinder() ? 0 : static_cast<std::size_t>(axis)]);
      region.box.lower[axis] = (Interval(solid.center[axis]) - half).upper();
      region.box.upper[axis] = (Interval(solid.center[axis]) + half).lower();
    }
    return region;
  }

  /// @throws std::invalid_argument where the region is not proved
  void prove()
  {
    const Progress progress(false);
    budget_.stop = stopOnSignal();
    budget_.max_boxes = DEFAULT_CHECK_BOXES;
    const Solid& solid = body_.solid();
    const BoxTest test(machine_.machine(), criterion_);
    const ContainmentResult result = checkContainment(test, *solid.shape, *center_, solid.size, budget_);
    message_ = pkm_workspace::describe(result, PointEvaluator(machine_.machine(), criterion_), *solid.shape, *center_,
                                       solid.size, budget_);
    if (result.verdict != Containment::INSIDE)
      throw std::invalid_argument("nothing is written, as the region is " + std::string(name(result.verdict)) + ": " +
                                  message_);
  }

  Words comments() const
  {
    const Machine& machine = machine_.machine();
    const Json context = contextOf(machine, criterion_);
    const HeldRegion held = region();
    const std::string z = exact(held.box.lower.z()) + " to " + exact(held.box.upper.z()) + " m";
    Words lines = { "Limits by pkm_workspace " + context["version"].get<std::string>() + ", rounded inward.",
                    "Machine '" + machine.name() + "', geometry " + machine.geometryHash() + "." };
    lines.push_back("Region: " +
                    (held.radius ? "cylinder about the z axis, radius " + exact(*held.radius) + " m, z " + z
                                 : "box from " + describe(held.box.lower) + " to " + describe(held.box.upper)) +
                    ".");
    lines.push_back(message_);
    lines.push_back(definition(machine, criterion_));
    lines.push_back(
        "It holds for the machine that the URDF describes, in the frame of its root link, with the tool offset, bed "
        "levelling and "
        "homing of the controller as they were when its numbers were taken.");
    if (holdsCylinders(format_) && !top_by_slicer_)
      lines.push_back("The upper end is held by the switches, which the upper joint limits of the URDF stand for.");
    if (top_by_slicer_)
      lines.push_back("NOT held by the controller: z above " + roundedDown(1000.0 * held.box.upper.z() - 0.001, 3) +
                      " mm. Set the build height of the slicer to that.");
    return lines;
  }

  MachineOptions machine_;
  std::string format_;
  BodyOption body_;
  std::optional<Eigen::Vector3d> center_;
  bool top_by_slicer_ = false;
  Criterion criterion_;
  Budget budget_;
  std::string output_;
  std::string message_;
};
}  // namespace

std::unique_ptr<Command> makeExport()
{
  return std::make_unique<Export>();
}
}  // namespace cli
}  // namespace pkm_workspace
