// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "pkm_workspace/interval/interval.h"

namespace pkm_workspace
{
/// An interval [lower, upper] of doubles, halved again and again: at depth n it has 2^n parts. Neighbours share a face,
/// and a face is the same double at every depth at which it is one.
class DyadicPartition
{
public:
  DyadicPartition() = default;
  DyadicPartition(double lower, double upper) : lower_(lower), upper_(upper), width_(upper - lower) {}

  /// A double next to the face number @p index = 0 ... 2^depth, within faceError() of where it is in real numbers.
  /// @param depth 0 ... 31
  double face(int depth, std::uint32_t index) const
  {
    if (index == std::uint32_t(1) << depth)
      return upper_;
    const double share = static_cast<double>(index) / parts(depth);  // exact: a power of two
    return std::min(std::max(lower_ + share * width_, lower_), upper_);
  }
  /// Encloses the length of every part at that depth, between faces that are doubles.
  Interval length(int depth) const
  {
    const Interval exact = (Interval(upper_) - Interval(lower_)) * Interval(std::ldexp(1.0, -depth));
    const Interval error(depth == 0 ? 0.0 : 2.0 * faceError());  // exact: a power of two
    const Interval enclosure = exact + hull(error, -error);
    return { std::max(0.0, enclosure.lower()), enclosure.upper() };
  }
  /// Its length at that depth as far as doubles tell it.
  double width(int depth) const { return std::ldexp(width_, -depth); }
  /// Whether the parts at that depth are far longer than their faces are uncertain.
  bool canDivide(int depth) const { return width(depth) > 64.0 * faceError(); }

private:
  static double parts(int depth) { return static_cast<double>(std::uint32_t(1) << depth); }
  /// Three roundings of numbers that are no larger than twice the larger bound.
  double faceError() const
  {
    const Interval magnitude(std::max(std::abs(lower_), std::abs(upper_)));
    return (Interval(8.0 * rounding::roundoff<double>()) * magnitude).upper();
  }

  double lower_ = 0.0;
  double upper_ = 0.0;
  double width_ = 0.0;
};
}  // namespace pkm_workspace
