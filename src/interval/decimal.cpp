// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/interval/decimal.h"

#include <mpfr.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "subnormal.h"

namespace pkm_workspace
{
namespace
{
constexpr int SIGNIFICANT_DIGITS = 9;

/// @param format of MPFR, for the number of digits, the direction and the value
std::string written(const char* format, double value, int digits, mpfr_rnd_t direction)
{
  mpfr_t number;
  mpfr_init2(number, 53);
  mpfr_set_d(number, value, MPFR_RNDN);  // exact: number has the digits of a double
  char* buffer = nullptr;
  mpfr_asprintf(&buffer, format, digits, direction, number);
  const std::string text = buffer;
  mpfr_free_str(buffer);
  mpfr_clear(number);
  return text;
}

std::string rounded(const char* format, double value, int digits, mpfr_rnd_t direction)
{
  return subnormal::keeping([&] { return written(format, value, digits, direction); });
}

std::string significant(double value, int digits)
{
  std::array<char, 40> buffer;
  std::snprintf(buffer.data(), buffer.size(), "%.*g", digits, value);
  return buffer.data();
}
}  // namespace

std::string roundedDown(double value, int decimals)
{
  return rounded("%.*R*f", value, decimals, MPFR_RNDD);
}

std::string roundedUp(double value, int decimals)
{
  return rounded("%.*R*f", value, decimals, MPFR_RNDU);
}

std::string significantAbove(double value, int digits)
{
  return rounded("%.*R*g", value, digits, MPFR_RNDU);
}

std::string exact(double value)
{
  for (int digits = 15; digits < 17; ++digits)
  {
    const std::string text = significant(value, digits);
    if (std::strtod(text.c_str(), nullptr) == value)
      return text;
  }
  return significant(value, 17);
}

std::string nearly(double value, int digits)
{
  return significant(value, digits);
}

std::string bracket(double lower, double upper)
{
  const int decimals = decimalsFor(lower, upper);
  return roundedDown(lower, decimals) + " to " + roundedUp(upper, decimals);
}

int decimalsFor(double lower, double upper)
{
  const double width = upper - lower;
  const bool has_width = width > 0.0 && std::isfinite(width);
  const double magnitude = std::isfinite(upper) ? std::abs(upper) : std::abs(lower);
  const double unit = has_width ? width / 10.0 : magnitude * std::pow(10.0, 1 - SIGNIFICANT_DIGITS);
  if (!(unit > 0.0))
    return 0;
  return static_cast<int>(std::max(0.0, std::min(std::ceil(-std::log10(unit)), 17.0)));
}
}  // namespace pkm_workspace
