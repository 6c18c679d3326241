// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "pkm_workspace/interval/affine_vector.h"
#include "pkm_workspace/interval/plain_vector.h"
#include "pkm_workspace/machine/leg_state.h"
#include "pkm_workspace/machine/limit_forms.h"
#include "pkm_workspace/machine/sliding_strut.h"

namespace pkm_workspace
{
// The formulas of a sliding strut, in every arithmetic.

template <class Real>
using StrutOfForms = StrutConstants<Enclosed<Real>, EnclosedVector<Real>, EnclosedMatrix<Real>, EnclosedMatrix<Real>>;
template <class Real>
using PlainStrut = StrutConstants<Real, PlainVector<Real>, PlainMatrix<Real>, PlainVector<Real>>;

/// For affine forms in a type Real.
template <class Real>
StrutOfForms<Real> ofForms(const EnclosedStrut& strut)
{
  return { EnclosedMatrix<Real>(strut.projector),
           EnclosedMatrix<Real>(IntervalMatrix{ strut.along, IntervalVector{}, IntervalVector{} }),
           EnclosedVector<Real>(strut.center),
           EnclosedVector<Real>(strut.axis),
           Enclosed<Real>(strut.squared_length),
           Enclosed<Real>(strut.sign) };
}
template <class Real, class Other>
StrutOfForms<Real> ofForms(const StrutOfForms<Other>& strut)
{
  return { EnclosedMatrix<Real>(strut.projector), EnclosedMatrix<Real>(strut.along),
           EnclosedVector<Real>(strut.center),    EnclosedVector<Real>(strut.axis),
           Enclosed<Real>(strut.squared_length),  Enclosed<Real>(strut.sign) };
}

/// Rounded: for finding points, not for proving anything.
template <class Real>
PlainStrut<Real> plain(const StrutOfForms<Real>& strut)
{
  return { strut.projector.value, strut.along.value[0],       strut.center.value,
           strut.axis.value,      strut.squared_length.value, strut.sign.value };
}

/// The leg as far as it goes without a root, where the tool stands at the point or the points p:
/// q = (I - e e^T)(p - c), which becomes the row, and b^2 = L^2 - |q|^2.
template <class... Constants, class Points, class State>
inline void evaluateAcross(const StrutConstants<Constants...>& strut, const Points& p, State& state)
{
  mapOffset(strut.projector, strut.center, p, state.row);
  state.squared_drive = strut.squared_length - squaredNorm(state.row);
}

/// The whole leg: b = eta = s sqrt(b^2), and n is the strut d = q + eta e.
/// @param root the arithmetic's square root, which settles what becomes of negative numbers
template <class... Constants, class Points, class Root, class State>
inline void evaluate(const StrutConstants<Constants...>& strut, const Points& p, const Root& root, State& state)
{
  evaluateAcross(strut, p, state);
  state.drive = strut.sign * root(state.squared_drive);
  addAlong(state.row, state.drive, strut.axis);
}

/// drive b^2 + row n^2, where n^2 = L^2.
template <class... Constants, class State, class Drive, class Row>
inline auto weighed(const StrutConstants<Constants...>& strut, const State& state, const Drive& drive, const Row& row)
{
  return drive * state.squared_drive + row * strut.squared_length;
}

/// n^2. @param squared_drive b^2
template <class Number, class... Constants>
inline const Number& squaredRow(const StrutConstants<Number, Constants...>& strut, const Number& /*squared_drive*/)
{
  return strut.squared_length;
}

/// The joint value rho = e . (p - c) - eta [m].
template <class... Constants, class Points, class State>
inline auto jointOf(const StrutConstants<Constants...>& strut, const Points& p, const State& state)
{
  return dotOffset(strut.along, strut.center, p) - state.drive;
}

/// How far the joint value is on the right side of a limit [m].
template <class... Constants, class Real, class Points, class State>
inline auto limitForm(const StrutConstants<Constants...>& strut, const Points& p, const State& state,
                      const JointLimit<Real>& limit)
{
  return fromLimit(jointOf(strut, p, state), limit);
}

/// n' . t - b' q', where the tool moves along t and the joint by q' for each metre of its way: n' = t - q' e and
/// b' = e . n', so it is |t - q' e|^2.
template <class Real, class Points, class State>
inline AffineForm<Real> turningOf(const StrutOfForms<Real>& strut, const Points& /*p*/, const State& /*state*/,
                                  AffineVector<Real> tangent, const AffineForm<Real>& speed)
{
  addAlong(tangent, -speed, strut.axis);
  return dot(tangent, tangent);
}

/// The leg in floating point; near the ends of its reach no digits are lost.
/// @param p tool point [m] @return whether the leg reaches it
bool evaluateNear(const EnclosedStrut& strut, const Eigen::Vector3d& p, LegAtPoint& leg);
}  // namespace pkm_workspace
