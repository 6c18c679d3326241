// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

#include "pkm_workspace/dexterity/machine_forms.h"

namespace pkm_workspace
{
/// The kinds of conditions, as answers name them.
enum class ConditionKind
{
  REACH,               ///< |q|, the strut's offset across its rail, is at most its length [m]
  JOINT_LOWER,         ///< rho is at least its lower limit [m]
  JOINT_UPPER,         ///< rho is at most its upper limit [m]
  ASPECT,              ///< det A over the struts' lengths has the sign asked for
  PSI_MIN,             ///< the least velocity transmission factor
  PSI_MAX,             ///< the largest velocity transmission factor
  FORCE_MIN,           ///< the least force transmission factor
  FORCE_MAX,           ///< the largest force transmission factor
  KAPPA_MAX,           ///< the condition number of J
  TOOL_SPEED_MIN,      ///< the speed that a leg's joint allows the tool in every direction [m/s]
  TOOL_FORCE_MIN,      ///< the force that a leg's joint allows the tool in every direction [N]
  STIFFNESS_MIN,       ///< the least stiffness at the tool [N/m]
  POSITION_ERROR_MAX,  ///< the largest error of the tool's position [m]
  STRUT_ANGLE_MIN,     ///< the angle between a strut and its rail [rad]
  STRUT_ANGLE_MAX,     ///< the same [rad]
  BALL_TILT_MAX,       ///< the angle between a strut and the axis of a ball joint at its ends [rad]
  HINGE_LOWER,  ///< a passive hinge is at its lower limit or above: what its stop measures at the strut's end [m]
  HINGE_UPPER,  ///< a passive hinge is at its upper limit or below [m]
  KEEP_IN,      ///< the tool is within a zone: how far [m]
  KEEP_OUT,     ///< the tool is out of a zone: how far [m]
  // of a path that is gone along at a speed; no criterion asks for these at a point
  JOINT_SPEED = 64,   ///< |qdot| is at most what the joint reaches [m/s]
  JOINT_ACCELERATION  ///< |qddot| is at most what the joint reaches [m/s^2]
};

inline bool isRate(ConditionKind kind)
{
  return kind == ConditionKind::JOINT_SPEED || kind == ConditionKind::JOINT_ACCELERATION;
}

/// What a form is about.
struct Subject
{
  ConditionKind kind;
  std::size_t leg = 0;  ///< where the condition is about one leg
};

/// A box, and the legs over it, for conditions to ask about.
template <class Real, class Box>
struct Place
{
  const LegModels<Real>& legs;
  const MachineForms<Real>& forms;
  const Box& box;
};

/// A point, in floating point.
template <class Real>
struct NearPlace
{
  const LegModels<Real>& legs;
  const MachineNumbers<Real>& at;
  const PlainVector<Real>& p;
  Real per_length;  ///< 1 over the longest strut [1/m]
  Real per_square;  ///< its square
};

/// Forms of which one is enough, and no fewer.
template <class Real>
struct AlternativeForms
{
  std::array<AffineForm<Real>, 6> form;
  std::size_t count = 0;

  void add(const AffineForm<Real>& another) { form[count++] = another; }
  /// Encloses the largest of them all. @pre there is one
  AffineForm<Real> largest() const
  {
    AffineForm<Real> result = form[0];
    for (std::size_t k = 1; k < count; ++k)
      result = maximum(result, form[k]);
    return result;
  }
};

/// A number of joint velocities, forces or stiffnesses in terms of the drives' (docs/theory.md): of a joint value that
/// is a length it is the same.
template <class Real>
inline Enclosed<Real> scaled(const Enclosed<Real>& x, const Interval& scale)
{
  return scale == Interval(1.0) ? x : x * Enclosed<Real>(scale);
}

/// The margin of what is not asked for.
constexpr double NO_MARGIN = 1e300;

// Each file of conditions/ defines one condition of a criterion (docs/theory.md): a class template over the type of
// number, made of a machine and a criterion, or of itself in another type of number, with two functions, and with
// BOUNDS_FACTORS, whether it is one of those that Criterion::boundsFactors() tells of.
//
//   visit(place, visitor)  tells a visitor the forms whose signs decide on the box; nothing where it is not asked for.
//   A visitor that isSettled() hears no more.
//     scalar(subject, form, power)      the condition holds where the form, in m^power, is not negative
//     anyOf(subject, forms, power, enough())  it holds where any of the AlternativeForms is not negative, and nowhere
//                                       else; so it does where this form is positive
//     matrix(subject, form)             it holds where the matrix [m^2] is positive semidefinite
//     sufficient(form)                  it holds where all such matrices are, and maybe elsewhere
//     necessary(subject, u, v, form)    it holds nowhere where the form is negative, that it has by the vectors u and v
//     oneSigned(subject, at_center, form(), power)  it holds where the form is positive, which has no zero where the
//                                       conditions before it in the list hold
//     scalarOr(subject, form, power, exist, alternative())  as scalar; or all of the alternative forms are positive.
//                                       Where the first three are, the last one has the condition's sign, but for a set
//                                       without volume
//   visitScalar(place, visitor)  of conditions that bound no factors, the same in scalar() only
//   static steepest(machine, criterion)  encloses the largest |n_i| / b_i that it allows in any leg, or nothing
//   static tellLimits(at)  tells its limits at a point, by at.atLeast() and the like; none where it is about a number
//   that a criterion bounds, which its row in criterion_bounds.h encloses
//   margin(place)  how far the point is within the condition, without unit, in floating point
}  // namespace pkm_workspace
