// SPDX-License-Identifier: BSD-3-Clause
#include "canonical_moves.h"

#include <algorithm>
#include <cstdlib>
#include <stdexcept>

// LinuxCNC (LinuxCNC/linuxcnc): src/emc/sai/saicanon.cc prints the calls; what they mean is in
// src/emc/task/emccanon.cc: lengths are in the units of the last USE_LENGTH_UNITS, and a place of the program goes to
// R (place + G92) + G5X + tool length, where R turns about Z.

namespace pkm_workspace
{
namespace gcode
{
namespace
{
constexpr std::int64_t DIGIT_OF_MILLIMETRES = 100000000;  // femtometres in 1e-4 mm
constexpr std::int64_t DIGIT_OF_INCHES = 2540000000;
/// Sums of FARTHEST_PLACE and three of these stay within 64 bits.
constexpr std::int64_t LONGEST = 2050000000000000000;
}  // namespace

CanonicalMoves::CanonicalMoves(const GcodeSetup& setup)
  : origin_(fromMetres(setup.origin)), rapids_have_feed_(setup.rapids_have_feed), digit_(DIGIT_OF_MILLIMETRES)
{}

std::optional<GcodeMove> CanonicalMoves::read(const std::string& printed)
{
  const CanonicalCall call(printed);
  setLine(call);
  return (this->*actionOf(call))(call);
}

CanonicalMoves::Does CanonicalMoves::actionOf(const CanonicalCall& call)
{
  struct Row
  {
    std::string_view name;
    Does does;
  };
  static constexpr Row ROWS[] = {
    { "STRAIGHT_FEED", &CanonicalMoves::goStraight },
    { "STRAIGHT_TRAVERSE", &CanonicalMoves::goStraight },
    { "ARC_FEED", &CanonicalMoves::goRound },
    { "SET_FEED_RATE", &CanonicalMoves::setFeed },
    { "SET_FEED_MODE", &CanonicalMoves::setFeedMode },
    { "USE_LENGTH_UNITS", &CanonicalMoves::setUnits },
    { "SELECT_PLANE", &CanonicalMoves::setPlane },
    { "SET_G5X_OFFSET", &CanonicalMoves::setWorkOffset },
    { "SET_G92_OFFSET", &CanonicalMoves::setShift },
    { "SET_XY_ROTATION", &CanonicalMoves::setRotation },
    { "USE_TOOL_LENGTH_OFFSET", &CanonicalMoves::setTool },
    { "CHANGE_TOOL", &CanonicalMoves::changeTool },
    { "CHANGE_TOOL_NUMBER", &CanonicalMoves::changeTool },
    { "PROGRAM_END", &CanonicalMoves::end },
  };
  for (const Row& row : ROWS)
    if (row.name == call.name)
      return row.does;
  return effectOf(call.name) == CallEffect::UNKNOWN ? &CanonicalMoves::refuse : &CanonicalMoves::leave;
}

void CanonicalMoves::setLine(const CanonicalCall& call)
{
  if (!call.line)
    return;
  if (*call.line == SETUP_LINE && line_ != SETUP_LINE)
    throw std::invalid_argument("N0 is read, of a subroutine in another file; remove its words N");
  line_ = *call.line;
}

std::optional<GcodeMove> CanonicalMoves::leave(const CanonicalCall& call)
{
  if (line_ != SETUP_LINE && effectOf(call.name) == CallEffect::NONE)
    ++summary_.ignored[std::string(call.name)];
  return std::nullopt;
}

std::optional<GcodeMove> CanonicalMoves::refuse(const CanonicalCall& call)
{
  throw std::invalid_argument(call.whole() +
                              " is not among the calls of rs274 that are read, and may move the tool; docs/gcode.md "
                              "lists what is read");
}

std::optional<GcodeMove> CanonicalMoves::end(const CanonicalCall& /*call*/)
{
  summary_.has_ended = true;
  return std::nullopt;
}

std::optional<GcodeMove> CanonicalMoves::setUnits(const CanonicalCall& call)
{
  if (call.text != "CANON_UNITS_MM" && call.text != "CANON_UNITS_INCHES")
    throw call.unknownArguments();
  digit_ = call.text == "CANON_UNITS_MM" ? DIGIT_OF_MILLIMETRES : DIGIT_OF_INCHES;
  feed_ = 0;
  return std::nullopt;
}

std::optional<GcodeMove> CanonicalMoves::setPlane(const CanonicalCall& call)
{
  constexpr std::string_view PLANES[] = { "CANON_PLANE_YZ", "CANON_PLANE_XZ", "CANON_PLANE_XY" };  // by their normals
  const auto* const found = std::find(std::begin(PLANES), std::end(PLANES), call.text);
  if (found == std::end(PLANES))
    throw call.unknownArguments();
  normal_ = static_cast<std::size_t>(found - PLANES);
  return std::nullopt;
}

std::int64_t CanonicalMoves::lengthOf(std::string_view digits) const
{
  const std::int64_t count = readDigits(digits);
  if (std::abs(count) > LONGEST / digit_)
    throw std::invalid_argument("rs274 prints " + std::string(digits) + ", and lengths of up to 2050 m are read");
  return count * digit_;
}

Place CanonicalMoves::placeOf(const CanonicalCall& call, std::size_t first) const
{
  call.requireZeros(first + 3);
  return { lengthOf(call.arguments[first]), lengthOf(call.arguments[first + 1]), lengthOf(call.arguments[first + 2]) };
}

void CanonicalMoves::offset(Place& offset, const Place& to)
{
  for (std::size_t axis = 0; axis < 3; ++axis)
    printed_[axis] += offset[axis] - to[axis];
  offset = to;
}

std::optional<GcodeMove> CanonicalMoves::setWorkOffset(const CanonicalCall& call)
{
  call.requireArguments(7);  // the first one is the number of the work offset
  offset(work_, placeOf(call, 1));
  return std::nullopt;
}

std::optional<GcodeMove> CanonicalMoves::setShift(const CanonicalCall& call)
{
  call.requireArguments(6);
  offset(shift_, placeOf(call, 0));
  return std::nullopt;
}

std::optional<GcodeMove> CanonicalMoves::setTool(const CanonicalCall& call)
{
  call.requireArguments(9);
  tool_ = placeOf(call, 0);
  return std::nullopt;
}

/// The interpreter asks where the tool is, and rs274 answers with the numbers that it printed last, without what tool
/// lengths and G10 R have changed since. LinuxCNC has the right place there: so where the two differ, an axis is not
/// known until the job says it.
std::optional<GcodeMove> CanonicalMoves::changeTool(const CanonicalCall& /*call*/)
{
  believed_ = shifted(printed_);
  for (std::size_t axis = 0; axis < 3; ++axis)
    is_unsure_[axis] = is_unsure_[axis] || !isNear(believed_[axis], place_[axis]);
  return std::nullopt;
}

std::optional<GcodeMove> CanonicalMoves::setRotation(const CanonicalCall& call)
{
  call.requireArguments(1);
  rotation_ = readDigits(call.arguments[0]);
  return std::nullopt;
}

std::optional<GcodeMove> CanonicalMoves::setFeed(const CanonicalCall& call)
{
  call.requireArguments(1);
  feed_ = readDigits(call.arguments[0]);
  return std::nullopt;
}

std::optional<GcodeMove> CanonicalMoves::setFeedMode(const CanonicalCall& call)
{
  if (call.arguments.empty() || (call.arguments.back() != "0" && call.arguments.back() != "1"))
    throw call.unknownArguments();
  is_per_turn_ = call.arguments.back() == "1";
  return std::nullopt;
}
}  // namespace gcode

std::unique_ptr<MoveReader> canonicalMoves(const GcodeSetup& setup)
{
  return std::make_unique<gcode::CanonicalMoves>(setup);
}
}  // namespace pkm_workspace
