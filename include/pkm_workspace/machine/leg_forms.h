// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <variant>

#include "pkm_workspace/machine/crank_forms.h"
#include "pkm_workspace/machine/leg.h"
#include "pkm_workspace/machine/sliding_strut_forms.h"
#include "pkm_workspace/machine/telescopic_strut_forms.h"
#include "pkm_workspace/machine/tolerated_strut.h"

namespace pkm_workspace
{
/// A leg for affine forms, and in floating point: one row for each kind, and one file, which defines the functions
/// below for it. Where forms depend on parameters, it has tolerances.
template <class Real>
using LegOfForms = std::conditional_t<ParametersOf<Real>::COUNT == 0,
                                      std::variant<StrutOfForms<Real>, TelescopeOfForms<Real>, CrankOfForms<Real>>,
                                      std::variant<ToleratedStrut<Real>>>;
template <class Real>
using PlainLeg = std::variant<PlainStrut<Real>, PlainTelescope<Real>, PlainCrank<Real>>;

template <class Real, class... Kinds>
LegOfForms<Real> ofForms(const std::variant<Kinds...>& leg)
{
  return visitLeg([](const auto& kind) -> LegOfForms<Real> { return ofForms<Real>(kind); }, leg);
}

template <class Real, class... Kinds>
PlainLeg<Real> plain(const std::variant<Kinds...>& leg)
{
  return visitLeg([](const auto& kind) -> PlainLeg<Real> { return plain(kind); }, leg);
}

/// Fills in the state of the leg where the tool stands at p, a point or a set of them.
/// @param root the arithmetic's square root, which settles what becomes of negative numbers
template <class... Kinds, class Points, class Root, class State>
inline void evaluate(const std::variant<Kinds...>& leg, const Points& p, const Root& root, State& state)
{
  visitLeg([&](const auto& kind) { evaluate(kind, p, root, state); }, leg);
}

/// The same, and the row to second order where the leg is a crank.
template <class Real, class Kind, class Points, class Root, class State>
inline void evaluate(const Kind& leg, const Points& p, const Root& root, State& state, QuadraticVector<Real>& row)
{
  evaluate(leg, p, root, state);
  row.linear = state.row;
}
template <class Real, class... Kinds, class Points, class Root, class State>
inline void evaluate(const std::variant<Kinds...>& leg, const Points& p, const Root& root, State& state,
                     QuadraticVector<Real>& row)
{
  visitLeg([&](const auto& kind) { evaluate(kind, p, root, state, row); }, leg);
}

/// drive b^2 + row n^2 [m^2], for two weights: numbers, or Zero, One and MinusOne (leg_state.h).
template <class... Kinds, class State, class Drive, class Row>
inline auto weighed(const std::variant<Kinds...>& leg, const State& state, const Drive& drive, const Row& row)
{
  return visitLeg([&](const auto& kind) { return weighed(kind, state, drive, row); }, leg);
}

/// n^2 [m^2]: a number, or an interval. @param squared_drive b^2 there
template <class... Kinds, class Number>
inline const Number& squaredRow(const std::variant<Kinds...>& leg, const Number& squared_drive)
{
  return visitLeg([&](const auto& kind) -> const Number& { return squaredRow(kind, squared_drive); }, leg);
}

/// n' . t - b' q', what n . t = b q' has in its derivative beside n . t' - b q''.
/// @param tangent t, the way of the tool, of length 1 @param speed q', of an angle times its drive scale
template <class Real, class... Kinds, class Points, class State>
inline AffineForm<Real> turningOf(const std::variant<Kinds...>& leg, const Points& p, const State& state,
                                  const AffineVector<Real>& tangent, const AffineForm<Real>& speed)
{
  return visitLeg([&](const auto& kind) { return turningOf(kind, p, state, tangent, speed); }, leg);
}

/// Not negative where the joint value is on the right side of the limit, of an angle within pi of it [m].
template <class Real, class... Kinds, class Points, class State>
inline auto limitForm(const std::variant<Kinds...>& leg, const Points& p, const State& state,
                      const JointLimit<Real>& limit)
{
  return visitLeg([&](const auto& kind) { return limitForm(kind, p, state, limit); }, leg);
}

/// The joint value q [m], of an angle [rad].
template <class... Kinds, class Points, class State>
inline auto jointOf(const std::variant<Kinds...>& leg, const Points& p, const State& state)
{
  return visitLeg([&](const auto& kind) { return jointOf(kind, p, state); }, leg);
}
}  // namespace pkm_workspace
