// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/interval/interval.h"

#include <mpfr.h>

#include <algorithm>
#include <cmath>
#include <ostream>
#include <stdexcept>

#include "pkm_workspace/interval/decimal.h"
#include "pkm_workspace/interval/text_stream.h"
#include "subnormal.h"

namespace pkm_workspace
{
namespace
{
using subnormal::keeping;
using MpfrFunction = int (*)(mpfr_t, const mpfr_t, mpfr_rnd_t);

double evaluate(MpfrFunction function, double argument, mpfr_rnd_t direction)
{
  mpfr_t x;
  mpfr_init2(x, std::numeric_limits<double>::digits);
  mpfr_set_d(x, argument, MPFR_RNDN);  // exact: x has the digits of a double
  function(x, x, direction);
  const double value = mpfr_get_d(x, direction);
  mpfr_clear(x);
  return value;
}

Interval enclose(MpfrFunction function, double argument)
{
  return keeping(
      [&] { return Interval(evaluate(function, argument, MPFR_RNDD), evaluate(function, argument, MPFR_RNDU)); });
}

[[noreturn]] void throwDomainError(const char* operation, const Interval& operand, const char* reason)
{
  TextStream text;
  text << operation << operand << reason;
  throw std::domain_error(text.str());
}
}  // namespace

Interval::Interval(double value) : Interval(value, value) {}

Interval::Interval(double lower, double upper) : lower_(lower), upper_(upper)
{
  if (lower <= upper && lower < INF && upper > -INF)
    return;
  TextStream text;
  text << "an interval needs real numbers with lower <= upper, got [" << lower << ", " << upper << "]";
  throw std::invalid_argument(text.str());
}

Interval Interval::empty()
{
  return Interval(Unchecked{}, INF, -INF);
}

Interval Interval::entire()
{
  return Interval(-INF, INF);
}

bool Interval::isBounded() const
{
  return std::isfinite(lower_) && std::isfinite(upper_);
}

double Interval::mid() const
{
  return keeping([this] { return std::min(std::max(lower_ / 2 + upper_ / 2, lower_), upper_); });
}

double Interval::width() const
{
  return isEmpty() ? 0.0 : rounding::add(upper_, -lower_).upper;
}

double Interval::radius() const
{
  if (!isBounded())
    return isEmpty() ? 0.0 : INF;
  return keeping([this] {
    const double middle = mid();
    return std::max(rounding::add(upper_, -middle).upper, rounding::add(middle, -lower_).upper);
  });
}

double Interval::magnitude() const
{
  return keeping([this] { return std::max(std::abs(lower_), std::abs(upper_)); });
}

double Interval::mignitude() const
{
  return keeping([this] { return contains(0.0) ? 0.0 : std::min(std::abs(lower_), std::abs(upper_)); });
}

bool Interval::isSubsetOf(const Interval& other) const
{
  return keeping([&] { return isEmpty() || (other.lower_ <= lower_ && upper_ <= other.upper_); });
}

bool Interval::intersects(const Interval& other) const
{
  return keeping([&] { return !isEmpty() && !other.isEmpty() && lower_ <= other.upper_ && other.lower_ <= upper_; });
}

bool operator==(const Interval& a, const Interval& b)
{
  return keeping([&] { return (a.isEmpty() && b.isEmpty()) || (a.lower_ == b.lower_ && a.upper_ == b.upper_); });
}

Interval operator-(const Interval& x)
{
  return x.isEmpty() ? x : Interval(-x.upper(), -x.lower());
}

Interval operator+(const Interval& x, const Interval& y)
{
  if (x.isEmpty() || y.isEmpty())
    return Interval::empty();
  return Interval(rounding::add(x.lower(), y.lower()).lower, rounding::add(x.upper(), y.upper()).upper);
}

Interval operator-(const Interval& x, const Interval& y)
{
  return x + (-y);
}

namespace
{
/// x y for y >= 0.
Interval timesNotNegative(const Interval& x, const Interval& y)
{
  const double for_lower = x.lower() >= 0.0 ? y.lower() : y.upper();
  const double for_upper = x.upper() >= 0.0 ? y.upper() : y.lower();
  return Interval(rounding::multiply(x.lower(), for_lower).lower, rounding::multiply(x.upper(), for_upper).upper);
}

/// x y where both have members of either sign.
Interval timesBoth(const Interval& x, const Interval& y)
{
  return Interval(
      std::min(rounding::multiply(x.lower(), y.upper()).lower, rounding::multiply(x.upper(), y.lower()).lower),
      std::max(rounding::multiply(x.lower(), y.lower()).upper, rounding::multiply(x.upper(), y.upper()).upper));
}

Interval product(const Interval& x, const Interval& y)
{
  if (y.lower() < 0.0 && y.upper() > 0.0)
    return x.lower() >= 0.0 ? timesNotNegative(y, x) : x.upper() <= 0.0 ? timesNotNegative(-y, -x) : timesBoth(x, y);
  return y.lower() >= 0.0 ? timesNotNegative(x, y) : timesNotNegative(-x, -y);
}

Interval quotient(const Interval& x, const Interval& y)
{
  if (y.contains(0.0))
    throwDomainError("division by ", y, ", which contains 0");
  double lower = INF;
  double upper = -INF;
  for (const double numerator : { x.lower(), x.upper() })
    for (const double denominator : { y.lower(), y.upper() })
    {
      if (std::isinf(numerator) && std::isinf(denominator))
        continue;  // the limits with one finite end already reach from 0 to infinity
      const rounding::Bounds bounds = rounding::divide(numerator, denominator);
      lower = std::min(lower, bounds.lower);
      upper = std::max(upper, bounds.upper);
    }
  return Interval(lower, upper);
}

Interval square(const Interval& x)
{
  const double small = x.mignitude();
  const double large = x.magnitude();
  return Interval(std::max(0.0, rounding::multiply(small, small).lower), rounding::multiply(large, large).upper);
}

Interval squareRoot(const Interval& x)
{
  if (x.lower() < 0.0)
    throwDomainError("square root of ", x, ", which reaches below 0");
  return Interval(rounding::squareRoot(x.lower()).lower, rounding::squareRoot(x.upper()).upper);
}
}  // namespace

Interval operator*(const Interval& x, const Interval& y)
{
  return x.isEmpty() || y.isEmpty() ? Interval::empty() : keeping([&] { return product(x, y); });
}

Interval operator/(const Interval& x, const Interval& y)
{
  return x.isEmpty() || y.isEmpty() ? Interval::empty() : keeping([&] { return quotient(x, y); });
}

Interval sqr(const Interval& x)
{
  return x.isEmpty() ? x : keeping([&] { return square(x); });
}

Interval sqrt(const Interval& x)
{
  return x.isEmpty() ? x : keeping([&] { return squareRoot(x); });
}

Interval sqrtAboveZero(const Interval& x)
{
  return x.isEmpty()
             ? x
             : keeping([&] { return squareRoot(Interval(std::max(0.0, x.lower()), std::max(0.0, x.upper()))); });
}

Interval abs(const Interval& x)
{
  return x.isEmpty() ? x : Interval(x.mignitude(), x.magnitude());
}

Interval sin(double angle)
{
  return enclose(mpfr_sin, angle);
}

Interval cos(double angle)
{
  return enclose(mpfr_cos, angle);
}

Interval acos(const Interval& x)
{
  const Interval cosine = intersection(x, Interval(-1.0, 1.0));
  if (cosine.isEmpty())
    return cosine;
  return { enclose(mpfr_acos, cosine.upper()).lower(), enclose(mpfr_acos, cosine.lower()).upper() };
}

Interval pi()
{
  return { 0x1.921fb54442d18p+1, 0x1.921fb54442d19p+1 };
}

Interval hull(const Interval& x, const Interval& y)
{
  if (x.isEmpty() || y.isEmpty())
    return x.isEmpty() ? y : x;
  return keeping([&] { return Interval(std::min(x.lower(), y.lower()), std::max(x.upper(), y.upper())); });
}

Interval intersection(const Interval& x, const Interval& y)
{
  if (!x.intersects(y))
    return Interval::empty();
  return keeping([&] { return Interval(std::max(x.lower(), y.lower()), std::min(x.upper(), y.upper())); });
}

std::ostream& operator<<(std::ostream& stream, const Interval& x)
{
  if (x.isEmpty())
    return stream << "[empty]";
  return stream << '[' << exact(x.lower()) << ", " << exact(x.upper()) << ']';
}
}  // namespace pkm_workspace
