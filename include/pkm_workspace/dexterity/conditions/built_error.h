// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cmath>

#include "pkm_workspace/dexterity/criterion.h"
#include "pkm_workspace/dexterity/pencil_forms.h"
#include "pkm_workspace/interval/enclosed_constants.h"
#include "pkm_workspace/machine/machine.h"
#include "pkm_workspace/machine/sliding_strut_forms.h"

namespace pkm_workspace
{
/// How far off the tool of a machine within tolerances may be from p, where a controller that takes it for the nominal
/// one believes it to be (docs/theory.md, errors of what was built). With the rows n_i of the nominal machine at p, the
/// tool of each machine is off by a dp with n_i . dp = y_i +- slack_i, and the y_i of all of them fill the box
/// |y_i| <= reach_i, as long as |dp| <= E. So all are within E where no y with |y_i| <= reach_i + slack_i is off by as
/// much, and their rows are regular there, for which reach_i + slack_i >= E off_i is enough.
///
/// A leg in numbers: reach_i = |b| drive + sum of sides_k |n . axis_k| + constant + |q_i| sine |q|, where q_i is the
/// joint value, off_i = E + spread + |q_i| turn, and slack_i = off_i^2 / 2 + |q_i| versine + rest.
struct BuiltLeg
{
  Enclosed<double> drive;                      ///< error and zero of the joint [m]
  std::array<Enclosed<double>, 3> sides;       ///< of both ends of the strut [m]
  std::array<EnclosedVector<double>, 3> axes;  ///< along these
  Enclosed<double> constant;                   ///< L times what balls and the length come to [m^2]
  Enclosed<double> sine;                       ///< of the tolerance of the direction
  double spread = 0.0;                         ///< what the slider point is off by at most [m]
  double turn = 0.0;                           ///< and for each metre of the joint
  double versine = 0.0;                        ///< L (1 - cos) of the direction [m]
  double rest = 0.0;                           ///< [m^2]
};

/// @param error of the joint [m]
BuiltLeg builtLeg(const SlidingStrut& strut, double error);

/// The longest A^-1 y, |y_i| <= reach_i.
Interval largestError(const Configuration& there, const IntervalVector& reach);
/// What a machine within tolerances is off by at most where the controller believes it to be at the point [m].
Interval errorOfBuilt(const Machine& machine, const Criterion& criterion, const Eigen::Vector3d& point);

/// The same in an arithmetic.
template <class Real>
class BuiltError
{
public:
  BuiltError(const Machine& machine, const Criterion& criterion)
    : largest_(criterion.position_error_max), per_square_(Interval(1.0) / sqr(Interval(largest_)))
  {
    for (std::size_t i = 0; i < 3; ++i)
    {
      SlidingStrut nominal = slidingStrut(machine.leg(static_cast<int>(i)));
      legs_[i] = builtLeg(nominal, criterion.joint_error_max[i]);
      nominal.tolerance = {};
      const EnclosedStrut constants = enclosed(nominal);
      struts_[i] = ofForms<Real>(constants);
      lengths_[i] = constants.length.upper();
    }
  }
  template <class Other>
  explicit BuiltError(const BuiltError<Other>& other)
    : largest_(other.largest_), per_square_(other.per_square_), legs_(other.legs_), lengths_(other.lengths_)
  {
    for (std::size_t i = 0; i < 3; ++i)
      struts_[i] = ofForms<Real>(other.struts_[i]);
  }

  /// The rows, and what they reach with their slack for the largest error that is asked for.
  struct Forms
  {
    SymmetricForms<Real> gram;              ///< [m^2]
    std::array<AffineForm<Real>, 3> reach;  ///< +- slack [m^2]
  };

  /// @param floors of b_i^2, as LegModels has them
  template <class Domain>
  Forms evaluate(const Domain& box, const std::array<Real, 3>& floors) const
  {
    Forms forms;
    MachineForms<Real> state;
    for (std::size_t i = 0; i < 3; ++i)
    {
      auto& leg = state.legs[i];
      evaluateAcross(struts_[i], box, leg);
      const AffineForm<Real> across = legs_[i].sine.value > 0.0 ? lengthOf(leg.row, lengths_[i]) : AffineForm<Real>();
      leg.drive = struts_[i].sign * sqrtAbove(leg.squared_drive, floors[i]);
      addAlong(leg.row, leg.drive, struts_[i].axis);
      forms.gram[i] = AffineForm<Real>() + struts_[i].squared_length;
      forms.reach[i] = reachOf(i, leg, across, [&] { return jointOf(struts_[i], box, leg); });
    }
    for (std::size_t i = 0; i < 3; ++i)
      forms.gram[3 + i] = dot(state.legs[(i + 1) % 3].row, state.legs[(i + 2) % 3].row);
    return forms;
  }

  /// 1 / E^2 [1/m^2].
  Enclosed<Real> perSquare() const { return Enclosed<Real>(per_square_); }

private:
  template <class>
  friend class BuiltError;

  static AffineForm<Real> magnitudeOf(const AffineForm<Real>& form) { return maximum(form, -form); }

  /// |v|, by sqrt(v^2 + m^2) - m <= |v| <= sqrt(v^2 + m^2): the root has a slope where v is 0.
  static AffineForm<Real> lengthOf(const AffineVector<Real>& v, double scale)
  {
    const double least = 1e-7 * scale;
    const AffineForm<Real> root =
        sqrtAbove(squaredNorm(v) + Enclosed<Real>(Real(least * least), Real(1e-15 * least * least)), Real(0));
    return root + Enclosed<Real>(Real(-0.5 * least), Real(0.5000001 * least));
  }

  /// @param across |q| @param jointOf gives the joint value
  template <class State, class Joint>
  AffineForm<Real> reachOf(std::size_t i, const State& leg, const AffineForm<Real>& across, const Joint& jointOf) const
  {
    const BuiltLeg& by = legs_[i];
    AffineForm<Real> reach = (Enclosed<Real>(by.drive) * struts_[i].sign) * leg.drive + Enclosed<Real>(by.constant);
    for (std::size_t k = 0; k < 3; ++k)
      if (by.sides[k].value > 0.0)
        reach = reach + Enclosed<Real>(by.sides[k]) * magnitudeOf(dot(EnclosedVector<Real>(by.axes[k]), leg.row));
    Real farthest(0);  // joint value, where it counts
    if (by.sine.value > 0.0)
    {
      const AffineForm<Real> joint = jointOf();
      reach = reach + Enclosed<Real>(by.sine) * (magnitudeOf(joint) * across);
      farthest = joint.magnitude() + joint.radius;
    }
    using std::max;
    const Real off = Real(largest_ + by.spread) + farthest * Real(by.turn);
    const Real slack = Real(0.5) * off * off + farthest * Real(by.versine) + Real(by.rest);
    const Real regular = max(Real(largest_) * off - slack - reach.lower(), Real(0));
    reach.radius = affine::widened(reach.radius + (slack + regular) * Real(1.0 + 0x1p-40), off * off, 8);
    return reach;
  }

  double largest_;  ///< E [m]
  Enclosed<double> per_square_;
  std::array<BuiltLeg, 3> legs_;
  std::array<StrutOfForms<Real>, 3> struts_;
  std::array<double, 3> lengths_;  ///< [m]
};
}  // namespace pkm_workspace
