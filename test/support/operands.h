// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <ostream>
#include <utility>

#include "pkm_workspace/interval/interval.h"
#include "support/random.h"

namespace pkm_workspace
{
namespace test
{
/// Where the operands of a random case come from.
struct Spread
{
  enum Kind
  {
    ORDINARY,        ///< within +-10
    WHOLE,           ///< small integers: many results are exact
    CANCELLING,      ///< neighbours of each other or of each other's opposite
    WIDE,            ///< any exponent
    SUBNORMAL,       ///< below 2^-1000
    SMALL_PRODUCTS,  ///< products and quotients around the underflow of error terms
    LARGE            ///< near overflow
  };
  const char* name;
  Kind kind;
};

constexpr Spread SPREADS[] = {
  { "Ordinary", Spread::ORDINARY }, { "Whole", Spread::WHOLE },         { "Cancelling", Spread::CANCELLING },
  { "Wide", Spread::WIDE },         { "Subnormal", Spread::SUBNORMAL }, { "SmallProducts", Spread::SMALL_PRODUCTS },
  { "Large", Spread::LARGE }
};

inline std::ostream& operator<<(std::ostream& stream, const Spread& spread)
{
  return stream << spread.name;
}

/// Draws numbers and intervals of one spread.
class Operands
{
public:
  Operands(const Spread& spread, std::uint64_t seed) : kind_(spread.kind), random_(seed) {}

  double number()
  {
    if (random_.once(16))
      return landmark();
    switch (kind_)
    {
      case Spread::WHOLE:
        return random_.integer(-1000, 1000);
      case Spread::WIDE:
        return withExponent(-1074, 1023);
      case Spread::SUBNORMAL:
        return withExponent(-1074, -1000);
      case Spread::SMALL_PRODUCTS:
        return withExponent(-560, -340);
      case Spread::LARGE:
        return withExponent(500, 1023);
      default:
        return random_.uniform(-10.0, 10.0);
    }
  }

  /// A second operand for @p first.
  double partner(double first) { return kind_ == Spread::CANCELLING ? neighbour(random_.sign() * first) : number(); }

  /// A single number, a few neighbouring doubles, or a wide set; often with 0 inside.
  Interval interval() { return intervalAt(number()); }
  Interval partner(const Interval& first)
  {
    return intervalAt(partner(random_.once(2) ? first.lower() : first.upper()));
  }

  /// A number inside of the bounded @p x: an end, the middle, 0 or any other.
  double member(const Interval& x)
  {
    switch (random_.integer(0, 4))
    {
      case 0:
        return x.lower();
      case 1:
        return x.upper();
      case 2:
        return std::min(std::max(0.0, x.lower()), x.upper());
      default:
        const double t = random_.uniform(0.0, 1.0);
        return std::min(std::max((1.0 - t) * x.lower() + t * x.upper(), x.lower()), x.upper());
    }
  }

  /// A part of the bounded @p x.
  Interval part(const Interval& x)
  {
    const auto ends = std::minmax({ member(x), member(x) });
    return Interval(ends.first, ends.second);
  }

private:
  double withExponent(int lowest, int highest)
  {
    return random_.sign() * std::ldexp(random_.uniform(1.0, 2.0), random_.integer(lowest, highest));
  }

  double landmark()
  {
    using Limits = std::numeric_limits<double>;
    constexpr double VALUES[] = {
      0.0,      1.0,      0.5,     3.0,     1.0 + Limits::epsilon(), Limits::min(), Limits::denorm_min(),
      0x1p-900, 0x1p-450, 0x1p511, 0x1p512, Limits::max(),           0x1p1023,      1.0 / 3.0
    };
    return random_.sign() * VALUES[random_.integer(0, static_cast<int>(std::size(VALUES)) - 1)];
  }

  /// At most three doubles away from x, and finite.
  double neighbour(double x)
  {
    constexpr double MAX = std::numeric_limits<double>::max();
    const double toward = random_.sign() * MAX;
    for (int steps = random_.integer(0, 3); steps > 0; --steps)
      x = std::nextafter(x, toward);
    return x;
  }

  Interval intervalAt(double x)
  {
    const int width = random_.integer(0, 3);
    const double other = width == 0 ? x : width == 1 ? neighbour(x) : width == 2 ? number() : -x / 3.0;
    return hull(Interval(x), Interval(other));
  }

  Spread::Kind kind_;
  Random random_;
};
}  // namespace test
}  // namespace pkm_workspace
