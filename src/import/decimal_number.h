// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <boost/multiprecision/cpp_int.hpp>
#include <optional>
#include <string>

namespace pkm_workspace
{
namespace firmware
{
/// An exact decimal number: what a file says in millimetres becomes the double that is nearest to it in metres.
/// Products of more than 300 digits throw std::overflow_error.
class Decimal
{
public:
  /// @param mantissa of mantissa * 10^exponent
  Decimal(long mantissa = 0, int exponent = 0) : mantissa_(mantissa), exponent_(exponent) {}

  /// Digits with a sign, a point and an exponent; nothing where the text is no such number.
  static std::optional<Decimal> parse(const std::string& text);

  Decimal operator-() const;
  friend Decimal operator+(const Decimal& a, const Decimal& b);
  friend Decimal operator-(const Decimal& a, const Decimal& b) { return a + -b; }
  friend Decimal operator*(const Decimal& a, const Decimal& b);
  friend bool operator<(const Decimal& a, const Decimal& b) { return (a - b).mantissa_ < 0; }
  friend bool operator==(const Decimal& a, const Decimal& b) { return (a - b).mantissa_ == 0; }

  /// The nearest double; 0 where no ordinary one is near.
  double nearest() const;

private:
  boost::multiprecision::checked_int1024_t mantissa_;
  int exponent_;
};
}  // namespace firmware
}  // namespace pkm_workspace
