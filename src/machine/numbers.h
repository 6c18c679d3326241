// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <string>

#include "pkm_workspace/interval/interval_vector.h"

namespace pkm_workspace
{
/// Lengths of legs [m], and coordinates of their points: products of a dozen of them stay ordinary numbers.
constexpr double SHORTEST = 1e-9;
constexpr double LARGEST = 1e9;

inline bool isBounded(const IntervalVector& v)
{
  return v[0].isBounded() && v[1].isBounded() && v[2].isBounded();
}

inline bool isOrdinary(const IntervalVector& point)
{
  return std::all_of(point.begin(), point.end(), [](const Interval& x) { return x.magnitude() <= LARGEST; });
}

inline bool isOrdinaryLength(const Interval& length)
{
  return length.isBounded() && length.upper() >= SHORTEST && length.lower() <= LARGEST;
}

/// Angles that a crank may be counted from [rad].
constexpr double LARGEST_TURN = 100.0;

const IntervalMatrix UNIT_MATRIX = { IntervalVector{ 1.0, 0.0, 0.0 }, IntervalVector{ 0.0, 1.0, 0.0 },
                                     IntervalVector{ 0.0, 0.0, 1.0 } };

/// What is at the share t between two numbers: exact at both ends, and where both are the same.
Interval between(const Interval& first, const Interval& last, const Interval& t);
IntervalVector between(const IntervalVector& first, const IntervalVector& last, const Interval& t);

/// Both ends, digit by digit; -0 is 0.
std::string exactText(const Interval& x);
std::string exactText(const IntervalVector& v);
}  // namespace pkm_workspace
