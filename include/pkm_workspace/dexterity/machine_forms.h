// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cmath>
#include <optional>

#include "pkm_workspace/interval/definiteness.h"
#include "pkm_workspace/machine/leg_forms.h"
#include "pkm_workspace/machine/machine.h"

namespace pkm_workspace
{
/// The three legs where the tool stands at p, in one arithmetic (docs/theory.md): A A^T has n_i^2 on its diagonal and
/// the dot products beside it, B^2 is diagonal.
template <class Number, class Vector>
struct MachineState
{
  std::array<LegState<Number, Vector>, 3> legs;
  std::array<Number, 3> gram;  ///< n_2 . n_3, n_1 . n_3, n_1 . n_2 [m^2]

  /// b_i^2 [m^2].
  std::array<Number, 3> squaredDrives() const
  {
    return { legs[0].squared_drive, legs[1].squared_drive, legs[2].squared_drive };
  }
};

/// Over one box: valid at every point of it where no b_i^2 is below its floor; b_i^2 itself is valid on the whole box.
template <class Real>
using MachineForms = MachineState<AffineForm<Real>, AffineVector<Real>>;

/// At one point, in floating point; b_i is 0 where b_i^2 is negative.
template <class Real>
using MachineNumbers = MachineState<Real, PlainVector<Real>>;

/// What forms need of the legs of a machine with tolerances.
using LegSpreads = std::array<StrutSpread, 3>;

/// The legs of a machine, prepared for evaluation. Real is double, a pack of doubles or a multi-precision type.
/// Thread-safe: constant after construction.
template <class Real>
class LegModels
{
public:
  /// @param steepest encloses the largest |n| / b that is asked for, or nothing
  LegModels(const Machine& machine, const std::optional<Interval>& steepest)
    : squared_scale_(machine.scale() * machine.scale())
  {
    for (std::size_t i = 0; i < 3; ++i)
    {
      const EnclosedLeg& leg = machine.enclosed(static_cast<int>(i));
      forms_[i] = ofForms<Real>(leg);
      numbers_[i] = plain<Real>(forms_[i]);
      scales_[i] = driveScale(machine.legs()[i]);
      has_cranks_ = has_cranks_ || std::holds_alternative<EnclosedCrank>(leg);
      if (steepest)
        floors_[i] = Real((pkm_workspace::squaredRow(leg, Interval(0.0)) / sqr(*steepest)).lower());
    }
  }

  /// The same in another type of number.
  template <class Other>
  explicit LegModels(const LegModels<Other>& other)
    : has_cranks_(other.has_cranks_), scales_(other.scales_), squared_scale_(other.squared_scale_)
  {
    for (std::size_t i = 0; i < 3; ++i)
    {
      forms_[i] = ofForms<Real>(other.forms_[i]);
      numbers_[i] = plain<Real>(forms_[i]);
      floors_[i] = Real(other.floors_[i]);
    }
  }

  /// The same in a type of number whose forms depend on the legs' parameters.
  /// @param spreads LegSpreads
  template <class Spreads>
  LegModels(const LegModels<double>& all, const Spreads& spreads)
    : scales_(all.scales_), squared_scale_(all.squared_scale_)
  {
    for (std::size_t i = 0; i < 3; ++i)
    {
      forms_[i] = tolerated<Real>(spreads[i], i);
      numbers_[i] = plain<Real>(forms_[i]);
      floors_[i] = Real(all.floors_[i]);
    }
  }

  /// Forms over the box, a CenteredBox or a SkewBox.
  template <class Domain>
  [[gnu::flatten]] MachineForms<Real> evaluate(const Domain& box) const
  {
    MachineForms<Real> forms;
    if (has_cranks_)
    {
      evaluateToSecondOrder(box, forms);
      return forms;
    }
    for (std::size_t i = 0; i < 3; ++i)
    {
      const auto root = [&floor = floors_[i]](const AffineForm<Real>& x) { return sqrtAbove(x, floor); };
      pkm_workspace::evaluate(forms_[i], box, root, forms.legs[i]);
    }
    multiplyRows(forms);
    return forms;
  }

  /// Numbers at the point p [m]: for finding points, not for proving anything.
  MachineNumbers<Real> evaluate(const PlainVector<Real>& p) const
  {
    using std::max;
    using std::sqrt;
    MachineNumbers<Real> numbers;
    for (std::size_t i = 0; i < 3; ++i)
      pkm_workspace::evaluate(
          numbers_[i], p, [](const Real& x) { return sqrt(max(x, Real(0))); }, numbers.legs[i]);
    multiplyRows(numbers);
    return numbers;
  }

  /// drive b_i^2 + row n_i^2 [m^2] over the box, for two weights: see weighed() of a leg.
  template <class Drive, class Row>
  AffineForm<Real> weighed(std::size_t leg, const MachineForms<Real>& forms, const Drive& drive, const Row& row) const
  {
    return pkm_workspace::weighed(forms_[leg], forms.legs[leg], drive, row);
  }
  /// n_i^2 [m^2] in floating point. @param squared_drive b_i^2 there [m^2]
  const Real& squaredRowNear(std::size_t leg, const Real& squared_drive) const
  {
    return pkm_workspace::squaredRow(numbers_[leg], squared_drive);
  }

  /// Where b_i^2 is below this [m^2] the criterion does not hold: n_i^2 / psi_max^2, rounded down, or 0.
  const Real& floor(std::size_t leg) const { return floors_[leg]; }

  /// The square of the longest strut [m^2]: makes margins comparable between machines.
  const Real& squaredScale() const { return squared_scale_; }

  /// The joint value q_i [m] over the box.
  template <class Domain>
  AffineForm<Real> joint(std::size_t leg, const MachineForms<Real>& forms, const Domain& box) const
  {
    return jointOf(forms_[leg], box, forms.legs[leg]);
  }
  /// n_i' . t - b_i' q_i' for the tangent t; see turningOf().
  template <class Domain>
  AffineForm<Real> turning(std::size_t leg, const MachineForms<Real>& forms, const Domain& box,
                           const AffineVector<Real>& tangent, const AffineForm<Real>& speed) const
  {
    return turningOf(forms_[leg], box, forms.legs[leg], tangent, speed);
  }
  /// A bound from above, or from below, of a joint's velocity [m/s], of an angle [rad/s], by one of that times its
  /// drive scale [m/s].
  Real rateAbove(std::size_t leg, const Real& bound) const { return rate(leg, bound, 1.0); }
  Real rateBelow(std::size_t leg, const Real& bound) const { return rate(leg, bound, -1.0); }

  /// How far a joint value is on the right side of a limit [m], over the box and in floating point: see limitForm().
  template <class Domain>
  AffineForm<Real> fromLimit(std::size_t leg, const MachineForms<Real>& forms, const Domain& box,
                             const JointLimit<Real>& limit) const
  {
    return limitForm(forms_[leg], box, forms.legs[leg], limit);
  }
  Real fromLimitNear(std::size_t leg, const MachineNumbers<Real>& numbers, const PlainVector<Real>& p,
                     const JointLimit<Real>& limit) const
  {
    return limitForm(numbers_[leg], p, numbers.legs[leg], limit);
  }

private:
  template <class>
  friend class LegModels;

  template <class Domain>
  [[gnu::noinline, gnu::flatten]] void evaluateToSecondOrder(const Domain& box, MachineForms<Real>& forms) const
  {
    std::array<QuadraticVector<Real>, 3> rows;
    for (std::size_t i = 0; i < 3; ++i)
    {
      const auto root = [&floor = floors_[i]](const AffineForm<Real>& x) { return sqrtAbove(x, floor); };
      pkm_workspace::evaluate(forms_[i], box, root, forms.legs[i], rows[i]);
    }
    forms.gram[0] = flat(product(rows[1], rows[2]));
    forms.gram[1] = flat(product(rows[0], rows[2]));
    forms.gram[2] = flat(product(rows[0], rows[1]));
  }

  template <class State>
  static void multiplyRows(State& state)
  {
    state.gram[0] = dot(state.legs[1].row, state.legs[2].row);
    state.gram[1] = dot(state.legs[0].row, state.legs[2].row);
    state.gram[2] = dot(state.legs[0].row, state.legs[1].row);
  }

  Real rate(std::size_t leg, const Real& bound, double side) const
  {
    if (scales_[leg] == Interval(1.0))
      return bound;
    const Interval per_scale = Interval(1.0) / scales_[leg];
    return bound * (Real(side > 0.0 ? per_scale.upper() : per_scale.lower()) *
                    (Real(1) + Real(4.0 * side) * rounding::roundoff<Real>()));
  }

  bool has_cranks_ = false;
  std::array<LegOfForms<Real>, 3> forms_;
  std::array<PlainLeg<Real>, 3> numbers_;
  std::array<Real, 3> floors_ = { Real(0), Real(0), Real(0) };
  std::array<Interval, 3> scales_;  ///< driveScale()
  Real squared_scale_;
};
}  // namespace pkm_workspace
