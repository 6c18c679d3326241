// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>

namespace pkm_workspace
{
/// How many parameters forms in this type of number depend on, besides the three deltas of a box. None, but for types
/// that say otherwise: what a form says is then said of a machine as well as of a point, and its parameters, from -1 to
/// 1 like the deltas, are what is uncertain about the machine.
template <class Real>
struct ParametersOf
{
  static constexpr std::size_t COUNT = 0;
};

/// Deltas and parameters together: the length of a form's gradient, in which the deltas come first.
template <class Real>
constexpr std::size_t SYMBOLS = 3 + ParametersOf<Real>::COUNT;

/// One number for each of them.
template <class Real>
using Gradient = std::array<Real, SYMBOLS<Real>>;
}  // namespace pkm_workspace
