// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/tasks/limits_export.h"

#include <algorithm>
#include <stdexcept>

#include "pkm_workspace/dexterity/defaults.h"
#include "pkm_workspace/dexterity/region_check.h"
#include "pkm_workspace/interval/decimal.h"
#include "pkm_workspace/region/containment.h"
#include "pkm_workspace/report/containment_sentence.h"
#include "pkm_workspace/report/definition.h"
#include "pkm_workspace/version.h"

namespace pkm_workspace
{
namespace
{
/// What pkm import leaves off a switch when it rounds it, and some more [m].
constexpr double SWITCH_SLACK = 3e-6;

/// Whether the line along z through a point lies within the triangle of the rails, seen from the tool.
bool isBetweenRails(const Machine& machine, const Eigen::Vector3d& point)
{
  int sum = 0;
  for (int i = 0; i < 3; ++i)
  {
    const IntervalVector one = machine.center(i) - enclose(point);
    const IntervalVector next = machine.center((i + 1) % 3) - enclose(point);
    const Interval turn = one[0] * next[1] - one[1] * next[0];
    sum += turn.certainlyPositive() ? 1 : turn.certainlyNegative() ? -1 : 0;
  }
  return sum == 3 || sum == -3;
}

/// No carriage lets the tool get further above the point than this: at any place some rail is no further away than on
/// the line through the point, so that the carriage stands at least as far above the tool [m].
/// @pre the rails stand along z, with that line between them
double ceilingOver(const Machine& machine, const Eigen::Vector3d& point)
{
  const auto level = configurationAt(machine, point);
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

std::string inMetres(const Eigen::Vector3d& v)
{
  return "(" + exact(v.x()) + ", " + exact(v.y()) + ", " + exact(v.z()) + ") m";
}

std::vector<std::string> comments(const Machine& machine, const Criterion& criterion, const ExportTask& task,
                                  const std::string& proof)
{
  const HeldRegion held = task.held();
  const std::string z = exact(held.box.lower.z()) + " to " + exact(held.box.upper.z()) + " m";
  std::vector<std::string> lines = { std::string("Limits by pkm_workspace ") + version() + ", rounded inward.",
                                     "Machine '" + machine.name() + "', geometry " + machine.geometryHash() + "." };
  lines.push_back("Region: " +
                  (held.radius ? "seen from the controller's zero, cylinder about the z axis, radius " +
                                     exact(*held.radius) + " m, z " + z
                               : "seen from the controller's zero, box from " + inMetres(held.box.lower) + " to " +
                                     inMetres(held.box.upper)) +
                  ".");
  lines.push_back(proof);
  lines.push_back(definition(machine, criterion));
  lines.push_back(
      "The controller's zero is taken to be at " + inMetres(task.origin) +
      " of the frame of the URDF's root link, with axes parallel to those. It holds for the machine that the URDF "
      "describes, with the tool offset, bed levelling and homing of the controller as they were when its numbers were "
      "taken.");
  if (holdsCylinders(task.format) && !task.top_by_slicer)
    lines.push_back("The upper end is held by the switches, which the upper joint limits of the URDF stand for.");
  if (task.top_by_slicer)
    lines.push_back("NOT held by the controller: z above " + roundedDown(1000.0 * held.box.upper.z() - 0.001, 3) +
                    " mm. Set the build height of the slicer to that.");
  return lines;
}
}  // namespace

void ExportTask::validateBody(Problems& problems) const
{
  const Shape& shape = *region.solid.shape;
  if (holdsCylinders(format) && !isCylinder())
    problems.push_back(format + " limits the distance from the z axis and the height: a " + shape.kind() +
                       " cannot be held; give a cylinder, " + remedies.cylinder);
  else if (holdsCylinders(format) && (region.center.x() != origin.x() || region.center.y() != origin.y()))
    problems.push_back(format +
                       " limits the distance from the z axis through its zero: a cylinder about another axis cannot be "
                       "held; give " +
                       remedies.center);
  if (!(origin.cwiseAbs().maxCoeff() <= FARTHEST))
    problems.push_back("origin = " + inMetres(origin) + " must be finite, within 1e9 m");
  else if (!holdsCylinders(format) && (!shape.isBox() || shape.dimensions(region.solid.size).size() != 3))
    problems.push_back(format + " limits each coordinate: a " + shape.kind() + " cannot be held; give a box, " +
                       remedies.box);
}

void ExportTask::validateMachine(const Machine& machine, Problems& problems) const
{
  if (machine.hasTolerances())
    problems.emplace_back(
        "limits of a controller are about where it believes the tool to be, and on a machine within tolerances the "
        "tool is elsewhere: leave the tolerances out, and make the region smaller by how far off the tool may be");
  if (!holdsCylinders(format))
    return;
  for (const Leg& leg : machine.legs())
    if (!standsAlongZ(leg))
      problems.push_back("joint '" + leg.joint +
                         "' is not along z with its carriage above the tool: the coordinates of " + format +
                         " are those of such rails, so its limits mean another region");
  if (!isBetweenRails(machine, origin))
    problems.push_back("the z axis is not between the rails: " + format + " limits the distance from it");
  if (!problems.empty() || top_by_slicer)
    return;
  const double ceiling = ceilingOver(machine, origin);
  const double top = held().box.upper.z();
  if (!(top > ceiling))
    problems.push_back(format +
                       " has no limit for the upper end of a delta but its switches, which let the tool up to " +
                       roundedUp(ceiling, 6) + " m above its zero, and the region ends " + roundedDown(top, 6) +
                       " m above it; the zero is at " + inMetres(origin) + " of the root link (" + remedies.origin +
                       "); give a region that ends above (with " + remedies.limits_off +
                       ": the switches hold those limits), or " + remedies.by_slicer);
}

HeldRegion ExportTask::held() const
{
  const CenteredSolid solid = centeredSolid(*region.solid.shape, region.center, region.solid.size);
  HeldRegion held;
  if (isCylinder())
    held.radius = solid.dimensions[1];
  for (int axis = isCylinder() ? 2 : 0; axis < 3; ++axis)
  {
    const Interval half = Interval(0.5) * Interval(solid.dimensions[isCylinder() ? 0 : static_cast<std::size_t>(axis)]);
    const Interval center = Interval(solid.center[axis]) - Interval(origin[axis]);
    held.box.lower[axis] = (center - half).upper();
    held.box.upper[axis] = (center + half).lower();
  }
  return held;
}

ExportReport exportLimits(const PointEvaluator& evaluator, const ExportTask& task)
{
  const Machine& machine = evaluator.machine();
  const Criterion& criterion = evaluator.test().model().criterion();
  Problems problems;
  task.validateBody(problems);
  throwProblems(problems);
  task.validateMachine(machine, problems);
  throwProblems(problems);
  const auto& [solid, center] = task.region;
  const ContainmentResult result = checkContainment(evaluator.test(), *solid.shape, center, solid.size, task.budget);
  ExportReport report;
  report.message = describe(result, evaluator, *solid.shape, center, solid.size, task.budget);
  if (result.verdict != Containment::INSIDE)
    throw std::invalid_argument(std::string("nothing is written, as the region is ") +
                                (result.verdict == Containment::OUTSIDE ? "outside" : "undecided") + ": " +
                                report.message);
  report.limits = writeLimits(task.format, task.held(), comments(machine, criterion, task, report.message));
  return report;
}
}  // namespace pkm_workspace
