// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

#include "pkm_workspace/interval/interval.h"
#include "pkm_workspace/interval/rounding.h"

namespace pkm_workspace
{
/// What is known of a condition over the cube [-1, 1]^3 by two parallel planes: it holds at all points delta with
/// inner + gradient . delta >= 0, and at none with outer + gradient . delta < 0.
struct CubeCut
{
  std::array<double, 3> gradient;
  double inner;  ///< -INF where it is known to hold nowhere; INF where it is only known where it fails
  double outer;  ///< INF where it is known to fail nowhere
};

/// Encloses the share of the cube [-1, 1]^3 at whose points constant + slopes . delta >= 0, from 0 to 1.
Interval shareAbove(double constant, const std::array<double, 3>& slopes);

/// Encloses the share of the cube at whose points all conditions hold: 1 less what each of them may cut off, of planes
/// that are nearly one only once; and the least of what each one may leave.
Interval shareWithin(const CubeCut* cuts, std::size_t count);

/// Encloses that share of a measure; both are not negative.
inline Interval partOf(const Interval& measure, const Interval& share)
{
  constexpr double ROUNDING = 4.0 * (rounding::SOUND ? std::numeric_limits<double>::epsilon() : 0.0);
  const double lower = measure.lower() * share.lower();
  const double upper = measure.upper() * share.upper();
  const double least = upper > 0.0 ? rounding::underflow<double>() : 0.0;
  return { std::max(0.0, lower - ROUNDING * lower - least), upper + ROUNDING * upper + least };
}
}  // namespace pkm_workspace
