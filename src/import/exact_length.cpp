// SPDX-License-Identifier: BSD-3-Clause
#include "exact_length.h"

#include <stdexcept>
#include <string>

#include "pkm_workspace/interval/decimal.h"

namespace pkm_workspace
{
namespace gcode
{
namespace
{
constexpr std::int64_t EXACT_IN_DOUBLE = std::int64_t(1) << 53;

std::int64_t powerOfTen(int exponent)
{
  std::int64_t power = 1;
  for (int k = 0; k < exponent; ++k)
    power *= 10;
  return power;
}

std::invalid_argument refusal(std::string_view text, const std::string& reason)
{
  return std::invalid_argument("'" + std::string(text) + "' " + reason);
}

/// Digits as one whole number, and how many of them stand behind the point.
class DigitReader
{
public:
  DigitReader(std::string_view text, const Unit& unit) : text_(text), unit_(unit) {}

  std::int64_t read()
  {
    const bool negative = !text_.empty() && text_[0] == '-';
    for (std::size_t at = negative || (!text_.empty() && text_[0] == '+') ? 1 : 0; at < text_.size(); ++at)
      if (text_[at] == '.' && !has_point_)
        has_point_ = true;
      else if (text_[at] >= '0' && text_[at] <= '9')
        take(text_[at] - '0');
      else
        throw refusal(text_, "is not a number: digits with a sign and a point are expected");
    if (count_ == 0)
      throw refusal(text_, "is not a number: it has no digits");
    const std::int64_t scale = unit_.factor * powerOfTen(unit_.decimals - decimals_);
    if (digits_ > MOST / scale)
      throw tooLarge();
    return (negative ? -digits_ : digits_) * scale;
  }

private:
  void take(int digit)
  {
    ++count_;
    if (has_point_ && decimals_ == unit_.decimals)
    {
      digits_ += !is_rounded_ && digit >= 5 ? 1 : 0;
      is_rounded_ = true;
      return;
    }
    if (digits_ > (MOST - digit) / 10)
      throw tooLarge();
    digits_ = 10 * digits_ + digit;
    decimals_ += has_point_ ? 1 : 0;
  }

  std::invalid_argument tooLarge() const
  {
    const std::int64_t most = MOST / powerOfTen(unit_.decimals) / unit_.factor;
    return refusal(text_, "is too large: at most " + std::to_string(most) + " " + unit_.name + " are read");
  }

  const std::string_view text_;
  const Unit& unit_;
  std::int64_t digits_ = 0;
  int decimals_ = 0;
  int count_ = 0;
  bool has_point_ = false;
  bool is_rounded_ = false;
};
}  // namespace

std::int64_t readExactly(std::string_view text, const Unit& unit)
{
  return DigitReader(text, unit).read();
}

double toMetres(std::int64_t femtometres)
{
  for (const int zeros : { 12, 9, 6, 3, 0 })
  {
    const std::int64_t power = powerOfTen(zeros);
    const std::int64_t rest = femtometres / power;
    if (rest * power == femtometres && rest <= EXACT_IN_DOUBLE && rest >= -EXACT_IN_DOUBLE)
      return static_cast<double>(rest) / static_cast<double>(powerOfTen(15 - zeros));  // both exact: rounded once
  }
  return parseNumber(std::to_string(femtometres) + "e-15").value_or(0.0);
}

Interval enclose(std::int64_t count)
{
  constexpr std::int64_t MILLION = 1000000;
  if (count <= EXACT_IN_DOUBLE && count >= -EXACT_IN_DOUBLE)
    return Interval(static_cast<double>(count));
  return Interval(static_cast<double>(count / MILLION)) * Interval(static_cast<double>(MILLION)) +
         Interval(static_cast<double>(count % MILLION));
}
}  // namespace gcode
}  // namespace pkm_workspace
