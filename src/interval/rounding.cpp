// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/interval/rounding.h"

#include <cmath>

namespace pkm_workspace
{
namespace rounding
{
namespace
{
constexpr double MAX = std::numeric_limits<double>::max();
constexpr double INF = std::numeric_limits<double>::infinity();

/// Below this magnitude an error term may underflow, so its sign is not trusted.
constexpr double SMALL = 0x1p-900;

/// @param error has the sign of (exact result - rounded result)
Bounds around(double rounded, double error)
{
  if (!SOUND || error == 0.0)
    return { rounded, rounded };
  if (error > 0.0)
    return { rounded, std::nextafter(rounded, INF) };
  return { std::nextafter(rounded, -INF), rounded };
}

/// For results that are tiny: an enclosure that does not rest on an error term.
Bounds aroundTiny(double rounded)
{
  return SOUND ? Bounds{ rounded - SMALL, rounded + SMALL } : Bounds{ rounded, rounded };
}

/// For results that overflowed from finite operands.
Bounds overflowed(double rounded)
{
  return rounded > 0.0 ? Bounds{ MAX, INF } : Bounds{ -INF, -MAX };
}
}  // namespace

Bounds add(double a, double b)
{
  const double sum = a + b;
  if (std::isinf(a) || std::isinf(b))
    return { sum, sum };
  if (std::isinf(sum))
    return overflowed(sum);
  const bool a_is_larger = std::abs(a) >= std::abs(b);
  const double larger = a_is_larger ? a : b;
  const double smaller = a_is_larger ? b : a;
  const double kept = sum - larger;  // exact in every mode
  return around(sum, smaller - kept);
}

Bounds multiply(double a, double b)
{
  if (a == 0.0 || b == 0.0)
    return { 0.0, 0.0 };
  const double product = a * b;
  if (std::isinf(a) || std::isinf(b))
    return { product, product };
  if (std::isinf(product))
    return overflowed(product);
  if (std::abs(product) < SMALL)
    return aroundTiny(product);
  return around(product, std::fma(a, b, -product));
}

Bounds divide(double a, double b)
{
  if (a == 0.0)
    return { 0.0, 0.0 };
  const double quotient = a / b;
  if (std::isinf(a) || std::isinf(b))
    return { quotient, quotient };
  if (std::isinf(quotient))
    return overflowed(quotient);
  if (std::abs(quotient) < SMALL || std::abs(a) < SMALL)
    return { std::nextafter(quotient, -INF) - SMALL, std::nextafter(quotient, INF) + SMALL };
  const double remainder = std::fma(-quotient, b, a);
  return around(quotient, b > 0.0 ? remainder : -remainder);
}

Bounds squareRoot(double a)
{
  if (a == 0.0 || std::isinf(a))
    return { a, a };
  const double root = std::sqrt(a);
  if (a < SMALL)
    return { std::nextafter(root, 0.0), std::nextafter(root, INF) };
  return around(root, std::fma(-root, root, a));
}

std::string selfTest()
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
}  // namespace rounding
}  // namespace pkm_workspace
