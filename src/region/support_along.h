// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>

#include "pkm_workspace/interval/interval.h"

namespace pkm_workspace
{
/// Encloses the largest n x over lower <= x <= upper, which hold 0, for every n of the enclosure.
inline Interval largestAlong(const Interval& n, double lower, double upper)
{
  const Interval first = n * Interval(lower);
  const Interval last = n * Interval(upper);
  return { std::max({ 0.0, first.lower(), last.lower() }), std::max({ 0.0, first.upper(), last.upper() }) };
}
}  // namespace pkm_workspace
