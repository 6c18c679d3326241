// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/interval/decimal.h"

#include <locale.h>
#include <mpfr.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cerrno>
#include <cfenv>
#include <cfloat>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>

#include "subnormal.h"

namespace pkm_workspace
{
namespace
{
constexpr int SIGNIFICANT_DIGITS = 9;
constexpr int WIDTH_DIGITS = 3;
constexpr int DOUBLE_DIGITS = 17;

/// For as long as it lives, numbers of this thread have a point and no groups of digits, and are rounded to the
/// nearest.
class ClassicNumbers
{
public:
  ClassicNumbers() : locale_(uselocale(classic())), rounding_(std::fegetround()) { std::fesetround(FE_TONEAREST); }
  ClassicNumbers(const ClassicNumbers&) = delete;
  ClassicNumbers& operator=(const ClassicNumbers&) = delete;
  ~ClassicNumbers()
  {
    uselocale(locale_);
    std::fesetround(rounding_);
  }

private:
  static locale_t classic()
  {
    static const locale_t locale = newlocale(LC_ALL_MASK, "C", nullptr);
    return locale;
  }

  locale_t locale_;
  int rounding_;
};

/// @param format of MPFR, for the number of digits, the direction and the value
std::string written(const char* format, double value, int digits, mpfr_rnd_t direction)
{
  const ClassicNumbers classic;
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
  const ClassicNumbers classic;
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

std::string significantBelow(double value, int digits)
{
  return rounded("%.*R*g", value, digits, MPFR_RNDD);
}

std::string exact(double value)
{
  const double number = value + 0.0;  // -0 is 0
  const ClassicNumbers classic;
  for (int digits = std::abs(number) < DBL_MIN ? 1 : 15; digits < 17; ++digits)
  {
    const std::string text = significant(number, digits);
    if (std::strtod(text.c_str(), nullptr) == number)
      return text;
  }
  return significant(number, 17);
}

std::optional<double> parseNumber(const std::string& text)
{
  if (text.empty() || std::isspace(static_cast<unsigned char>(text[0])))
    return std::nullopt;
  const ClassicNumbers classic;
  char* end = nullptr;
  errno = 0;
  const double value = std::strtod(text.c_str(), &end);
  if (end != text.c_str() + text.size())
    return std::nullopt;
  return errno == ERANGE ? std::numeric_limits<double>::quiet_NaN() : value;
}

std::string nearly(double value, int digits)
{
  return significant(value + 0.0, digits);
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
  const double magnitude = std::isfinite(upper) ? std::max(std::abs(upper), std::abs(lower)) : std::abs(lower);
  if (!(magnitude > 0.0) || !std::isfinite(magnitude))
    return 0;
  const auto digitsOf = [](double value, int significant) {
    return significant - 1 - static_cast<int>(std::floor(std::log10(value)));
  };
  const int wanted = has_width ? digitsOf(width, WIDTH_DIGITS) : digitsOf(magnitude, SIGNIFICANT_DIGITS);
  return std::max(0, std::min(wanted, digitsOf(magnitude, DOUBLE_DIGITS)));
}
}  // namespace pkm_workspace
