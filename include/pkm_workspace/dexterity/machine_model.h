// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <tuple>
#include <type_traits>

#include "pkm_workspace/dexterity/conditions/aspect_sign.h"
#include "pkm_workspace/dexterity/conditions/ball_tilt.h"
#include "pkm_workspace/dexterity/conditions/condition_number.h"
#include "pkm_workspace/dexterity/conditions/hinge_limits.h"
#include "pkm_workspace/dexterity/conditions/joint_limits.h"
#include "pkm_workspace/dexterity/conditions/largest_factor.h"
#include "pkm_workspace/dexterity/conditions/least_factor.h"
#include "pkm_workspace/dexterity/conditions/position_error.h"
#include "pkm_workspace/dexterity/conditions/reach.h"
#include "pkm_workspace/dexterity/conditions/stiffness.h"
#include "pkm_workspace/dexterity/conditions/strut_angle.h"
#include "pkm_workspace/dexterity/conditions/tool_force.h"
#include "pkm_workspace/dexterity/conditions/tool_speed.h"
#include "pkm_workspace/dexterity/conditions/zones.h"
#include "pkm_workspace/dexterity/workspace_bounds.h"

namespace pkm_workspace
{
/// The conditions of a criterion, in the order in which they are looked at: what costs least first, but the aspect
/// last, as a sign at one point counts only where the others keep det A from 0. A new one is a file of conditions/ and
/// an entry here.
template <class Real>
using Conditions =
    std::tuple<Reach<Real>, JointLimits<Real>, Zones<Real>, StrutAngle<Real>, BallTilt<Real>, HingeLimits<Real>,
               ToolSpeed<Real>, LargestFactor<Real>, LeastFactor<Real>, ConditionNumber<Real>, ToolForce<Real>,
               Stiffness<Real>, PositionError<Real>, AspectSign<Real>>;

/// The least steepest() of these conditions.
template <class... Each>
std::optional<Interval> steepestOf(const Machine& machine, const Criterion& criterion,
                                   const std::tuple<Each...>* /*conditions*/)
{
  std::optional<Interval> least;
  for (const std::optional<Interval>& each : { Each::steepest(machine, criterion)... })
    if (each && (!least || each->upper() < least->upper()))
      least = each;
  return least;
}

/// The criterion. @throws std::invalid_argument when it is not valid, or asks of this machine what cannot be proved
const Criterion& validated(const Machine& machine, const Criterion& criterion);

/// A machine and a criterion, prepared for the evaluation of boxes. Real is double, a pack of doubles or a
/// multi-precision type. Thread-safe: constant after construction.
template <class Real>
class MachineModel
{
public:
  /// @throws std::invalid_argument when the criterion is not valid
  MachineModel(const Machine& machine, const Criterion& criterion)
    : criterion_(validated(machine, criterion))
    , legs_(machine, steepest(machine, criterion))
    , conditions_(makeConditions(machine, criterion, static_cast<Conditions<Real>*>(nullptr)))
  {
    for (std::size_t axis = 0; onlyJointsChangeAlongRails(machine, criterion) && axis < 3; ++axis)
      if (abs(directionOfRails(machine)[axis]) == Interval(1.0))
        axis_of_rails_ = static_cast<int>(axis);
  }

  /// The same for another type of number.
  template <class Other>
  explicit MachineModel(const MachineModel<Other>& model)
    : criterion_(model.criterion_)
    , legs_(model.legs_)
    , conditions_(model.conditions_)
    , axis_of_rails_(model.axis_of_rails_)
  {}

  /// The same in a type of number whose forms depend on the parameters of a machine's legs.
  /// @param spreads LegSpreads
  template <class Spreads>
  MachineModel(const MachineModel<double>& all, const Spreads& spreads)
    : criterion_(all.criterion_), legs_(all.legs_, spreads), conditions_(all.conditions_)
  {}

  const Criterion& criterion() const { return criterion_; }
  const LegModels<Real>& legs() const { return legs_; }
  template <template <class> class Condition>
  const Condition<Real>& condition() const
  {
    return std::get<Condition<Real>>(conditions_);
  }
  /// The axis along which all rails are known to run, or -1: nothing but joint values changes along it.
  int axisOfRails() const { return axis_of_rails_; }

  /// Forms over the box, a CenteredBox or a SkewBox.
  template <class Domain>
  MachineForms<Real> evaluate(const Domain& box) const
  {
    return legs_.evaluate(box);
  }
  /// b_i^2 [m^2] over the box, which no point of the set has below the floor.
  const AffineForm<Real>& squaredDrive(const MachineForms<Real>& forms, std::size_t leg) const
  {
    return forms.legs[leg].squared_drive;
  }
  /// The box in the type of number that forms are made of.
  template <class Domain>
  static const Domain& lifted(const Domain& box)
  {
    return box;
  }
  const Real& floor(std::size_t leg) const { return legs_.floor(leg); }

  /// Tells the visitor the forms of all conditions over the box, until it is settled.
  template <class Domain, class Visitor>
  void visit(const MachineForms<Real>& forms, const Domain& box, Visitor& visitor) const
  {
    const Place<Real, Domain> place{ legs_, forms, box };
    std::apply(
        [&](const auto&... condition) {
          static_cast<void>((... && (condition.visit(place, visitor), !visitor.isSettled())));
        },
        conditions_);
  }

  /// The same for a criterion that bounds no factors: what it asks for are single forms.
  template <class Domain, class Visitor>
  void visitScalars(const MachineForms<Real>& forms, const Domain& box, Visitor& visitor) const
  {
    const Place<Real, Domain> place{ legs_, forms, box };
    std::apply([&](const auto&... condition) { (visitScalar(condition, place, visitor), ...); }, conditions_);
  }

  /// The least of all that the criterion wants not to be negative at the point p [m], without unit; floating point.
  Real margin(const PlainVector<Real>& p) const
  {
    using std::min;
    using std::sqrt;
    const MachineNumbers<Real> at = legs_.evaluate(p);
    const Real per_square = Real(1) / legs_.squaredScale();
    const NearPlace<Real> place{ legs_, at, p, sqrt(per_square), per_square };
    const Real reach = condition<Reach>().margin(place);
    Real least = reach;
    std::apply([&](const auto&... condition) { ((least = min(least, condition.margin(place))), ...); }, conditions_);
    return select(reach < Real(0), reach, least);  // beyond reach nothing else has a meaning
  }

private:
  template <class>
  friend class MachineModel;

  static_assert(std::is_same<std::tuple_element_t<std::tuple_size<Conditions<Real>>::value - 1, Conditions<Real>>,
                             AspectSign<Real>>::value,
                "the aspect is looked at last");

  template <class Condition, class Where, class Visitor>
  static void visitScalar(const Condition& condition, const Where& place, Visitor& visitor)
  {
    if constexpr (!Condition::BOUNDS_FACTORS)
      condition.visitScalar(place, visitor);
  }

  template <class... Each>
  static Conditions<Real> makeConditions(const Machine& machine, const Criterion& criterion, std::tuple<Each...>*)
  {
    return { Each(machine, criterion)... };
  }

  Criterion criterion_;
  LegModels<Real> legs_;
  Conditions<Real> conditions_;
  int axis_of_rails_ = -1;
};

// Once only: what is compiled for one instruction set must not be what the linker keeps for all.
extern template class LegModels<double>;
extern template class MachineModel<double>;
}  // namespace pkm_workspace
