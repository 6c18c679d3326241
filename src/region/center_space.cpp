// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/region/center_space.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "pkm_workspace/dexterity/unbounded.h"
#include "pkm_workspace/dexterity/workspace_bounds.h"
#include "pkm_workspace/region/own_proof.h"
#include "pkm_workspace/region/turned_region.h"

namespace pkm_workspace
{
namespace
{
/// Of a shape whose corners are looked at two at a time.
constexpr std::size_t FEW_POINTS = 8;
/// A difference that is rounded once.
const Interval ROUNDED(1.0 - 0x1p-52, 1.0 + 0x1p-52);

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
  const Box across = boundsAcrossRails(machine, query.criterion, axis, query.levelAlong(axis, machine));
  return query.search_box ? intersection(across, *query.search_box) : across;
}

/// No region is larger by what its points leave each other.
class SizeBound
{
public:
  double value() const { return value_; }
  /// |fixed + size per_size| <= room, where these two have such magnitudes.
  void take(const Interval& room, const Interval& fixed, const Interval& per_size)
  {
    if (per_size.lower() > 0.0)
      value_ = std::min(value_, ((room + fixed) / per_size).upper());
    else if (per_size.upper() == 0.0 && fixed.lower() > room.upper())
      value_ = 0.0;
  }

private:
  double value_ = INF;
};

/// Encloses |E v|.
Interval lengthWithin(const OuterBound& outer, const IntervalVector& v)
{
  return v == IntervalVector() ? Interval(0.0) : norm(outer.projector * v);
}

/// Two points k and k' of a region lie in an outer bound together only if |E (k - k')| <= 2 radius.
/// @param slack how far the points may be from where they are told to be [m]
double sizeBound(const Machine& machine, const RegionQuery& query, const Box& bounds, double slack = 0.0)
{
  SizeBound bound;
  const std::optional<Interval> slope = steepest(machine, query.criterion);
  const std::array<OuterBound, 3> reach = { outerBound(machine.enclosed(0), slope),
                                            outerBound(machine.enclosed(1), slope),
                                            outerBound(machine.enclosed(2), slope) };
  const std::vector<GrowingVector> points = query.shape->extremePoints();
  for (std::size_t first = 0; first < points.size(); ++first)
    for (std::size_t second = 0; second < first; ++second)
    {
      const IntervalVector fixed = enclose(points[first].fixed) - enclose(points[second].fixed);
      const IntervalVector per_size = enclose(points[first].per_size) - enclose(points[second].per_size);
      for (const OuterBound& outer : reach)
        bound.take(Interval(2.0) * (outer.radius + Interval(slack)), lengthWithin(outer, fixed),
                   lengthWithin(outer, per_size));
      for (std::size_t k = 0; k < 3; ++k)
        if (std::isfinite(bounds.upper[static_cast<int>(k)] - bounds.lower[static_cast<int>(k)]))
          bound.take(Interval(bounds.upper[static_cast<int>(k)]) - Interval(bounds.lower[static_cast<int>(k)]) +
                         Interval(2.0) * Interval(slack),
                     abs(fixed[k]), abs(per_size[k]));
    }
  return bound.value();
}

/// The same of a family whose slack grows with the size. Where none of that size is larger than the bound, none that is
/// larger is: bodies are nested.
double ownSizeBound(const OwnProof& own, const Machine& machine, const RegionQuery& query, const Box& bounds)
{
  const double most = 2.0 * sizeBound(machine, query, bounds) + 1.0;
  const double bound = sizeBound(machine, query, bounds, own.slack(most));
  return bound < most ? bound : INF;
}

/// A lower bound of |E R v| over all turns R about z.
double leastTurnedLength(const OuterBound& outer, const IntervalVector& v)
{
  double least = INF;
  for (const IntervalMatrix& turns : halfTurns())
    least = std::min(least, norm(outer.projector * (turns * v)).lower());
  return least;
}

/// The same where regions may be turned. Across the rail of a leg there is a horizontal direction, along which regions
/// measure no less than their least width, whatever the angle. Where a shape has few corners, two of them at a time are
/// looked at as above.
double turnedSizeBound(const Machine& machine, const RegionQuery& query, const Box& bounds)
{
  SizeBound bound;
  const std::optional<Interval> slope = steepest(machine, query.criterion);
  const Growing<double> width = leastWidth(*query.shape);
  const std::vector<GrowingVector> points = query.shape->extremePoints();
  for (int leg = 0; leg < 3; ++leg)
  {
    const OuterBound outer = outerBound(machine.enclosed(leg), slope);
    if (!outer.isBound())
      continue;
    const Interval room = Interval(2.0) * outer.radius;
    bound.take(room, Interval(-width.fixed), Interval(width.per_size));
    for (std::size_t first = 0; first < points.size() && points.size() <= FEW_POINTS; ++first)
      for (std::size_t second = 0; second < first; ++second)
      {
        const IntervalVector fixed = enclose(points[first].fixed) - enclose(points[second].fixed);
        const IntervalVector per_size = enclose(points[first].per_size) - enclose(points[second].per_size);
        const double least = leastTurnedLength(outer, per_size);
        if (least > 0.0)
          bound.take(room, norm(fixed), Interval(least));
      }
  }
  const GrowingVector extent = query.shape->upper() - query.shape->lower();
  const double height = bounds.upper.z() - bounds.lower.z();
  if (std::isfinite(height) && extent.fixed.z() == 0.0)
    bound.take(Interval(bounds.upper.z()) - Interval(bounds.lower.z()), 0.0, ROUNDED * Interval(extent.per_size.z()));
  return std::max(0.0, bound.value());
}
}  // namespace

CenterSpace centerSpace(const Machine& machine, const RegionQuery& query)
{
  const Box bounds = boundsOfSet(machine, query.criterion);
  CenterSpace space{ bounds, 0.0, std::nullopt };
  if (!bounds.isValid())
    return space;  // no point belongs to the set
  const OwnProof* const own = query.shape->ownProof();
  space.size_bound = own             ? ownSizeBound(*own, machine, query, bounds)
                     : query.turns() ? turnedSizeBound(machine, query, bounds)
                                     : sizeBound(machine, query, bounds);
  if (own)
    space.centers = *query.search_box;
  else if (isFreeAlongRails(machine, query))
    space.centers = centersAcrossRails(machine, query);
  else if (!machine.hasTolerances() && onlyJointsChangeAlongRails(machine, query.criterion) &&
           (!query.turns() || runAlongAxis(machine, 2)))
    space.centers = space.travel.emplace(machine, query, space.size_bound).places();
  else
  {
    space.centers = query.plain_bounds.value_or(bounds);
    if (query.search_box)
      space.centers = intersection(space.centers, *query.search_box);
  }
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
