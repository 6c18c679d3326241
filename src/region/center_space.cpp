// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/region/center_space.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "pkm_workspace/dexterity/workspace_bounds.h"

namespace pkm_workspace
{
namespace
{
constexpr double INF = std::numeric_limits<double>::infinity();

/// One leg and a plane p_axis = level: t = (level - c_axis - q_axis) / e_axis.
Box boundsInPlane(const Machine& machine, const Criterion& criterion, int axis, double level)
{
  Box bounds{ Eigen::Vector3d::Constant(-INF), Eigen::Vector3d::Constant(INF) };
  const auto k = static_cast<std::size_t>(axis);
  for (int i = 0; i < 3; ++i)
  {
    const IntervalVector& e = machine.leg(i).axis;
    const IntervalVector q = offsetAcross(machine, i, cylinderRadius(machine.leg(i), criterion));
    const Interval along = (Interval(level) - machine.center(i)[k] - q[k]) / e[k];
    bounds = intersection(bounds, boundingBox(machine.center(i) + q + along * e));
  }
  bounds.lower[axis] = bounds.upper[axis] = level;
  return bounds;
}

/// The coordinate axis that the (parallel) rails run along most.
int mainAxis(const Machine& machine)
{
  int axis = 0;
  mid(machine.leg(0).axis).cwiseAbs().maxCoeff(&axis);
  return axis;
}

bool runAlongAxis(const Machine& machine, int axis)
{
  const Interval& e = machine.leg(0).axis[static_cast<std::size_t>(axis)];
  return e == Interval(1.0) || e == Interval(-1.0);
}

/// Parallel rails without joint limits: nothing changes along them, so one plane of centers stands for all.
Box centersAcrossRails(const Machine& machine, const RegionQuery& query)
{
  const int axis = mainAxis(machine);
  if (!query.search_box)
    return boundsInPlane(machine, query.criterion, axis, machine.zero()[axis]);
  if (!runAlongAxis(machine, axis))
    return *query.search_box;
  const double level = query.search_box->center()[axis];
  return intersection(boundsInPlane(machine, query.criterion, axis, level), *query.search_box);
}

/// Two points k and k' of K lie in a cylinder together only if size * |E (k - k')| <= 2 radius.
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
        take(Interval(2.0) * cylinderRadius(machine.leg(i), query.criterion), norm(machine.projector(i) * difference));
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
  CenterSpace space{ bounds, sizeBound(machine, query, bounds) };
  const bool limits_bound = isBounded(bounds, machine) || !bounds.isValid();
  if (machine.hasParallelRails() && !limits_bound)
    space.centers = centersAcrossRails(machine, query);
  else if (query.search_box)
    space.centers = intersection(bounds, *query.search_box);
  if (space.centers.isValid() && !isBounded(space.centers, machine))
    throwUnbounded("ask for joint limits or give a search box");
  if (!std::isfinite(space.size_bound))
    throw std::invalid_argument("a " + query.shape->name() +
                                " along the rails can be as long as one likes: "
                                "ask for joint limits or another shape");
  return space;
}
}  // namespace pkm_workspace
