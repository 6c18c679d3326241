// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <iosfwd>

#include "pkm_workspace/interval/rounding.h"

namespace pkm_workspace
{
/// A closed set of reals [lower, upper], possibly unbounded, or the empty set.
///
/// Guaranteed: every operation encloses the exact results for all members of its operands, in any rounding mode, and on
/// threads that flush subnormal numbers to zero (contains() and its like read them as zero there). For single numbers
/// the enclosure is the tightest that doubles allow. The empty set is reached only through empty() and intersection().
class Interval
{
public:
  Interval() : Interval(0.0) {}
  /// The single number @p value; implicit, because a double is an exact interval.
  /// @throws std::invalid_argument for NaN and infinities
  Interval(double value);
  /// A bound may be infinite where the set has no end.
  /// @throws std::invalid_argument when no real number lies between: lower > upper, NaN, or the same infinity twice
  Interval(double lower, double upper);

  static Interval empty();
  static Interval entire();

  double lower() const { return lower_; }
  double upper() const { return upper_; }
  bool isEmpty() const { return !(lower_ <= upper_); }
  bool isSingle() const { return lower_ == upper_; }
  bool isBounded() const;
  /// A double inside, near the middle; the set must be bounded and not empty.
  double mid() const;
  /// An upper bound of upper - lower.
  double width() const;
  /// An upper bound of the distance from mid() to either end.
  double radius() const;
  /// The largest absolute value inside.
  double magnitude() const;
  /// The smallest absolute value inside.
  double mignitude() const;

  bool contains(double value) const { return lower_ <= value && value <= upper_; }
  bool isSubsetOf(const Interval& other) const;
  bool intersects(const Interval& other) const;
  bool certainlyPositive() const { return lower_ > 0.0 && !isEmpty(); }
  bool certainlyNegative() const { return upper_ < 0.0 && !isEmpty(); }

  friend bool operator==(const Interval& a, const Interval& b);
  friend bool operator!=(const Interval& a, const Interval& b) { return !(a == b); }

private:
  struct Unchecked
  {
  };
  Interval(Unchecked, double lower, double upper) : lower_(lower), upper_(upper) {}

  double lower_;
  double upper_;
};

Interval operator-(const Interval& x);
Interval operator+(const Interval& x, const Interval& y);
Interval operator-(const Interval& x, const Interval& y);
Interval operator*(const Interval& x, const Interval& y);
/// @throws std::domain_error when y contains 0
Interval operator/(const Interval& x, const Interval& y);
inline Interval& operator+=(Interval& x, const Interval& y)
{
  return x = x + y;
}
inline Interval& operator-=(Interval& x, const Interval& y)
{
  return x = x - y;
}
inline Interval& operator*=(Interval& x, const Interval& y)
{
  return x = x * y;
}

/// { a^2 : a in x }; tighter than x * x.
Interval sqr(const Interval& x);
/// { sqrt(a) : a in x }. The domain is part of the answer: @throws std::domain_error when x reaches below 0
Interval sqrt(const Interval& x);
/// { sqrt(max(a, 0)) : a in x }.
Interval sqrtAboveZero(const Interval& x);
/// { |a| : a in x }.
Interval abs(const Interval& x);
/// { sin(a) : a in x }, { cos(a) : a in x } for a single angle a [rad]; correctly rounded by MPFR.
Interval sin(double angle);
Interval cos(double angle);
/// { acos(a) : a in x and in [-1, 1] } [rad]; empty where there is no such a. Correctly rounded by MPFR.
Interval acos(const Interval& x);

/// Encloses the angles of the directions (a, b), a in x and b in y, from -pi to pi [rad]; all where (0, 0) or the angle
/// pi is among them. Correctly rounded by MPFR.
Interval angleOf(const Interval& x, const Interval& y);

/// The two doubles that pi lies between.
Interval pi();

/// The smallest interval that holds both.
Interval hull(const Interval& x, const Interval& y);
/// What both hold; may be empty.
Interval intersection(const Interval& x, const Interval& y);

std::ostream& operator<<(std::ostream& stream, const Interval& x);
}  // namespace pkm_workspace
