// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <stdexcept>

#include "canonical_moves.h"

namespace pkm_workspace
{
namespace gcode
{
namespace
{
/// Two numbers may be printed of one length when they differ by no more than this, in last digits.
constexpr std::int64_t DIGITS_OF_ROUNDING = 2;
constexpr long double RADIANS_OF_DIGIT = 3.141592653589793238L / 180.0L / DIGITS_OF_ONE;
constexpr std::int64_t FARTHEST_PLACE = 3000000000000000000;

void requireReadable(const Place& place, std::int64_t most)
{
  for (std::size_t axis = 0; axis < 3; ++axis)
    if (std::abs(place[axis]) > most)
      throw std::invalid_argument(std::string(1, AXES[axis]) +
                                  ": the place of the tool is not known, or farther than 1000 m");
}

/// About Z, by an angle in units of the last digit of degrees.
Place turned(const Place& place, std::int64_t digits)
{
  if (digits == 0)
    return place;
  requireReadable(place, FARTHEST_PLACE);
  const long double angle = static_cast<long double>(digits) * RADIANS_OF_DIGIT;
  const auto x = static_cast<long double>(place[0]);
  const auto y = static_cast<long double>(place[1]);
  return { std::llround(x * std::cos(angle) - y * std::sin(angle)),
           std::llround(x * std::sin(angle) + y * std::cos(angle)), place[2] };
}

bool isTold(const Place& place)
{
  return std::all_of(place.begin(), place.end(), [](std::int64_t length) { return std::abs(length) <= MOST; });
}
}  // namespace

std::optional<GcodeMove> CanonicalMoves::goStraight(const CanonicalCall& call)
{
  call.requireArguments(6);
  GcodeMove move;
  move.is_rapid = call.name == "STRAIGHT_TRAVERSE";
  return go(placeOf(call, 0), move);
}

/// The arguments are along the two axes of the plane, in their order, and the third one.
std::optional<GcodeMove> CanonicalMoves::goRound(const CanonicalCall& call)
{
  call.requireArguments(9);
  const std::size_t first = (normal_ + 1) % 3;
  const std::size_t second = (normal_ + 2) % 3;
  call.requireZeros(6);
  Place to{};
  to[first] = lengthOf(call.arguments[0]);
  to[second] = lengthOf(call.arguments[1]);
  to[normal_] = lengthOf(call.arguments[5]);
  Place center = to;
  center[first] = lengthOf(call.arguments[2]);
  center[second] = lengthOf(call.arguments[3]);
  center = shifted(center);
  center[normal_] = place_[normal_];
  const int rotation = std::atoi(std::string(call.arguments[4]).c_str());
  if (rotation == 0 || std::abs(rotation) > 1000)
    throw call.unknownArguments();
  if (rotation_ != 0 && normal_ != 2)
    throw std::invalid_argument("an arc out of the plane XY is not read where G10 R has turned the coordinates");
  if (!isTold(center))
    throw std::invalid_argument("an arc begins where the tool is, which is not known here");
  GcodeMove move;
  move.kind = GcodeMove::Kind::ARC;
  move.center = inRoot(center);
  move.axis = Eigen::Vector3d::Zero();
  move.axis[static_cast<Eigen::Index>(normal_)] = rotation > 0 ? 1.0 : -1.0;
  move.turns = std::abs(rotation);
  return go(to, move);
}

Place CanonicalMoves::shifted(const Place& program) const
{
  const Place place = turned(difference(program, difference({}, shift_)), rotation_);
  return difference(place, difference(difference({}, work_), tool_));
}

bool CanonicalMoves::isNear(std::int64_t a, std::int64_t b) const
{
  return std::abs(a - b) <= DIGITS_OF_ROUNDING * digit_;
}

/// The program's coordinates of a place of the controller's.
Place CanonicalMoves::unshifted(const Place& place) const
{
  Place program = turned(difference(difference(place, work_), tool_), -rotation_);
  return difference(program, shift_);
}

/// A place that nobody said is far away. An axis that was unsure is known when it has another number than it would have
/// by itself.
void CanonicalMoves::moveTo(const Place& program)
{
  const Place by_itself = unshifted(believed_);
  place_ = believed_ = shifted(program);
  requireReadable(place_, FARTHEST_PLACE);
  printed_ = program;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    is_unsure_[axis] = is_unsure_[axis] && isNear(program[axis], by_itself[axis]);
    is_known_[axis] = std::abs(place_[axis]) <= MOST && !is_unsure_[axis];
  }
}

void CanonicalMoves::setFeedOf(GcodeMove& move) const
{
  if (move.is_rapid && !rapids_have_feed_)
    return;
  if (is_per_turn_)
    throw std::invalid_argument("a feed in units per turn of the spindle (G95) is not read");
  if (feed_ <= 0)
    throw std::invalid_argument("no feed is in effect: an F > 0 is needed, after G20, G21 and G94 a new one");
  const Interval count(static_cast<double>(feed_) - 0.5, static_cast<double>(feed_) + 0.5);  // as it was rounded
  move.feed = GcodeMove::Feed::SPEED;
  move.feed_value = count * Interval(static_cast<double>(digit_)) / Interval(60e15);
}

/// Ends that nearly coincide as they are printed may be those of a short arc or of one that is nearly a circle.
void CanonicalMoves::requireOneArc(const Place& from, const Place& to) const
{
  const std::size_t first = (normal_ + 1) % 3;
  const std::size_t second = (normal_ + 2) % 3;
  if (isNear(from[first], to[first]) && isNear(from[second], to[second]) &&
      !(from[first] == to[first] && from[second] == to[second]))
    throw std::invalid_argument(
        "the ends of this arc are so near to each other that the four digits which rs274 prints do not tell a short "
        "arc from a circle; let a circle end where it begins, and leave shorter arcs out");
}

std::optional<GcodeMove> CanonicalMoves::go(const Place& program, const GcodeMove& move)
{
  const Place from = place_;
  const bool was_known = isKnown();
  moveTo(program);
  if (line_ == SETUP_LINE)
    return std::nullopt;
  const bool is_arc = move.kind == GcodeMove::Kind::ARC;
  if (rotation_ != 0 && !(was_known && isKnown()))
    throw std::invalid_argument(
        "where G10 R has turned the coordinates, the place of the tool has to be known before: say where it is at "
        "first");
  if (is_arc && !(was_known && isKnown()))
    throw std::invalid_argument("an arc begins where the tool is, which is not known here");
  if (is_arc)
    requireOneArc(from, place_);
  return !is_arc && was_known && isKnown() && from == place_ ? std::nullopt : made(move, from, was_known);
}

std::optional<GcodeMove> CanonicalMoves::made(GcodeMove move, const Place& from, bool was_known)
{
  setFeedOf(move);
  if (was_known && isKnown())
  {
    move.start = inRoot(from);
    move.end = inRoot(place_);
    ++summary_.moves;
    return move;
  }
  ++summary_.unknown_moves;
  summary_.first_unknown = summary_.first_unknown == 0 ? line_ : summary_.first_unknown;
  if (!isKnown())
    return std::nullopt;
  move.end = inRoot(place_);
  move.kind = GcodeMove::Kind::POINT;
  move.feed = GcodeMove::Feed::NONE;
  return move;
}

Eigen::Vector3d CanonicalMoves::inRoot(const Place& place) const
{
  return { toMetres(origin_[0] + place[0]), toMetres(origin_[1] + place[1]), toMetres(origin_[2] + place[2]) };
}
}  // namespace gcode
}  // namespace pkm_workspace
