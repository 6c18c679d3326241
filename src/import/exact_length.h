// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string_view>

#include "pkm_workspace/interval/interval.h"

namespace pkm_workspace
{
namespace gcode
{
/// What one unit of a number is: factor * 10^-decimals of what is counted.
struct Unit
{
  std::int64_t factor;
  int decimals;
  const char* name;
};
/// Lengths are counted in femtometres, 1e-15 m: decimal millimetres and inches, their sums and differences are exact.
constexpr Unit MILLIMETRES = { 1, 12, "mm" };
constexpr Unit INCHES = { 254, 11, "inch" };
constexpr Unit METRES = { 1, 15, "m" };
/// Of anything else, in 1e-9.
constexpr Unit PLAIN = { 1, 9, "" };

/// The largest count that a number may have: 1000 m. Sums of nine of them stay within 64 bits.
constexpr std::int64_t MOST = 1000000000000000000;

/// Reads a sign, digits and a point; digits after the last one that the unit counts are rounded.
/// @throws std::invalid_argument where the text is no such number, or beyond MOST
std::int64_t readExactly(std::string_view text, const Unit& unit);
/// The double nearest to a number of femtometres [m].
double toMetres(std::int64_t femtometres);
/// Encloses the count, exactly where a double can.
Interval enclose(std::int64_t count);
}  // namespace gcode
}  // namespace pkm_workspace
