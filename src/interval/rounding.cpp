// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/interval/rounding.h"

#include <cmath>
#include <cstdint>
#include <cstring>

#include "subnormal.h"

namespace pkm_workspace
{
namespace rounding
{
namespace
{
constexpr double MAX = std::numeric_limits<double>::max();

/// Below this magnitude an error term may underflow: its sign is then taken from operands scaled by powers of two.
/// Where operands and result are above, nothing is subnormal on the way.
constexpr double SMALL = 0x1p-900;

bool isOrdinary(double x)
{
  return std::abs(x) >= SMALL && std::abs(x) <= MAX;
}

/// Subnormal numbers are not zero here, however this thread reads them.
bool isZero(double x)
{
  std::uint64_t bits;
  std::memcpy(&bits, &x, sizeof(bits));
  return bits << 1 == 0;
}

/// The rounded result and its neighbour on the side of the exact one. Signs of errors are as good as random: doubles of
/// one sign are in the order of their bits, so that no branch is needed.
/// @param error has the sign of (exact result - rounded result)
Bounds around(double rounded, double error)
{
  constexpr double LEAST = std::numeric_limits<double>::denorm_min();
  if (!SOUND)
    return { rounded, rounded };
  if (rounded == 0.0)
    return { error < 0.0 ? -LEAST : 0.0, error > 0.0 ? LEAST : 0.0 };
  std::int64_t bits;
  std::memcpy(&bits, &rounded, sizeof(bits));
  const std::int64_t upwards = bits < 0 ? -1 : 1;
  const std::int64_t lower_bits = bits - (error < 0.0 ? upwards : 0);
  const std::int64_t upper_bits = bits + (error > 0.0 ? upwards : 0);
  Bounds bounds;
  std::memcpy(&bounds.lower, &lower_bits, sizeof(bits));
  std::memcpy(&bounds.upper, &upper_bits, sizeof(bits));
  return bounds;
}

/// The sign of a * b - product for a product that is tiny, out of the operands' digits.
double tinyProductError(double a, double b, double product)
{
  int exponent_a = 0;
  int exponent_b = 0;
  const double digits_a = std::frexp(a, &exponent_a);
  const double digits_b = std::frexp(b, &exponent_b);
  return std::fma(digits_a, digits_b, -std::scalbn(product, -(exponent_a + exponent_b)));
}

/// The sign of a - quotient * b where a or the quotient is tiny, out of the operands' digits.
double tinyRemainder(double a, double b, double quotient)
{
  int exponent_a = 0;
  int exponent_b = 0;
  const double digits_a = std::frexp(a, &exponent_a);
  const double digits_b = std::frexp(b, &exponent_b);
  return std::fma(-std::scalbn(quotient, exponent_b - exponent_a), digits_b, digits_a);
}

/// For results that overflowed from finite operands.
Bounds overflowed(double rounded)
{
  return rounded > 0.0 ? Bounds{ MAX, INF } : Bounds{ -INF, -MAX };
}

/// For finite operands and a finite sum.
Bounds addFinite(double a, double b, double sum)
{
  const bool a_is_larger = std::abs(a) >= std::abs(b);
  const double larger = a_is_larger ? a : b;
  const double smaller = a_is_larger ? b : a;
  const double kept = sum - larger;  // exact in every mode
  return around(sum, smaller - kept);
}

Bounds addAny(double a, double b)
{
  const double sum = a + b;
  if (std::isinf(a) || std::isinf(b))
    return { sum, sum };
  return std::isinf(sum) ? overflowed(sum) : addFinite(a, b, sum);
}

Bounds multiplyAny(double a, double b)
{
  const double product = a * b;
  if (std::isinf(a) || std::isinf(b))
    return { product, product };
  if (std::isinf(product))
    return overflowed(product);
  const bool is_tiny = std::abs(product) < SMALL;
  return around(product, is_tiny ? tinyProductError(a, b, product) : std::fma(a, b, -product));
}

Bounds divideAny(double a, double b)
{
  const double quotient = a / b;
  if (std::isinf(a) || std::isinf(b))
    return { quotient, quotient };
  if (std::isinf(quotient))
    return overflowed(quotient);
  const bool is_tiny = std::abs(quotient) < SMALL || std::abs(a) < SMALL;
  const double remainder = is_tiny ? tinyRemainder(a, b, quotient) : std::fma(-quotient, b, a);
  return around(quotient, b > 0.0 ? remainder : -remainder);
}

Bounds squareRootAny(double a)
{
  if (std::isinf(a))
    return { a, a };
  const double root = std::sqrt(a);
  const int scale = a < SMALL ? 500 : 0;
  const double scaled_root = std::scalbn(root, scale);
  return around(root, std::fma(-scaled_root, scaled_root, std::scalbn(a, 2 * scale)));
}

/// By arithmetic as it is within keeping().
std::string defect()
{
  volatile double tiny = std::numeric_limits<double>::min();
  tiny = tiny / 2;
  if (tiny == 0.0)
    return "subnormal numbers are flushed to zero on this thread";
  volatile double third = 1.0 / 3.0;
  const Bounds bounds = multiply(third, third);
  if (!(bounds.lower < bounds.upper) || bounds.upper > std::nextafter(bounds.lower, INF))
    return "the enclosure of (1/3)^2 is not two neighbouring doubles";
  return "";
}
}  // namespace

Bounds add(double a, double b)
{
  const double sum = a + b;
  if ((isOrdinary(a) || isZero(a)) && (isOrdinary(b) || isZero(b)) && std::abs(sum) <= MAX)
    return addFinite(a, b, sum);
  return subnormal::keeping([&] { return addAny(a, b); });
}

Bounds multiply(double a, double b)
{
  if (isZero(a) || isZero(b))
    return { 0.0, 0.0 };
  const double product = a * b;
  if (isOrdinary(product))  // then both operands are finite
    return around(product, std::fma(a, b, -product));
  return subnormal::keeping([&] { return multiplyAny(a, b); });
}

Bounds divide(double a, double b)
{
  if (isZero(a))
    return { 0.0, 0.0 };
  if (isOrdinary(a) && isOrdinary(b) && isOrdinary(a / b))
    return divideAny(a, b);
  return subnormal::keeping([&] { return divideAny(a, b); });
}

Bounds squareRoot(double a)
{
  if (isZero(a))
    return { a, a };
  if (isOrdinary(a))
    return squareRootAny(a);
  return subnormal::keeping([&] { return squareRootAny(a); });
}

std::string selfTest()
{
  return subnormal::keeping(defect);
}
}  // namespace rounding
}  // namespace pkm_workspace
