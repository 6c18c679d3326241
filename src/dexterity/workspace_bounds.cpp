// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/dexterity/workspace_bounds.h"

#include <algorithm>

#include "pkm_workspace/dexterity/machine_model.h"
#include "pkm_workspace/dexterity/unbounded.h"
#include "pkm_workspace/dexterity/zone_forms.h"
#include "pkm_workspace/machine/rails.h"

namespace pkm_workspace
{
namespace
{
/// In struts.
constexpr double LONGEST = 1000.0;

const Box EVERYWHERE{ Eigen::Vector3d::Constant(-INF), Eigen::Vector3d::Constant(INF) };

Interval symmetric(const Interval& radius)
{
  return Interval(-radius.upper(), radius.upper());
}

/// All three outer bounds at once: with q = E (p - c), p = (sum E)^-1 (sum E c + sum q), so that for any u
/// |u . p - u . (sum E)^-1 sum E c| <= sum |E (sum E)^-1 u| |q|.
class OuterBounds
{
public:
  OuterBounds(const Machine& machine, const Criterion& criterion)
    : machine_(machine), steepest_(steepest(machine, criterion))
  {
    IntervalMatrix sum;
    for (std::size_t i = 0; i < 3; ++i)
    {
      bounds_[i] = outerBound(machine.enclosed(static_cast<int>(i)), steepest_);
      moment_ = moment_ + bounds_[i].projector * bounds_[i].center;
      for (std::size_t row = 0; row < 3; ++row)
        sum[row] = sum[row] + bounds_[i].projector[row];
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
  Box box() const
  {
    if (!meet_)
      return EVERYWHERE;
    return boundingBox({ range(inverse_[0]), range(inverse_[1]), range(inverse_[2]) });
  }

  /// Encloses the joint value of leg i at these points.
  Interval jointRange(int i) const
  {
    if (!meet_)
      return Interval::entire();
    const auto along = [this](const IntervalVector& u) { return range(inverse_ * u); };
    return visitLeg([&](const auto& leg) { return pkm_workspace::jointRange(leg, steepest_, along); },
                    machine_.enclosed(i));
  }

private:
  /// Encloses u . p. @param image (sum E)^-1 u
  Interval range(const IntervalVector& image) const
  {
    Interval sum = dot(image, moment_);
    for (const OuterBound& bound : bounds_)
      sum += symmetric(norm(bound.projector * image) * bound.radius);
    return sum;
  }

  const Machine& machine_;
  std::optional<Interval> steepest_;
  std::array<OuterBound, 3> bounds_;
  bool meet_ = false;  ///< whether they bound anything
  IntervalMatrix inverse_;
  IntervalVector moment_;
};

/// One leg by its joint limits. @param limits none, or those that it has
Box boundsByLimits(const Machine& machine, const Criterion& criterion, int i, const Interval& limits)
{
  const bool is_bounded = limits.isBounded() || hasAngle(machine.leg(i));
  return is_bounded ? boundingBox(pointsWithin(machine.enclosed(i), limits, steepest(machine, criterion))) : EVERYWHERE;
}

/// Parallel rails by the limits of several legs: e . p = e . c + sense (rho + eta) for each, with e that of the first.
Box boundsByLimitsTogether(const Machine& machine, const Criterion& criterion)
{
  const IntervalVector& e = directionOfRails(machine);
  const std::optional<Interval> slope = steepest(machine, criterion);
  Interval along = Interval::entire();
  for (int i = 0; i < 3 && !along.isEmpty(); ++i)
  {
    const Leg& leg = machine.leg(i);
    const Interval travel =
        Interval(parallelSense(machine.leg(0), leg)) * (leg.limits + driveRange(machine.enclosed(i), slope));
    along = intersection(along, dot(e, machine.center(i)) + travel);
  }
  if (along.isEmpty())
    return { Eigen::Vector3d::Constant(INF), Eigen::Vector3d::Constant(-INF) };
  if (!along.isBounded())
    return EVERYWHERE;
  const IntervalVector q = outerBound(machine.enclosed(0), slope).offsets();
  return boundingBox(machine.center(0) + q + (along - dot(e, machine.center(0))) * e);
}
}  // namespace

std::optional<Interval> steepest(const Machine& machine, const Criterion& criterion)
{
  return steepestOf(machine, criterion, static_cast<Conditions<double>*>(nullptr));
}

std::array<Interval, 3> limitsThatBind(const Machine& machine, const Criterion& criterion)
{
  std::array<Interval, 3> binding = { Interval::entire(), Interval::entire(), Interval::entire() };
  if (!criterion.joint_limits || !machine.hasJointLimits())
    return binding;
  const OuterBounds outer(machine, criterion);
  for (int i = 0; i < 3; ++i)
  {
    const Interval& limits = machine.leg(i).limits;
    const Interval range = outer.jointRange(i);
    binding[static_cast<std::size_t>(i)] = { range.lower() >= limits.lower() ? -INF : limits.lower(),
                                             range.upper() <= limits.upper() ? INF : limits.upper() };
  }
  return binding;
}

Box boundsOfSet(const Machine& machine, const Criterion& criterion)
{
  Box bounds = OuterBounds(machine, criterion).box();
  const std::array<Interval, 3> limits = limitsThatBind(machine, criterion);
  for (int i = 0; i < 3; ++i)
  {
    const Leg& leg = machine.leg(i);
    const bool has_limits = limits[static_cast<std::size_t>(i)] != Interval::entire();
    if (has_limits || hasAngle(leg))
      bounds =
          intersection(bounds, boundsByLimits(machine, criterion, i, has_limits ? leg.limits : Interval::entire()));
  }
  for (const Zone& zone : criterion.zones)
    bounds = intersection(bounds, boundsOf(enclosed(zone, criterion.tool_radius)));
  const bool leaves_ends = !(bounds.upper - bounds.lower).allFinite();
  return leaves_ends && criterion.joint_limits && machine.hasParallelRails()
             ? intersection(bounds, boundsByLimitsTogether(machine, criterion))
             : bounds;
}

bool onlyJointsChangeAlongRails(const Machine& machine, const Criterion& criterion)
{
  return machine.hasParallelRails() &&
         std::all_of(criterion.zones.begin(), criterion.zones.end(), [&](const Zone& zone) {
           return runsAlong(enclosed(zone, criterion.tool_radius), directionOfRails(machine));
         });
}

bool slidesAlongRails(const Machine& machine, const Criterion& criterion)
{
  return onlyJointsChangeAlongRails(machine, criterion) && !(criterion.joint_limits && machine.hasJointLimits());
}

const IntervalVector& directionOfRails(const Machine& machine)
{
  return slidingStrut(machine.leg(0)).axis;
}

int mainAxisOfRails(const Machine& machine)
{
  int axis = 0;
  mid(directionOfRails(machine)).cwiseAbs().maxCoeff(&axis);
  return axis;
}

Box boundsAcrossRails(const Machine& machine, const Criterion& criterion, int axis, double level)
{
  Box bounds = EVERYWHERE;
  const auto k = static_cast<std::size_t>(axis);
  for (int i = 0; i < 3; ++i)
  {
    // one leg and the plane: t = (level - c_axis - q_axis) / e_axis
    const IntervalVector& e = slidingStrut(machine.leg(i)).axis;
    const IntervalVector q = outerBound(machine.enclosed(i), steepest(machine, criterion)).offsets();
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
