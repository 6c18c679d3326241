// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/region/center_space.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace pkm_workspace
{
namespace
{
/// Boxes longer than this many struts are refused: nothing in them could be settled.
constexpr double LONGEST = 1000.0;
constexpr double INF = std::numeric_limits<double>::infinity();

const Box EVERYWHERE{ Eigen::Vector3d::Constant(-INF), Eigen::Vector3d::Constant(INF) };

/// The largest |q| of a leg that satisfies the criterion: within a cylinder around its rail (paper, section 4.2) [m].
Interval cylinderRadius(const Leg& leg, const Criterion& criterion)
{
  if (criterion.set == Criterion::Set::REACHABLE)
    return leg.length;
  const Interval share = Interval(1.0) - Interval(1.0) / sqr(Interval(criterion.psi_max));
  return leg.length * sqrt(Interval(std::max(0.0, share.lower()), std::max(0.0, share.upper())));
}

Interval symmetric(const Interval& radius)
{
  return Interval(-radius.upper(), radius.upper());
}

/// Coordinates of q, given its length: |q_k| <= |q| sqrt(1 - e_k^2), because q is across e.
IntervalVector offsetAcross(const Machine& machine, int leg, const Interval& radius)
{
  IntervalVector q;
  for (std::size_t k = 0; k < 3; ++k)
  {
    const Interval entry = machine.projector(leg)[k][k];
    q[k] = symmetric(radius * sqrt(Interval(std::max(0.0, entry.lower()), std::max(0.0, entry.upper()))));
  }
  return q;
}

/// All three cylinders at once: with E = I - e e^T and q = E (p - c), p = (sum E)^-1 (sum E c + sum q), so that
/// |p_k - ((sum E)^-1 sum E c)_k| <= sum |E (sum E)^-1 u_k| |q| for each unit vector u_k.
Box boundsByCylinders(const Machine& machine, const Criterion& criterion)
{
  IntervalMatrix sum;
  IntervalVector moment;
  for (int i = 0; i < 3; ++i)
  {
    moment = moment + machine.projector(i) * machine.center(i);
    for (std::size_t row = 0; row < 3; ++row)
      sum[row] = sum[row] + machine.projector(i)[row];
  }
  const Interval det = determinant(sum[0], sum[1], sum[2]);
  if (!det.certainlyPositive())
    return EVERYWHERE;
  // rows of the inverse of a symmetric matrix: cross products of its rows over its determinant
  const IntervalMatrix cofactors = { cross(sum[1], sum[2]), cross(sum[2], sum[0]), cross(sum[0], sum[1]) };
  IntervalVector p;
  for (std::size_t k = 0; k < 3; ++k)
  {
    const IntervalVector row{ cofactors[k][0] / det, cofactors[k][1] / det, cofactors[k][2] / det };
    p[k] = dot(row, moment);
    for (int i = 0; i < 3; ++i)
      p[k] += symmetric(norm(machine.projector(i) * row) * cylinderRadius(machine.leg(i), criterion));
  }
  return boundingBox(p);
}

/// One leg by its joint limits: p = c + q + t e, where t = rho + eta and |eta| <= L.
Box boundsByLimits(const Machine& machine, const Criterion& criterion, int i)
{
  const Leg& leg = machine.leg(i);
  if (!criterion.joint_limits || !leg.limits.isBounded())
    return EVERYWHERE;
  const Interval eta = leg.working_mode > 0 ? Interval(0.0, leg.length.upper()) : Interval(-leg.length.upper(), 0.0);
  const IntervalVector q = offsetAcross(machine, i, cylinderRadius(leg, criterion));
  return boundingBox(machine.center(i) + q + (leg.limits + eta) * leg.axis);
}

/// One leg and a plane p_axis = level: t = (level - c_axis - q_axis) / e_axis.
Box boundsInPlane(const Machine& machine, const Criterion& criterion, int axis, double level)
{
  Box bounds = EVERYWHERE;
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

/// The intersection of everything that is known; may be unbounded, or empty (not valid).
Box allBounds(const Machine& machine, const Criterion& criterion)
{
  Box bounds = machine.hasParallelRails() ? EVERYWHERE : boundsByCylinders(machine, criterion);
  for (int i = 0; i < 3; ++i)
    bounds = intersection(bounds, boundsByLimits(machine, criterion, i));
  return bounds;
}

bool isShort(const Box& box, const Machine& machine)
{
  return (box.upper - box.lower).maxCoeff() <= LONGEST * machine.scale();
}

void throwUnbounded(const char* remedy)
{
  throw std::invalid_argument(
      std::string("the rails are parallel or so nearly parallel that the set is longer than 1000 "
                  "struts: ") +
      remedy);
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
  for (const Eigen::Vector3d& first : points)
    for (const Eigen::Vector3d& second : points)
    {
      const IntervalVector difference = enclose(first) - enclose(second);
      for (int i = 0; i < 3; ++i)
        take(Interval(2.0) * cylinderRadius(machine.leg(i), query.criterion), norm(machine.projector(i) * difference));
      for (std::size_t k = 0; k < 3; ++k)
        if (std::isfinite(bounds.upper[static_cast<int>(k)] - bounds.lower[static_cast<int>(k)]))
          take(Interval(bounds.upper[static_cast<int>(k)]) - Interval(bounds.lower[static_cast<int>(k)]),
               difference[k]);
    }
  return bound;
}
}  // namespace

Box workspaceBounds(const Machine& machine, const Criterion& criterion)
{
  const Box bounds = allBounds(machine, criterion);
  if (bounds.isValid() && !isShort(bounds, machine))
    throwUnbounded("ask for joint limits or give a box");
  return bounds;
}

CenterSpace centerSpace(const Machine& machine, const RegionQuery& query)
{
  const Box bounds = allBounds(machine, query.criterion);
  CenterSpace space{ bounds, sizeBound(machine, query, bounds) };
  const bool limits_bound = isShort(bounds, machine) || !bounds.isValid();
  if (machine.hasParallelRails() && !limits_bound)
    space.centers = centersAcrossRails(machine, query);
  else if (query.search_box)
    space.centers = intersection(bounds, *query.search_box);
  if (space.centers.isValid() && !isShort(space.centers, machine))
    throwUnbounded("ask for joint limits or give a search box");
  if (!std::isfinite(space.size_bound))
    throw std::invalid_argument("a " + query.shape->name() +
                                " along the rails can be as long as one likes: "
                                "ask for joint limits or another shape");
  return space;
}
}  // namespace pkm_workspace
