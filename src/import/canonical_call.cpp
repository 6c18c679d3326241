// SPDX-License-Identifier: BSD-3-Clause
#include "canonical_call.h"

#include <charconv>
#include <stdexcept>

namespace pkm_workspace
{
namespace gcode
{
namespace
{
constexpr std::string_view DIGITS = "0123456789";
constexpr std::size_t MOST_LINE_DIGITS = 18;
constexpr std::size_t DIGITS_BEHIND_POINT = 4;
constexpr std::size_t MOST_DIGITS = 15;

/// Calls that do nothing to the path of the tool.
constexpr std::string_view WITHOUT_EFFECT =
    " CLEAR_AUX_OUTPUT_BIT CLEAR_MOTION_OUTPUT_BIT DISABLE_ADAPTIVE_FEED DISABLE_FEED_HOLD "
    "DISABLE_FEED_OVERRIDE DISABLE_SPEED_OVERRIDE DWELL ENABLE_FEED_HOLD ENABLE_FEED_OVERRIDE "
    "ENABLE_SPEED_OVERRIDE FINISH FLOOD_OFF FLOOD_ON LOG LOGAPPEND LOGCLOSE LOGOPEN MESSAGE MIST_OFF "
    "MIST_ON OPTIONAL_PROGRAM_STOP ORIENT_SPINDLE PROGRAM_STOP SELECT_POCKET SELECT_TOOL "
    "SET_AUX_OUTPUT_BIT SET_AUX_OUTPUT_VALUE SET_MOTION_CONTROL_MODE SET_MOTION_OUTPUT_BIT "
    "SET_MOTION_OUTPUT_VALUE SET_NAIVECAM_TOLERANCE SET_SPINDLE_MODE SET_SPINDLE_SPEED START_CHANGE "
    "START_SPINDLE_CLOCKWISE START_SPINDLE_COUNTERCLOCKWISE STOP_SPEED_FEED_SYNCH STOP_SPINDLE_TURNING "
    "TURN_PROBE_OFF TURN_PROBE_ON ";
constexpr std::string_view BY_ITSELF = " COMMENT ON_RESET SET_FEED_REFERENCE SET_TOOL_TABLE_ENTRY ";

bool isAmong(std::string_view names, std::string_view name)
{
  return names.find(" " + std::string(name) + " ") != std::string_view::npos;
}

std::invalid_argument unexpected(std::string_view printed)
{
  return std::invalid_argument("rs274 prints '" + std::string(printed.substr(0, 120)) +
                               "', which is not a call that this reader knows");
}

/// Moves over characters of a set. @return what was moved over
std::string_view takeAll(std::string_view& text, std::string_view characters)
{
  const std::size_t end = std::min(text.find_first_not_of(characters), text.size());
  const std::string_view taken = text.substr(0, end);
  text.remove_prefix(end);
  return taken;
}

/// The N word of the line, or dots where it has none. @return whether there is either
bool takeLine(std::string_view& text, std::optional<std::size_t>& line)
{
  if (text.empty() || text[0] != 'N')
    return false;
  text.remove_prefix(1);
  const std::string_view number = takeAll(text, DIGITS);
  if (number.empty())
    return !takeAll(text, ".").empty();
  line = 0;
  std::from_chars(number.data(), number.data() + number.size(), *line);
  return number.size() <= MOST_LINE_DIGITS;
}
}  // namespace

CanonicalCall::CanonicalCall(std::string_view printed)
{
  std::string_view rest = printed;
  takeAll(rest, " ");
  const bool has_number = !takeAll(rest, DIGITS).empty();
  takeAll(rest, " ");
  const bool has_line = takeLine(rest, line);
  takeAll(rest, " ");
  const std::size_t bracket = rest.find('(');
  const std::size_t end = rest.find_last_of(')');
  if (!has_number || !has_line || bracket == 0 || bracket == std::string_view::npos || end == std::string_view::npos ||
      end < bracket)
    throw unexpected(printed);
  name = rest.substr(0, bracket);
  text = rest.substr(bracket + 1, end - bracket - 1);
  for (std::string_view left = text; !left.empty();)
  {
    takeAll(left, ", ");
    const std::size_t size = std::min(left.find_first_of(", "), left.size());
    if (size > 0)
      arguments.push_back(left.substr(0, size));
    left.remove_prefix(size);
  }
}

void CanonicalCall::requireArguments(std::size_t count) const
{
  if (arguments.size() != count)
    throw unknownArguments();
}

void CanonicalCall::requireZeros(std::size_t first) const
{
  for (std::size_t k = first; k < arguments.size(); ++k)
    if (readDigits(arguments[k]) != 0)
      throw std::invalid_argument(whole() + " turns an axis: this machine has the axes X, Y and Z only");
}

std::invalid_argument CanonicalCall::unknownArguments() const
{
  return std::invalid_argument("rs274 prints " + whole() + ", whose arguments are not those that this reader knows");
}

CallEffect effectOf(std::string_view name)
{
  if (isAmong(WITHOUT_EFFECT, name))
    return CallEffect::NONE;
  return isAmong(BY_ITSELF, name) ? CallEffect::NOT_COUNTED : CallEffect::UNKNOWN;
}

std::int64_t readDigits(std::string_view text)
{
  std::string_view rest = text;
  const bool is_negative = !rest.empty() && rest[0] == '-';
  rest.remove_prefix(is_negative ? 1 : 0);
  std::string digits(takeAll(rest, DIGITS));
  const bool has_point = !digits.empty() && !rest.empty() && rest[0] == '.';
  rest.remove_prefix(has_point ? 1 : 0);
  const std::string_view behind = takeAll(rest, DIGITS);
  digits += behind;
  if (!has_point || behind.size() != DIGITS_BEHIND_POINT || !rest.empty() || digits.size() > MOST_DIGITS)
    throw std::invalid_argument("rs274 prints '" + std::string(text) +
                                "' where a number with four digits behind the point is expected");
  std::int64_t count = 0;
  std::from_chars(digits.data(), digits.data() + digits.size(), count);
  return is_negative ? -count : count;
}
}  // namespace gcode
}  // namespace pkm_workspace
