// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "pkm_workspace/interval/affine_vector.h"
#include "pkm_workspace/interval/plain_vector.h"
#include "pkm_workspace/machine/leg_state.h"
#include "pkm_workspace/machine/limit_forms.h"
#include "pkm_workspace/machine/telescopic_strut.h"

namespace pkm_workspace
{
// The formulas of a telescopic strut, in every arithmetic: x = p - c, n = x, b = |x|, and q is |x| less its length at
// joint value 0 (docs/theory.md).

template <class Real>
using TelescopeOfForms =
    TelescopicConstants<Enclosed<Real>, EnclosedVector<Real>, EnclosedMatrix<Real>, EnclosedMatrix<Real>>;
template <class Real>
using PlainTelescope = TelescopicConstants<Real, PlainVector<Real>, PlainMatrix<Real>, PlainVector<Real>>;

template <class Real>
TelescopeOfForms<Real> ofForms(const EnclosedTelescope& strut)
{
  return { EnclosedMatrix<Real>(strut.identity), EnclosedVector<Real>(strut.center), Enclosed<Real>(strut.length) };
}
template <class Real, class Other>
TelescopeOfForms<Real> ofForms(const TelescopeOfForms<Other>& strut)
{
  return { EnclosedMatrix<Real>(strut.identity), EnclosedVector<Real>(strut.center), Enclosed<Real>(strut.length) };
}
template <class Real>
PlainTelescope<Real> plain(const TelescopeOfForms<Real>& strut)
{
  return { strut.identity.value, strut.center.value, strut.length.value };
}

template <class... Constants, class Points, class Root, class State>
inline void evaluate(const TelescopicConstants<Constants...>& strut, const Points& p, const Root& root, State& state)
{
  mapOffset(strut.identity, strut.center, p, state.row);
  state.squared_drive = squaredNorm(state.row);
  state.drive = root(state.squared_drive);
}

/// n^2 = b^2: one form, whose errors count once.
template <class Real, class State, class Drive, class Row>
inline AffineForm<Real> weighed(const TelescopeOfForms<Real>& /*strut*/, const State& state, const Drive& drive,
                                const Row& row)
{
  return (weightOf<Real>(drive) + weightOf<Real>(row)) * state.squared_drive;
}

template <class Number, class... Constants>
inline const Number& squaredRow(const TelescopicConstants<Number, Constants...>& /*strut*/, const Number& squared_drive)
{
  return squared_drive;
}

template <class... Constants, class Points, class State>
inline auto jointOf(const TelescopicConstants<Constants...>& strut, const Points& /*p*/, const State& state)
{
  return state.drive + -strut.length;
}

template <class... Constants, class Real, class Points, class State>
inline auto limitForm(const TelescopicConstants<Constants...>& strut, const Points& p, const State& state,
                      const JointLimit<Real>& limit)
{
  return fromLimit(jointOf(strut, p, state), limit);
}

/// n' = t and b' = q': t^2 - q'^2.
template <class Real, class Points, class State>
inline AffineForm<Real> turningOf(const TelescopeOfForms<Real>& /*strut*/, const Points& /*p*/, const State& /*state*/,
                                  const AffineVector<Real>& tangent, const AffineForm<Real>& speed)
{
  return dot(tangent, tangent) - speed * speed;
}

/// The leg in floating point. @return true: it reaches every point
bool evaluateNear(const EnclosedTelescope& strut, const Eigen::Vector3d& p, LegAtPoint& leg);
}  // namespace pkm_workspace
