// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/region/largest_region.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "pkm_workspace/dexterity/defaults.h"
#include "pkm_workspace/interval/decimal.h"
#include "pkm_workspace/region/center_search.h"
#include "pkm_workspace/region/largest_cylinder.h"
#include "pkm_workspace/region/path.h"
#include "pkm_workspace/region/region_height.h"
#include "pkm_workspace/region/turned_region.h"

namespace pkm_workspace
{
namespace
{
/// Of the longest strut. Finer than what doubles can tell, coarser than any region.
constexpr double FINEST_ACCURACY = 1e-18;
constexpr double COARSEST_ACCURACY = 1e3;
}  // namespace

void RegionQuery::validate(Problems& problems) const
{
  if (!shape)
    problems.push_back("a shape is missing");
  if (ratio && !(ratio->lower > 0.0 && ratio->lower <= ratio->upper && ratio->upper <= 1e6))
    problems.push_back("ratio = [" + exact(ratio->lower) + ", " + exact(ratio->upper) +
                       "] must be from 1e-6 to 1e6, the least one first");
  if (shape && turns() && !canTurn(shape->kind()))
    problems.push_back("regions of this shape cannot be turned: a turn changes nothing about a " + shape->kind());
  criterion.validate(problems);
  if (criterion.aspect == Criterion::Aspect::BOTH && criterion.settlesAspect())
    problems.push_back(
        "a region with bounded factors lies in one aspect: ask for the machine's own or for the other one");
  validatePositive("accuracy", accuracy, "(in the unit of the size, m for edges)", problems);
  budget.validate(problems);
  if (search_box)
    validateBox("search_box", *search_box, problems);
}

bool RegionQuery::bounds(int axis) const
{
  return search_box && search_box->upper[axis] - search_box->lower[axis] < 2.0 * FARTHEST;
}

double RegionQuery::levelAlong(int axis, const Machine& machine) const
{
  return bounds(axis) ? search_box->center()[axis] : machine.zero()[axis];
}

std::string RegionQuery::place() const
{
  if (base_z)
    return "standing on z = " + exact(*base_z) + " m" +
           (hasSearchBox() ? " with the middle of its base in the search box" : "");
  return !search_box                              ? "wherever its center"
         : search_box->lower == search_box->upper ? "with this center"
                                                  : "with its center in the search box";
}

AccuracyRange accuracyRange(const Machine& machine, const Shape& shape)
{
  const double unit = machine.scale() / (2.0 * shape.halfExtents().per_size.maxCoeff());
  return { FINEST_ACCURACY * unit, COARSEST_ACCURACY * unit };
}

double defaultAccuracy(const Machine& machine, const Shape& shape)
{
  const AccuracyRange allowed = accuracyRange(machine, shape);
  const double unit = shape.isPolytope() ? 2.0 * shape.halfExtents().per_size.maxCoeff() : 1.0;
  return std::clamp(defaultAccuracy(machine) / unit, allowed.finest, allowed.coarsest);
}

void validateAccuracy(const Machine& machine, const RegionQuery& query, Problems& problems)
{
  const AccuracyRange allowed = accuracyRange(machine, *query.shape);
  if (!(allowed.finest <= query.accuracy && query.accuracy <= allowed.coarsest))
    complain(problems, "accuracy = ", query.accuracy, " (in the unit of the size, m for edges) must be from ",
             nearly(allowed.finest, 6), " to ", nearly(allowed.coarsest, 6),
             " for this machine, whose longest strut is ", machine.scale(), " m");
}

namespace
{
/// No region that is no larger than the size, which may be infinite, has a larger volume.
double volumeBelow(const Shape& shape, double size)
{
  if (std::isfinite(size) || shape.volume(1.0).upper() == 0.0)
    return shape.volume(std::isfinite(size) ? size : 1.0).upper();
  return size;
}

bool isNarrow(const LargestRegion& region, double accuracy)
{
  const double enough = rounding::add(region.size, accuracy).lower;
  return region.ratio ? region.volume_upper_bound <= region.shape->volume(enough).lower()
                      : region.size_upper_bound <= enough;
}
}  // namespace

void conclude(LargestRegion& region, double accuracy, const std::string& ended_by, bool finer)
{
  region.status = LargestRegion::Status::STOPPED;
  region.volume = region.shape->volume(region.size).lower();
  if (!region.ratio)
    region.volume_upper_bound = volumeBelow(*region.shape, region.size_upper_bound);
  const bool narrow = isNarrow(region, accuracy);
  if (narrow && region.size > 0.0)
  {
    region.status = LargestRegion::Status::PROVEN;
    region.message = "proved to the accuracy asked for";
  }
  else if (narrow)
  {
    region.status = LargestRegion::Status::NONE;
    region.message = region.size_upper_bound == 0.0 ? "no region of any size exists where the center may lie, proved"
                     : region.ratio ? "no cylinder of the volume that the accuracy asks for exists, proved"
                                    : "no region as large as the accuracy exists where the center may lie, proved";
  }
  else if (ended_by.empty())
    region.message =
        std::string("the accuracy is below what this precision can settle for this machine: ask for a coarser one") +
        (finer ? ", or for multi-precision" : "");
  else
    region.message = ended_by + " ended the search: the bracket holds, but is wide";
}

namespace
{
/// What keeps every region away, for the end of a message; empty where each rail can move.
std::string railsThatCannotMove(const Machine& machine)
{
  std::string names;
  for (const Leg& leg : machine.legs())
    if (!leg.limits.isEmpty() && leg.limits.width() == 0.0)
      names += (names.empty() ? "'" : ", '") + leg.joint + "'";
  return names.empty() ? "" : ": the joint limits hold " + names + " fixed, lower = upper";
}
}  // namespace

LargestRegion findLargestRegion(const Machine& machine, const RegionQuery& query)
{
  Problems problems;
  validateAccuracy(machine, validated(query), problems);
  throwProblems(problems);
  const RunningBudget budget(query.budget);
  LargestRegion region = query.ratio ? findLargestCylinder(machine, query) : CenterSearch(machine, query).run();
  query.turns() ? settleTurned(machine, query, budget, region) : settleHeight(machine, query, budget, region);
  if (region.status == LargestRegion::Status::NONE && query.criterion.joint_limits)
    region.message += railsThatCannotMove(machine);
  return region;
}

LargestRegion largestRegionAt(const Machine& machine, const RegionQuery& query, const Eigen::Vector3d& center)
{
  RegionQuery at_center = query;
  at_center.search_box = Box{ center, center };
  at_center.base_z.reset();
  return findLargestRegion(machine, at_center);
}
}  // namespace pkm_workspace
