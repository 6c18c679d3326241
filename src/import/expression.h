// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "decimal_number.h"

namespace pkm_workspace
{
namespace firmware
{
/// What an expression may name.
struct Names
{
  /// The number that a name stands for, or nothing where that cannot be decided.
  std::function<std::optional<Decimal>(const std::string& name)> value;
  /// The same of a function with what stands between its parentheses.
  std::function<std::optional<Decimal>(const std::string& name, const std::string& arguments)> call;
};

/// The number that an expression of numbers, names, + - * and, for conditions, ! && || and comparisons stands for;
/// nothing where it cannot be decided. Nothing else of C is evaluated.
std::optional<Decimal> evaluateExpression(const std::string& text, const Names& names);
}  // namespace firmware
}  // namespace pkm_workspace
