// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/tasks/placement.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "pkm_workspace/dexterity/point_evaluation.h"
#include "pkm_workspace/dexterity/workspace_bounds.h"
#include "pkm_workspace/interval/decimal.h"
#include "pkm_workspace/region/path.h"
#include "pkm_workspace/region/polytope.h"
#include "pkm_workspace/report/binding_limit.h"
#include "pkm_workspace/report/placement_sentence.h"
#include "pkm_workspace/report/rates_sentence.h"

namespace pkm_workspace
{
namespace
{
using Eigen::Vector3d;

std::shared_ptr<Workpiece> movesOf(const PlacementTask& task)
{
  auto workpiece = std::make_shared<Workpiece>();
  const Interval speed(task.rates.isHeld() ? task.rates.tool_speed.value_or(0.0) : 0.0);
  task.for_each([&](const PathStep& step) {
    const Interval own = task.rates.isHeld() ? step.tool_speed.value_or(speed) : Interval(0.0);
    workpiece->moves.add(step.segment.curve(), own);
  });
  if (workpiece->moves.size() == 0)
    throw std::invalid_argument("there is nothing to be placed: the path has no segment");
  workpiece->moves.close();
  return workpiece;
}

std::string nearlyInMetres(const Vector3d& v)
{
  return "(" + nearly(v.x(), 6) + ", " + nearly(v.y(), 6) + ", " + nearly(v.z(), 6) + ") m";
}

/// The middle of its bounds, or of their lowest face.
Vector3d referenceOf(const PlacementTask& task, const Box& bounds)
{
  Vector3d middle = bounds.center();
  if (task.base_z)
    middle.z() = bounds.lower.z();
  return task.reference.value_or(middle);
}

/// The mean of the vertices, or of the lowest ones: a point of the part.
Vector3d referenceOf(const PlacementTask& task)
{
  double lowest = INF;
  for (const Vector3d& vertex : task.vertices)
    lowest = std::min(lowest, vertex.z());
  Vector3d sum = Vector3d::Zero();
  double count = 0.0;
  for (const Vector3d& vertex : task.vertices)
    if (!task.base_z || vertex.z() == lowest)
    {
      sum += vertex;
      count += 1.0;
    }
  Vector3d mean = sum / count;
  if (task.base_z)
    mean.z() = lowest;
  return task.reference.value_or(mean);
}

/// As seen from the reference.
ShapePtr solidOf(const PlacementTask& task, const Vector3d& reference)
{
  std::vector<Vector3d> vertices = task.vertices;
  for (Vector3d& vertex : vertices)
    vertex -= reference;
  try
  {
    return makePolytope(vertices);
  }
  catch (const std::invalid_argument& reason)
  {
    throw std::invalid_argument(task.part + ", seen from its reference (" + exact(reference.x()) + ", " +
                                exact(reference.y()) + ", " + exact(reference.z()) + ") m: " + reason.what());
  }
}

std::shared_ptr<Workpiece> partOf(const PlacementTask& task)
{
  auto workpiece = std::make_shared<Workpiece>();
  workpiece->reference = referenceOf(task);
  workpiece->solid = solidOf(task, workpiece->reference);
  return workpiece;
}

std::shared_ptr<Workpiece> workpieceOf(const PlacementTask& task)
{
  if (!task.vertices.empty())
    return partOf(task);
  std::shared_ptr<Workpiece> workpiece = movesOf(task);
  workpiece->reference = referenceOf(task, workpiece->bounds());
  return workpiece;
}

/// Leaves one height.
void standOn(double base_z, double lowest, PlacementQuery& query)
{
  if (!(std::abs(base_z) <= FARTHEST))
    throw std::invalid_argument("base_z = " + exact(base_z) + " m must be finite, within 1e9 m");
  Box translations = query.translations.value_or(Box{ Vector3d::Constant(-FARTHEST), Vector3d::Constant(FARTHEST) });
  const double z = base_z - lowest;
  if (!(translations.lower.z() <= z && z <= translations.upper.z()))
    throw std::invalid_argument("base_z = " + exact(base_z) + " m asks for a translation by " + exact(z) +
                                " m along z, and that is not one of those that may be chosen, from " +
                                exact(translations.lower.z()) + " to " + exact(translations.upper.z()) + " m");
  translations.lower.z() = translations.upper.z() = z;
  query.translations = translations;
}
/// " All of the set is within x -0.1 to 0.1 m, z 0.7 to 1.2 m.", along the axes where it has ends.
std::string extentOf(const Machine& machine, const Criterion& criterion)
{
  const Box all = boundsOfSet(machine, criterion);
  std::string text;
  for (int axis = 0; axis < 3 && all.isValid(); ++axis)
    if (std::isfinite(all.lower[axis]) && std::isfinite(all.upper[axis]))
      text += std::string(text.empty() ? " All of the set is within " : ", ") + "xyz"[axis] + " " +
              bracket(all.lower[axis], all.upper[axis]) + " m";
  return text.empty() ? "" : text + ".";
}

/// Where there is no place: what is in the way, at a point of the workpiece and a translation that brings its bounds as
/// near to the middle of the set as translations may.
std::string whyNowhere(const Machine& machine, const PlacementReport& report)
{
  const Criterion& criterion = report.query.criterion;
  const Workpiece& workpiece = *report.query.workpiece;
  const Box all = boundsOfSet(machine, criterion);
  const bool is_bounded = all.isValid() && all.lower.allFinite() && all.upper.allFinite();
  Vector3d moved = (is_bounded ? all.center() : machine.zero()) - workpiece.bounds().center();
  if (const auto& translations = report.query.translations)
    moved = moved.cwiseMax(translations->lower).cwiseMin(translations->upper);
  const Vector3d point =
      moved + (workpiece.solid ? workpiece.reference : mid(workpiece.moves.curve(PathTree::Part{}).point(0.0)));
  const PointEvaluation there = evaluatePoint(machine, criterion, point);
  std::string text = extentOf(machine, criterion);
  if (there.verdict == BoxVerdict::OUTSIDE)
    text += " For instance, moved by " + nearlyInMetres(moved) + ", a point of it is at " + nearlyInMetres(point) +
            ": " + describe(there.binding(), machine) + ".";
  return text;
}
}  // namespace

PlacementReport place(const Machine& machine, const PlacementTask& task)
{
  PlacementReport report;
  report.query = task.query;
  const JointRateLimits limits = limitsOf(task.rates, machine, task.query.criterion);
  if (task.rates.isHeld())
    report.query.limits = limits;
  const std::shared_ptr<Workpiece> workpiece = workpieceOf(task);
  report.query.workpiece = workpiece;
  if (task.base_z)
    standOn(*task.base_z, workpiece->lowest(), report.query);
  report.placement = findPlacement(machine, report.query);
  const LargestRegion& found = report.placement.found;
  const bool is_nowhere = found.size == 0.0 && found.size_upper_bound == 0.0;
  report.message =
      withRemark(describe(report.placement, machine, report.query) + (is_nowhere ? whyNowhere(machine, report) : ""),
                 task.rates.isHeld() ? speedsNotHeld(limits, machine, task.rates.joint_speeds_off) : "");
  report.message = withRemark(report.message, remarkOnLimits(machine, task.query.criterion, std::nullopt));
  return report;
}
}  // namespace pkm_workspace
