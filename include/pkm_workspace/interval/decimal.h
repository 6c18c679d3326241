// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

namespace pkm_workspace
{
/// Decimal texts of doubles whose error is zero or has a known sign, so that a proved bound stays one when it is
/// printed; with a point in any locale.

/// The largest number with @p decimals digits after the point that is not above @p value.
std::string roundedDown(double value, int decimals);
/// The smallest number with @p decimals digits after the point that is not below @p value.
std::string roundedUp(double value, int decimals);
/// The smallest number with @p digits significant digits that is not below @p value.
std::string significantAbove(double value, int digits);
/// The largest number with @p digits significant digits that is not above @p value.
std::string significantBelow(double value, int digits);
/// As people write it, 0.3: no more digits than it takes to read back as exactly this double. 0 has no sign.
std::string exact(double value);
/// The double nearest to the number that all of the text is, in any locale; NaN where no ordinary double is near
/// (1e999, 1e-400); nothing where it is not a number.
std::optional<double> parseNumber(const std::string& text);
/// Significant digits: for values in floating point, of which nothing is proved.
std::string nearly(double value, int digits = 9);
/// "0.643862 to 0.643964": the lower end rounded down and the upper end rounded up, with decimalsFor() them.
std::string bracket(double lower, double upper);

/// Digits after the point that show three significant digits of the width of a bracket; nine of its value where it has
/// no width, none for 0.
int decimalsFor(double lower, double upper);
}  // namespace pkm_workspace
