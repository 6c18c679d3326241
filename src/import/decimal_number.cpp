// SPDX-License-Identifier: BSD-3-Clause
#include "decimal_number.h"

#include <cctype>
#include <cmath>

#include "pkm_workspace/interval/decimal.h"

namespace pkm_workspace
{
namespace firmware
{
namespace
{
constexpr int MOST_DIGITS = 40;
constexpr int LARGEST_EXPONENT = 60;

bool isDigit(char c)
{
  return std::isdigit(static_cast<unsigned char>(c)) != 0;
}

/// Moves over a sign. @return whether it is a minus
bool takeSign(const std::string& text, std::size_t& at)
{
  if (at < text.size() && (text[at] == '+' || text[at] == '-'))
    return text[at++] == '-';
  return false;
}

/// Moves over digits and returns them.
std::string takeDigits(const std::string& text, std::size_t& at)
{
  const std::size_t begin = at;
  while (at < text.size() && isDigit(text[at]))
    ++at;
  return text.substr(begin, at - begin);
}
}  // namespace

std::optional<Decimal> Decimal::parse(const std::string& text)
{
  std::size_t at = 0;
  const bool negative = takeSign(text, at);
  const std::string whole = takeDigits(text, at);
  std::string fraction;
  if (at < text.size() && text[at] == '.')
    fraction = takeDigits(text, ++at);
  std::string digits = whole + fraction;
  if (digits.empty() || digits.size() > MOST_DIGITS)
    return std::nullopt;
  int exponent = 0;
  if (at < text.size() && (text[at] == 'e' || text[at] == 'E'))
  {
    const bool is_small = takeSign(text, ++at);
    const std::string power = takeDigits(text, at);
    if (power.empty() || power.size() > 3)
      return std::nullopt;
    exponent = is_small ? -std::stoi(power) : std::stoi(power);
  }
  if (at != text.size() || std::abs(exponent) > LARGEST_EXPONENT)
    return std::nullopt;
  digits.erase(0, std::min(digits.find_first_not_of('0'), digits.size() - 1));  // 010 would be an octal number
  Decimal number;
  number.mantissa_ = boost::multiprecision::checked_int1024_t(digits);
  if (negative)
    number.mantissa_ = -number.mantissa_;
  number.exponent_ = exponent - static_cast<int>(fraction.size());
  return number;
}

Decimal Decimal::operator-() const
{
  Decimal number = *this;
  number.mantissa_ = -mantissa_;
  return number;
}

Decimal operator+(const Decimal& a, const Decimal& b)
{
  const Decimal& fine = a.exponent_ < b.exponent_ ? a : b;
  const Decimal& coarse = a.exponent_ < b.exponent_ ? b : a;
  const auto power = static_cast<unsigned>(coarse.exponent_ - fine.exponent_);
  Decimal sum = fine;
  sum.mantissa_ += coarse.mantissa_ * boost::multiprecision::pow(boost::multiprecision::checked_int1024_t(10), power);
  return sum;
}

Decimal operator*(const Decimal& a, const Decimal& b)
{
  Decimal product;
  product.mantissa_ = a.mantissa_ * b.mantissa_;
  product.exponent_ = a.exponent_ + b.exponent_;
  return product;
}

double Decimal::nearest() const
{
  const double value = parseNumber(mantissa_.str() + "e" + std::to_string(exponent_)).value_or(0.0);
  return std::isfinite(value) ? value : 0.0;
}
}  // namespace firmware
}  // namespace pkm_workspace
