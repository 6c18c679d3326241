// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

#include "pkm_workspace/interval/interval_vector.h"
#include "pkm_workspace/region/shape.h"

namespace pkm_workspace
{
/// constant + cosine cos t + sine sin t + cosine2 cos 2t + sine2 sin 2t.
struct Trigonometric
{
  Interval constant, cosine, sine, cosine2, sine2;
};
using TrigonometricVector = std::array<Trigonometric, 3>;

// What a leg's formula needs of an arithmetic, for the points of a circle about the direction z.

/// M (p - c).
void mapOffset(const IntervalMatrix& m, const IntervalVector& c, const Circle& p, TrigonometricVector& image);
/// a . (p - c).
Trigonometric dotOffset(const IntervalVector& a, const IntervalVector& c, const Circle& p);
/// v . v. @pre v has no terms in 2t
Trigonometric squaredNorm(const TrigonometricVector& v);
Trigonometric operator-(const Interval& s, const Trigonometric& f);

/// Encloses the largest value of linear(t) - sqrt(radicand(t)) over all angles t, by bisection, highest upper bound
/// first: to the gap, unless the radicand comes so near to 0 that roundings are larger. Arcs are bounded to second
/// order, so that few of them stay near the largest value; their number is bounded.
/// @pre the radicand is nowhere negative @throws std::domain_error where it is seen to be
Interval largestOnCircle(const Trigonometric& linear, const Trigonometric& radicand, double gap);
}  // namespace pkm_workspace
