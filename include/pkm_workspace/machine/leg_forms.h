// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <variant>

#include "pkm_workspace/machine/leg.h"
#include "pkm_workspace/machine/sliding_strut_forms.h"
#include "pkm_workspace/machine/tolerated_strut.h"

namespace pkm_workspace
{
/// A leg for affine forms, and in floating point: one row for each kind, and one file, which defines the functions
/// below for it. Where forms depend on parameters, it has tolerances.
template <class Real>
using LegOfForms =
    std::variant<std::conditional_t<ParametersOf<Real>::COUNT == 0, StrutOfForms<Real>, ToleratedStrut<Real>>>;
template <class Real>
using PlainLeg = std::variant<PlainStrut<Real>>;

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

/// n^2 [m^2].
template <class... Kinds>
inline decltype(auto) squaredRow(const std::variant<Kinds...>& leg)
{
  return visitLeg([](const auto& kind) -> decltype(auto) { return squaredRow(kind); }, leg);
}

/// n' . t - b' q', what n . t = b q' has in its derivative beside n . t' - b q''.
/// @param tangent t, the way of the tool, of length 1 @param speed q'
template <class Real, class... Kinds>
inline AffineForm<Real> turningOf(const std::variant<Kinds...>& leg, const AffineVector<Real>& tangent,
                                  const AffineForm<Real>& speed)
{
  return visitLeg([&](const auto& kind) { return turningOf(kind, tangent, speed); }, leg);
}

/// The joint value q [m].
template <class... Kinds, class Points, class State>
inline auto jointOf(const std::variant<Kinds...>& leg, const Points& p, const State& state)
{
  return visitLeg([&](const auto& kind) { return jointOf(kind, p, state); }, leg);
}
}  // namespace pkm_workspace
