// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <boost/multiprecision/mpfr.hpp>
#include <cmath>
#include <limits>

namespace pkm_workspace
{
/// All real numbers within radius of middle: arithmetic with some forty digits, for checking what others have proved.
/// Guaranteed: if x and y are members of two balls, then x op y is a member of the result of op. Middles are rounded to
/// the nearest; their roundings are part of the radius, which is rounded up, whatever the processor's rounding mode.
/// What is computed without any rounding has the radius 0.
class Ball
{
public:
  using Middle = boost::multiprecision::number<
      boost::multiprecision::mpfr_float_backend<40, boost::multiprecision::allocate_stack>,
      boost::multiprecision::et_off>;

  Ball() = default;
  Ball(double x) : middle_(x) {}  // NOLINT: numbers are balls
  Ball(const Middle& middle, double radius) : middle_(middle), radius_(radius) {}
  /// All from one bound to the other.
  static Ball between(const Middle& lower, const Middle& upper)
  {
    if (!isfinite(lower) || !isfinite(upper))
      return { Middle(0), INFINITE };
    if (lower == upper)
      return { lower, 0.0 };
    const Middle middle = (lower + upper) / 2;
    return Ball(middle, std::max(magnitude(upper - middle), magnitude(middle - lower))).rounded(true);
  }

  const Middle& middle() const { return middle_; }
  double radius() const { return radius_; }
  /// The bounds, from outside.
  Middle lower() const { return middle_ - outwards(); }
  Middle upper() const { return middle_ + outwards(); }
  bool isPositive() const { return middle_ > outwards(); }
  bool isNegative() const { return middle_ < -outwards(); }
  /// No member's magnitude is larger.
  double most() const { return up(magnitude(middle_) + radius_); }

  /// All that is no further than @p distance >= 0 from a member.
  Ball widenedBy(double distance) const { return distance == 0.0 ? *this : Ball(middle_, up(radius_ + distance)); }

  friend Ball operator-(const Ball& a) { return { -a.middle_, a.radius_ }; }
  friend Ball operator+(const Ball& a, const Ball& b)
  {
    if (a.isZero() || b.isZero())
      return a.isZero() ? b : a;
    mpfr_clear_inexflag();
    const Middle sum = a.middle_ + b.middle_;
    const bool is_rounded = mpfr_inexflag_p() != 0;
    return Ball(sum, isExact(a, b) ? 0.0 : up(a.radius_ + b.radius_)).rounded(is_rounded);
  }
  friend Ball operator-(const Ball& a, const Ball& b) { return a + -b; }
  friend Ball operator*(const Ball& a, const Ball& b)
  {
    if ((a.isZero() && isfinite(b.middle_)) || (b.isZero() && isfinite(a.middle_)))  // most slopes are
      return {};
    mpfr_clear_inexflag();
    const Middle product = a.middle_ * b.middle_;
    const bool is_rounded = mpfr_inexflag_p() != 0;
    const double radius = isExact(a, b) ? 0.0 : up(magnitude(a.middle_) * b.radius_ + a.radius_ * b.most());
    return Ball(product, radius).rounded(is_rounded);
  }
  /// @pre no member of b is 0; otherwise the result is the whole line
  friend Ball operator/(const Ball& a, const Ball& b)
  {
    const Middle least = abs(b.middle_) - b.outwards();
    if (!(least > 0))
      return { Middle(0), INFINITE };
    const Middle quotient = a.middle_ / b.middle_;
    return Ball(quotient, up((a.radius_ + magnitude(quotient) * b.radius_) / down(least))).rounded(true);
  }
  /// The roots of those members that are not negative.
  friend Ball sqrt(const Ball& a)
  {
    if (!isfinite(a.middle_) || !(a.radius_ < INFINITE))
      return { Middle(0), INFINITE };
    const Middle lower = a.lower() > 0 ? sqrt(a.lower()) : Middle(0);
    const Middle upper = a.upper() > 0 ? sqrt(a.upper()) : Middle(0);
    return lower == upper && lower == 0 ? Ball() : between(lower, upper).rounded(true);
  }

private:
  static constexpr double INFINITE = std::numeric_limits<double>::infinity();
  /// More than the relative error of one operation on middles, of 138 bits.
  static constexpr double ROUNDOFF = 0x1p-130;
  /// More than what doubles lose where they underflow.
  static constexpr double TINY = 0x1p-1000;

  /// A sum of products of magnitudes, rounded up from any rounding.
  static double up(double x) { return x * (1.0 + 0x1p-40) + TINY; }
  static double down(const Middle& x) { return x.convert_to<double>() * (1.0 - 0x1p-40); }
  static double magnitude(const Middle& x) { return up(std::abs(x.convert_to<double>())); }

  bool isZero() const { return radius_ == 0.0 && middle_.is_zero(); }
  static bool isExact(const Ball& a, const Ball& b) { return a.radius_ == 0.0 && b.radius_ == 0.0; }

  /// Allows for the rounding of the middle.
  Ball rounded(bool is_rounded) const
  {
    return is_rounded ? Ball(middle_, up(radius_ + ROUNDOFF * magnitude(middle_))) : *this;
  }
  /// The radius, with the rounding of what it is added to.
  double outwards() const { return radius_ == 0.0 ? 0.0 : up(radius_ + ROUNDOFF * magnitude(middle_)); }

  Middle middle_ = 0;
  double radius_ = 0.0;
};
}  // namespace pkm_workspace
