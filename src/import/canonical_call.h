// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace pkm_workspace
{
namespace gcode
{
/// One call of a canonical machining function as rs274 prints it: "   12 N5     STRAIGHT_FEED(1.0000, 2.0000, ...)".
struct CanonicalCall
{
  std::optional<std::size_t> line;          ///< of the job, by its word N
  std::string_view name;                    ///< "STRAIGHT_FEED"
  std::string_view text;                    ///< what stands in the brackets
  std::vector<std::string_view> arguments;  ///< the same, cut at commas and blanks

  /// @throws std::invalid_argument where the text is no such call
  explicit CanonicalCall(std::string_view printed);

  /// @throws std::invalid_argument where there are not so many
  void requireArguments(std::size_t count) const;
  /// Arguments from that one on are about axes that turn. @throws std::invalid_argument where one of them does
  void requireZeros(std::size_t first) const;
  std::invalid_argument unknownArguments() const;
  /// With its arguments.
  std::string whole() const { return std::string(name) + "(" + std::string(text) + ")"; }
};

/// What a call does to the path of the tool, if it is not read.
enum class CallEffect
{
  NONE,
  NOT_COUNTED,  ///< none; said by rs274 itself
  UNKNOWN
};
CallEffect effectOf(std::string_view name);

/// What the program prints of a number: four digits behind the point.
constexpr std::int64_t DIGITS_OF_ONE = 10000;
/// In units of the last digit. @throws std::invalid_argument where the text is no such number, or beyond 1e14 digits
std::int64_t readDigits(std::string_view text);
}  // namespace gcode
}  // namespace pkm_workspace
