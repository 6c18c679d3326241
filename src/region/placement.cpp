// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/region/placement.h"

#include <algorithm>
#include <stdexcept>

#include "pkm_workspace/dexterity/unbounded.h"
#include "pkm_workspace/dexterity/workspace_bounds.h"
#include "pkm_workspace/region/center_search.h"
#include "pkm_workspace/region/path.h"

namespace pkm_workspace
{
namespace
{
/// The translations for which all extreme points lie within the bounds.
Box translationsInto(const Box& bounds, const PathBody& body)
{
  Box translations{ Eigen::Vector3d::Constant(-INF), Eigen::Vector3d::Constant(INF) };
  const Interval slack(-body.slack(0.0), body.slack(0.0));
  for (const GrowingVector& place : body.extremePoints())
    for (int k = 0; k < 3; ++k)
    {
      const Interval point = Interval(place.fixed[k]) + slack;
      if (bounds.lower[k] > -INF)
        translations.lower[k] = std::max(translations.lower[k], (Interval(bounds.lower[k]) - point).lower());
      if (bounds.upper[k] < INF)
        translations.upper[k] = std::min(translations.upper[k], (Interval(bounds.upper[k]) - point).upper());
    }
  return translations;
}

/// As far as the search may go: the workpiece in the bounds of the set, and what the query says.
Box translationsOf(const Machine& machine, const PlacementQuery& query, const PathBody& body)
{
  const Box bounds = boundsOfSet(machine, query.criterion);
  if (!bounds.isValid())
    return bounds;
  Box translations = translationsInto(bounds, body);
  if (query.translations)
    translations = intersection(translations, *query.translations);
  if (translations.isValid() && !isBounded(translations, machine))
    throwUnbounded(machine, query.criterion);
  return translations;
}

RegionQuery regionQuery(const PlacementQuery& query, const std::shared_ptr<const PathBody>& body, const Box& places)
{
  RegionQuery region;
  region.shape = body;
  region.criterion = query.criterion;
  region.accuracy = query.accuracy;
  region.search_box = places;
  region.budget = query.budget;
  region.progress = query.progress;
  region.progress_period = query.progress_period;
  return region;
}

/// NONE is left for the proof that there is no place: with a margin below the accuracy there may be one.
void leaveOpen(LargestRegion& found)
{
  if (found.status != LargestRegion::Status::NONE || found.size_upper_bound == 0.0)
    return;
  found.status = LargestRegion::Status::STOPPED;
  found.message = "the accuracy ended the search: a finer one may find a place";
}

/// A point is the same at every scale.
void requireScale(const Machine& machine, const Workpiece& workpiece)
{
  constexpr double ROUNDING = 1e-12;  // of its bounds, of the largest coordinate
  const Box bounds = workpiece.bounds();
  const double far = bounds.lower.cwiseAbs().cwiseMax(bounds.upper.cwiseAbs()).maxCoeff();
  if (!workpiece.solid && bounds.maxWidth() <= ROUNDING * std::max(far, machine.scale()))
    throw std::invalid_argument("the path is one point, the same at every scale: leave out the largest scale");
}

LargestScale largestScale(const Machine& machine, const PlacementQuery& query, bool is_placed)
{
  LargestScale result;
  result.least = is_placed ? 1.0 : 0.0;
  const auto body = std::make_shared<PathBody>(query.workpiece, PathBody::Grows::SCALE, result.least);
  RegionQuery region = regionQuery(query, body, translationsOf(machine, query, *body));
  region.accuracy = query.scale_accuracy;
  result.search = CenterSearch(machine, region).run();
  result.translation = result.search.center;
  if (result.search.size > 0.0)
    result.scale = (Interval(result.least) + Interval(result.search.size)).lower();
  result.upper_bound = (Interval(result.least) + Interval(result.search.size_upper_bound)).upper();
  return result;
}
}  // namespace

void PlacementQuery::validate(Problems& problems) const
{
  criterion.validate(problems);
  limits.validate(problems);
  if (!workpiece || (!workpiece->solid && workpiece->moves.size() == 0))
    problems.push_back("there is nothing to be placed");
  if (translations)
    validateBox("translations", *translations, problems);
  validatePositive("accuracy", accuracy, "m", problems);
  validatePositive("scale_accuracy", scale_accuracy, "", problems);
  budget.validate(problems);
}

Placement findPlacement(const Machine& machine, const PlacementQuery& query)
{
  const PlacementQuery& valid = validated(query);
  if (valid.wants_scale)
    requireScale(machine, *valid.workpiece);
  const auto body = std::make_shared<PathBody>(valid.workpiece, PathBody::Grows::MARGIN, 1.0, valid.limits);
  Placement placement;
  placement.translations = translationsOf(machine, valid, *body);
  placement.found = CenterSearch(machine, regionQuery(valid, body, placement.translations)).run();
  leaveOpen(placement.found);
  if (valid.wants_scale)
    placement.largest = largestScale(machine, valid, placement.found.size > 0.0);
  return placement;
}
}  // namespace pkm_workspace
