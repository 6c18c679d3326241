// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <variant>

#include "pkm_workspace/machine/sliding_strut.h"

namespace pkm_workspace
{
// The kinds of legs there are: one row here and one file for each, which defines the functions below for it.

/// A leg as its machine gives it, in intervals; for affine forms; and in floating point.
using EnclosedLeg = std::variant<EnclosedStrut>;
template <class Real>
using LegOfForms = std::variant<StrutOfForms<Real>>;
template <class Real>
using PlainLeg = std::variant<PlainStrut<Real>>;

inline EnclosedLeg enclosedLeg(const Machine& machine, int leg)
{
  return enclosedStrut(machine, leg);
}

/// Calls the function with the leg as what it is. As std::visit(), whose exception must not be compiled for one
/// instruction set and kept by the linker for all.
template <std::size_t I = 0, class Function, class... Kinds>
inline decltype(auto) visitLeg(const Function& function, const std::variant<Kinds...>& leg)
{
  if constexpr (I + 1 < sizeof...(Kinds))
    if (leg.index() != I)
      return visitLeg<I + 1>(function, leg);
  return function(*std::get_if<I>(&leg));
}

template <class Real, class... Kinds>
LegOfForms<Real> ofForms(const std::variant<Kinds...>& leg)
{
  return visitLeg([](const auto& kind) -> LegOfForms<Real> { return ofForms<Real>(kind); }, leg);
}

template <class Real>
PlainLeg<Real> plain(const LegOfForms<Real>& leg)
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

/// The joint value q [m].
template <class... Kinds, class Points, class State>
inline auto jointOf(const std::variant<Kinds...>& leg, const Points& p, const State& state)
{
  return visitLeg([&](const auto& kind) { return jointOf(kind, p, state); }, leg);
}
}  // namespace pkm_workspace
