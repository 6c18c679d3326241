// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/region/center_space.h"

#include <algorithm>
#include <cmath>

#include "pkm_workspace/dexterity/unbounded.h"
#include "pkm_workspace/dexterity/workspace_bounds.h"

namespace pkm_workspace
{
namespace
{
bool runAlongAxis(const Machine& machine, int axis)
{
  const Interval& e = directionOfRails(machine)[static_cast<std::size_t>(axis)];
  return e == Interval(1.0) || e == Interval(-1.0);
}

/// Whether nothing bounds centers along the rails, or a search box does at every place alike.
bool isFreeAlongRails(const Machine& machine, const RegionQuery& query)
{
  return slidesAlongRails(machine, query.criterion) &&
         (!query.search_box || runAlongAxis(machine, mainAxisOfRails(machine)));
}

/// Then nothing changes along them, so one plane of centers stands for all.
Box centersAcrossRails(const Machine& machine, const RegionQuery& query)
{
  const int axis = mainAxisOfRails(machine);
  if (!query.search_box)
    return boundsAcrossRails(machine, query.criterion, axis, machine.zero()[axis]);
  const double level = query.search_box->center()[axis];
  return intersection(boundsAcrossRails(machine, query.criterion, axis, level), *query.search_box);
}

/// Two points k and k' of K lie in an outer bound together only if size * |E (k - k')| <= 2 radius.
double sizeBound(const Machine& machine, const RegionQuery& query, const Box& bounds)
{
  double bound = INF;
  const auto take = [&bound](const Interval& room, const Interval& extent) {
    if (extent.lower() > 0.0)
      bound = std::min(bound, (room / extent).upper());
  };
  const std::vector<Eigen::Vector3d> points = query.shape->extremePoints();
  for (std::size_t first = 0; first < points.size(); ++first)
    for (std::size_t second = 0; second < first; ++second)
    {
      const IntervalVector difference = enclose(points[first]) - enclose(points[second]);
      for (int i = 0; i < 3; ++i)
      {
        const OuterBound outer = outerBound(machine.enclosed(i), steepest(query.criterion));
        take(Interval(2.0) * outer.radius, norm(outer.projector * difference));
      }
      for (std::size_t k = 0; k < 3; ++k)
        if (std::isfinite(bounds.upper[static_cast<int>(k)] - bounds.lower[static_cast<int>(k)]))
          take(Interval(bounds.upper[static_cast<int>(k)]) - Interval(bounds.lower[static_cast<int>(k)]),
               abs(difference[k]));
    }
  return bound;
}
}  // namespace

CenterSpace centerSpace(const Machine& machine, const RegionQuery& query)
{
  const Box bounds = boundsOfSet(machine, query.criterion);
  CenterSpace space{ bounds, 0.0, std::nullopt };
  if (!bounds.isValid())
    return space;  // no point belongs to the set
  space.size_bound = sizeBound(machine, query, bounds);
  if (isFreeAlongRails(machine, query))
    space.centers = centersAcrossRails(machine, query);
  else if (machine.hasParallelRails())
    space.centers = space.travel.emplace(machine, query, space.size_bound).places();
  else if (query.search_box)
    space.centers = intersection(bounds, *query.search_box);
  if (!space.centers.isValid())
  {
    space.size_bound = 0.0;  // nor does a center
    return space;
  }
  if (!isBounded(space.centers, machine))
    throwUnbounded(machine, query.criterion);
  if (!std::isfinite(space.size_bound))
    throw Unbounded(Unbounded::What::SHAPE, "a " + query.shape->name() + " along the rails can be as long as one likes",
                    machine, query.criterion);
  return space;
}
}  // namespace pkm_workspace
