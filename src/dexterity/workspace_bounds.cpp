// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/dexterity/workspace_bounds.h"

#include <algorithm>
#include <limits>

#include "pkm_workspace/dexterity/unbounded.h"

#include "pkm_workspace/dexterity/eta_range.h"

namespace pkm_workspace
{
namespace
{
/// In struts.
constexpr double LONGEST = 1000.0;
constexpr double INF = std::numeric_limits<double>::infinity();

const Box EVERYWHERE{ Eigen::Vector3d::Constant(-INF), Eigen::Vector3d::Constant(INF) };

Interval symmetric(const Interval& radius)
{
  return Interval(-radius.upper(), radius.upper());
}

/// All three cylinders at once: with E = I - e e^T and q = E (p - c), p = (sum E)^-1 (sum E c + sum q), so that for any
/// u |u . p - u . (sum E)^-1 sum E c| <= sum |E (sum E)^-1 u| |q|.
class Cylinders
{
public:
  Cylinders(const Machine& machine, const Criterion& criterion) : machine_(machine), criterion_(criterion)
  {
    IntervalMatrix sum;
    for (int i = 0; i < 3; ++i)
    {
      moment_ = moment_ + machine.projector(i) * machine.center(i);
      for (std::size_t row = 0; row < 3; ++row)
        sum[row] = sum[row] + machine.projector(i)[row];
    }
    const Interval det = determinant(sum[0], sum[1], sum[2]);
    meet_ = !machine.hasParallelRails() && det.certainlyPositive();
    if (!meet_)
      return;
    // rows of the inverse of a symmetric matrix: cross products of its rows over its determinant
    inverse_ = { cross(sum[1], sum[2]), cross(sum[2], sum[0]), cross(sum[0], sum[1]) };
    for (IntervalVector& row : inverse_)
      row = { row[0] / det, row[1] / det, row[2] / det };
  }

  /// Encloses the points that lie in all three.
  Box bounds() const
  {
    if (!meet_)
      return EVERYWHERE;
    return boundingBox({ range(inverse_[0]), range(inverse_[1]), range(inverse_[2]) });
  }

  /// Encloses rho of leg i at these points: e . (p - c) - eta, where eta^2 = L^2 - |q|^2.
  Interval jointRange(int i) const
  {
    if (!meet_)
      return Interval::entire();
    const Leg& leg = machine_.leg(i);
    const Interval along = range(inverse_ * leg.axis) - dot(leg.axis, machine_.center(i));
    return along - etaRange(leg, criterion_);
  }

private:
  /// Encloses u . p. @param image (sum E)^-1 u
  Interval range(const IntervalVector& image) const
  {
    Interval sum = dot(image, moment_);
    for (int i = 0; i < 3; ++i)
      sum += symmetric(norm(machine_.projector(i) * image) * cylinderRadius(machine_.leg(i), criterion_));
    return sum;
  }

  const Machine& machine_;
  const Criterion& criterion_;
  bool meet_ = false;  ///< whether they bound anything
  IntervalMatrix inverse_;
  IntervalVector moment_;
};

/// One leg by its joint limits: p = c + q + t e, where t = rho + eta and |eta| <= L.
Box boundsByLimits(const Machine& machine, const Criterion& criterion, int i)
{
  const Leg& leg = machine.leg(i);
  if (!leg.limits.isBounded())
    return EVERYWHERE;
  const Interval eta = leg.working_mode > 0 ? Interval(0.0, leg.length.upper()) : Interval(-leg.length.upper(), 0.0);
  const IntervalVector q = offsetAcross(machine, i, cylinderRadius(leg, criterion));
  return boundingBox(machine.center(i) + q + (leg.limits + eta) * leg.axis);
}

/// Parallel rails by the limits of several legs: e . p = e . c + sense (rho + eta) for each, with e that of the first.
Box boundsByLimitsTogether(const Machine& machine, const Criterion& criterion)
{
  const IntervalVector& e = machine.leg(0).axis;
  Interval along = Interval::entire();
  for (int i = 0; i < 3 && !along.isEmpty(); ++i)
  {
    const Leg& leg = machine.leg(i);
    const Interval travel = Interval(parallelSense(machine.leg(0), leg)) * (leg.limits + etaRange(leg, criterion));
    along = intersection(along, dot(e, machine.center(i)) + travel);
  }
  if (along.isEmpty())
    return { Eigen::Vector3d::Constant(INF), Eigen::Vector3d::Constant(-INF) };
  if (!along.isBounded())
    return EVERYWHERE;
  const IntervalVector q = offsetAcross(machine, 0, cylinderRadius(machine.leg(0), criterion));
  return boundingBox(machine.center(0) + q + (along - dot(e, machine.center(0))) * e);
}
}  // namespace

Interval cylinderRadius(const Leg& leg, const Criterion& criterion)
{
  if (!criterion.boundsAbove())
    return leg.length;
  const Interval share = Interval(1.0) - Interval(1.0) / sqr(criterion.largestFactor());
  return leg.length * sqrtAboveZero(share);
}

Interval etaRange(const Leg& leg, const Criterion& criterion)
{
  const double longest = leg.length.upper();
  const double least = criterion.boundsAbove() ? (leg.length / criterion.largestFactor()).lower() : 0.0;
  return Interval(leg.working_mode) * Interval(std::min(least, longest), longest);
}

IntervalVector offsetAcross(const Machine& machine, int leg, const Interval& radius)
{
  IntervalVector q;
  for (std::size_t k = 0; k < 3; ++k)
  {
    q[k] = symmetric(radius * sqrtAboveZero(machine.projector(leg)[k][k]));
  }
  return q;
}

std::array<Interval, 3> limitsThatBind(const Machine& machine, const Criterion& criterion)
{
  std::array<Interval, 3> binding = { Interval::entire(), Interval::entire(), Interval::entire() };
  if (!criterion.joint_limits || !machine.hasJointLimits())
    return binding;
  const Cylinders cylinders(machine, criterion);
  for (int i = 0; i < 3; ++i)
  {
    const Interval& limits = machine.leg(i).limits;
    const Interval range = cylinders.jointRange(i);
    binding[static_cast<std::size_t>(i)] = { range.lower() >= limits.lower() ? -INF : limits.lower(),
                                             range.upper() <= limits.upper() ? INF : limits.upper() };
  }
  return binding;
}

Box boundsOfSet(const Machine& machine, const Criterion& criterion)
{
  Box bounds = Cylinders(machine, criterion).bounds();
  const std::array<Interval, 3> limits = limitsThatBind(machine, criterion);
  for (int i = 0; i < 3; ++i)
    if (limits[static_cast<std::size_t>(i)] != Interval::entire())
      bounds = intersection(bounds, boundsByLimits(machine, criterion, i));
  const bool leaves_ends = !(bounds.upper - bounds.lower).allFinite();
  return leaves_ends && criterion.joint_limits && machine.hasParallelRails()
             ? intersection(bounds, boundsByLimitsTogether(machine, criterion))
             : bounds;
}

bool slidesAlongRails(const Machine& machine, const Criterion& criterion)
{
  return machine.hasParallelRails() && !(criterion.joint_limits && machine.hasJointLimits());
}

int mainAxisOfRails(const Machine& machine)
{
  int axis = 0;
  mid(machine.leg(0).axis).cwiseAbs().maxCoeff(&axis);
  return axis;
}

Box boundsAcrossRails(const Machine& machine, const Criterion& criterion, int axis, double level)
{
  Box bounds = EVERYWHERE;
  const auto k = static_cast<std::size_t>(axis);
  for (int i = 0; i < 3; ++i)
  {
    // one leg and the plane: t = (level - c_axis - q_axis) / e_axis
    const IntervalVector& e = machine.leg(i).axis;
    const IntervalVector q = offsetAcross(machine, i, cylinderRadius(machine.leg(i), criterion));
    const Interval along = (Interval(level) - machine.center(i)[k] - q[k]) / e[k];
    bounds = intersection(bounds, boundingBox(machine.center(i) + q + along * e));
  }
  bounds.lower[axis] = bounds.upper[axis] = level;
  return bounds;
}

bool isBounded(const Box& box, const Machine& machine)
{
  return (box.upper - box.lower).maxCoeff() <= LONGEST * machine.scale();
}

Box workspaceBounds(const Machine& machine, const Criterion& criterion)
{
  const Box bounds = boundsOfSet(machine, criterion);
  if (bounds.isValid() && !isBounded(bounds, machine))
    throwUnbounded(machine, criterion);
  return bounds;
}
}  // namespace pkm_workspace
