// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace pkm_workspace
{
/// Decimal texts of doubles whose error is zero or has a known sign, so that a proved bound stays one when it is
/// printed.

/// The largest number with @p decimals digits after the point that is not above @p value.
std::string roundedDown(double value, int decimals);
/// The smallest number with @p decimals digits after the point that is not below @p value.
std::string roundedUp(double value, int decimals);
/// The smallest number with @p digits significant digits that is not below @p value.
std::string significantAbove(double value, int digits);
/// 15 to 17 digits, as many as it takes to read back as exactly this double.
std::string exact(double value);
/// Significant digits: for values in floating point, of which nothing is proved.
std::string nearly(double value, int digits = 9);
/// "0.64386 to 0.64396": the lower end rounded down and the upper end rounded up, with decimalsFor() them.
std::string bracket(double lower, double upper);

/// Digits after the point that tell the two ends of a bracket apart; nine significant ones where it has no width, none
/// for 0.
int decimalsFor(double lower, double upper);
}  // namespace pkm_workspace
