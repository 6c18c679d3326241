// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/Geometry>
#include <cmath>
#include <cstdlib>
#include <stdexcept>

#include "gcode_state.h"

namespace pkm_workspace
{
using gcode::Block;
using gcode::Group;
using gcode::Place;

namespace
{
std::size_t normalOf(int plane)
{
  return plane == 170 ? 2 : plane == 180 ? 1 : 0;
}

void requireWithin(const Place& place)
{
  for (std::size_t axis = 0; axis < 3; ++axis)
    if (place[axis] > gcode::MOST || place[axis] < -gcode::MOST)
      throw std::invalid_argument(std::string(1, gcode::AXES[axis]) + ": the tool goes farther than 1000 m");
}
}  // namespace

std::optional<GcodeMove> GcodeJob::State::move(Block& block)
{
  if (motion_ == gcode::NO_CODE)
    throw std::invalid_argument("no G0, G1, G2 or G3 is in effect");
  const bool is_arc = motion_ >= 20;
  const bool is_known_before = isKnown();
  std::array<bool, 3> is_known = is_known_;
  const Place end = target(block, is_known);
  requireWithin(end);
  GcodeMove move;
  move.is_rapid = motion_ == 0;
  setFeedOf(block, move);
  if (is_arc && !is_known_before)
    throw std::invalid_argument("an arc begins where the tool is, which is not known here");
  move.start = inRoot(place_);
  move.end = inRoot(end);
  if (is_arc)
    setArc(block, end, move);
  const bool stands = !is_arc && is_known_before && end == place_;
  place_ = end;
  is_known_ = is_known;
  if (stands)
    return std::nullopt;
  if (is_known_before)
    return move;
  ++summary_.unknown_moves;
  summary_.first_unknown = summary_.first_unknown == 0 ? lines_ : summary_.first_unknown;
  if (!isKnown())
    return std::nullopt;
  move.kind = GcodeMove::Kind::POINT;
  move.feed = GcodeMove::Feed::NONE;
  return move;
}

Place GcodeJob::State::target(Block& block, std::array<bool, 3>& is_known) const
{
  const bool has_machine_axes = block.code(Group::ONCE) == 530;
  if (has_machine_axes && (motion_ >= 20 || is_relative_))
    throw std::invalid_argument("G53 is read with G0 or G1 and with G90 only");
  Place end = place_;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    if (!block.has(gcode::AXES[axis]))
      continue;
    const std::int64_t number = gcode::readExactly(block.take(gcode::AXES[axis]), unit_);
    if (is_relative_)
      end[axis] += number;
    else
      end[axis] = number + (has_machine_axes ? 0 : offsets_.at(axis));
    is_known[axis] = is_known[axis] || !is_relative_;
  }
  return end;
}

void GcodeJob::State::setFeedOf(Block& block, GcodeMove& move) const
{
  if (motion_ == 0 && !rapids_have_feed_)
    return;
  if (has_inverse_time_ && !block.has('F'))
    throw std::invalid_argument("with G93 every move at feed needs an F in its line");
  if (!feed_ || *feed_ == 0)
    throw std::invalid_argument("no feed is in effect: an F > 0 is needed, after G20, G21, G93 and G94 a new one");
  move.feed = has_inverse_time_ ? GcodeMove::Feed::PER_TIME : GcodeMove::Feed::SPEED;
  move.feed_value = gcode::enclose(*feed_) / Interval(has_inverse_time_ ? 60e9 : 60e15);
}

void GcodeJob::State::setArc(Block& block, const Place& end, GcodeMove& move) const
{
  const std::size_t normal = normalOf(plane_);
  move.kind = GcodeMove::Kind::ARC;
  move.axis = Eigen::Vector3d::Zero();
  move.axis[static_cast<Eigen::Index>(normal)] = motion_ == 30 ? 1.0 : -1.0;
  if (block.has('P'))
    move.turns = gcode::readWhole('P', block.take('P'), 1, 1000);
  const std::size_t first = (normal + 1) % 3;
  const std::size_t second = (normal + 2) % 3;
  if (block.has('R') == block.hasAny("IJK"))
    throw std::invalid_argument("an arc needs its center by I, J, K or its radius by R, and not both");
  if (block.has('R') && end[first] == place_[first] && end[second] == place_[second])
    throw std::invalid_argument("an arc given by R must end beside its start; give the center of a full circle");
  if (block.has('R'))
    setCenterByRadius(block, normal, move);
  else
    setCenter(block, normal, move);
}

void GcodeJob::State::setCenter(Block& block, std::size_t normal, GcodeMove& move) const
{
  if (block.has(gcode::CENTERS[normal]))
    throw std::invalid_argument(std::string(1, gcode::CENTERS[normal]) + " is not an axis of the plane in effect (" +
                                gcode::nameOf('G', plane_) + ")");
  Place center = place_;
  for (const std::size_t axis : { (normal + 1) % 3, (normal + 2) % 3 })
  {
    const char letter = gcode::CENTERS[axis];
    if (!block.has(letter) && has_absolute_centers_)
      throw std::invalid_argument(std::string("with G90.1 an arc needs both numbers of its center; ") + letter +
                                  " is missing");
    if (!block.has(letter))
      continue;
    const std::int64_t number = gcode::readExactly(block.take(letter), unit_);
    center[axis] = number + (has_absolute_centers_ ? offsets_.at(axis) : place_[axis]);
  }
  requireWithin(center);
  move.center = inRoot(center);
}

/// The arc is no more than half a turn where R > 0, and no less where R < 0. Where R is less than half the way to the
/// end, the center is on that way, as far from the start as R says.
void GcodeJob::State::setCenterByRadius(Block& block, std::size_t normal, GcodeMove& move) const
{
  const double given = gcode::toMetres(gcode::readExactly(block.take('R'), unit_));
  const double radius = std::abs(given);
  const auto n = static_cast<Eigen::Index>(normal);
  Eigen::Vector3d chord = move.end - move.start;
  chord[n] = 0.0;
  const double half = 0.5 * chord.norm();
  const double height = std::sqrt(std::max(0.0, (radius - half) * (radius + half)));
  const Eigen::Vector3d along = chord / (2.0 * half);
  const Eigen::Vector3d aside = move.axis.cross(along);  // where the center of a short arc is
  move.center = move.start + std::min(half, radius) * along + (given < 0.0 ? -height : height) * aside;
}

Eigen::Vector3d GcodeJob::State::inRoot(const Place& place) const
{
  Eigen::Vector3d point;
  for (std::size_t axis = 0; axis < 3; ++axis)
    point[static_cast<Eigen::Index>(axis)] = gcode::toMetres(origin_[axis] + place[axis]);
  return point;
}
}  // namespace pkm_workspace
