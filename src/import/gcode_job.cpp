// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/import/gcode_job.h"

#include <stdexcept>

#include "gcode_state.h"

namespace pkm_workspace
{
using gcode::Block;
using gcode::Effect;
using gcode::Group;
using gcode::NO_CODE;

GcodeJob::GcodeJob(const GcodeSetup& setup) : state_(std::make_unique<State>(setup)) {}

GcodeJob::~GcodeJob() = default;

std::optional<GcodeMove> GcodeJob::read(const std::string& line)
{
  return state_->read(line);
}

std::size_t GcodeJob::line() const
{
  return state_->line();
}

GcodeSummary GcodeJob::summary() const
{
  return state_->summary();
}

GcodeJob::State::State(const GcodeSetup& setup)
  : origin_(gcode::fromMetres(setup.origin)), rapids_have_feed_(setup.rapids_have_feed), offsets_(setup)
{
  if (!setup.start)
    return;
  place_ = gcode::difference(gcode::fromMetres(*setup.start), origin_);
  is_known_.fill(true);
}

std::optional<GcodeMove> GcodeJob::State::read(const std::string& line)
{
  ++lines_;
  const std::size_t begin = line.find_first_not_of(" \t\r");
  if (summary_.has_ended || begin == std::string::npos || line[begin] == '%')
    return std::nullopt;
  Block block(line);
  setFeed(block);
  setModes(block);
  const bool has_taken_axes = doOnce(block);
  const bool moves = block.hasAny("XYZIJKR") || block.code(Group::ONCE) == 530;
  if (has_taken_axes && block.code(Group::MOTION) != NO_CODE)
    throw std::invalid_argument("two codes of the line need its axes");
  std::optional<GcodeMove> made;
  if (moves && !has_taken_axes)
    made = move(block);
  count(block);
  block.requireAllTaken();
  if (block.effect() == Effect::LOSES)
    loseTool();
  summary_.has_ended = block.effect() == Effect::END;
  summary_.moves += made && made->kind != GcodeMove::Kind::POINT ? 1 : 0;
  return made;
}

void GcodeJob::State::setFeed(Block& block)
{
  const int mode = block.code(Group::FEED_MODE);
  const bool changes = mode != NO_CODE && (mode == 930) != has_inverse_time_;
  if (changes)
  {
    has_inverse_time_ = mode == 930;
    feed_.reset();
  }
  const int unit = block.code(Group::UNITS);
  const bool changes_unit = unit != NO_CODE && (unit == 200) != (unit_.factor == gcode::INCHES.factor);
  if (changes_unit && block.has('F'))
    throw std::invalid_argument(
        "whether F counts in the old unit or the new one is not agreed upon; write G20 or G21 in "
        "a line before");
  if (changes_unit)
  {
    unit_ = unit == 200 ? gcode::INCHES : gcode::MILLIMETRES;
    feed_.reset();
  }
  if (block.has('F') && !has_inverse_time_)
    feed_ = gcode::readExactly(block.take('F'), unit_);
  else if (block.has('F'))
    feed_ = gcode::readExactly(block.take('F'), gcode::PLAIN);
  if (feed_ && *feed_ < 0)
    throw std::invalid_argument("F must not be negative");
}

void GcodeJob::State::setModes(Block& block)
{
  const auto set = [&block](Group group, auto& mode, const auto& value) {
    if (block.code(group) != NO_CODE)
      mode = value(block.code(group));
  };
  set(Group::PLANE, plane_, [](int code) { return code; });
  set(Group::MOTION, motion_, [](int code) { return code == 800 ? NO_CODE : code; });
  set(Group::DISTANCE, is_relative_, [](int code) { return code == 910; });
  set(Group::ARC_DISTANCE, has_absolute_centers_, [](int code) { return code == 901; });
  offsets_.select(block);
  if (block.effect() != Effect::SPEED)
    return;
  if (!block.has('S') || gcode::readExactly(block.take('S'), gcode::PLAIN) != 100000000000)
    throw std::invalid_argument("M220 changes all feeds; only M220 S100 is read");
}

bool GcodeJob::State::doOnce(Block& block)
{
  const int code = block.code(Group::ONCE);
  if (code == 40)
    block.take('P');
  for (const int other : block.otherCodes())
    if (other == 640)
      for (const char letter : { 'P', 'Q' })
        block.take(letter);
  if (code == 100)
    offsets_.set(block, unit_);
  if (code == 920)
    shift(block);
  if (code == 921 || code == 922 || code == 923)
    offsets_.changeShift(code);
  const bool leaves = code == 280 || code == 290 || code == 300;
  if (leaves)
  {
    for (const char letter : { 'X', 'Y', 'Z' })
      block.take(letter);
    loseTool();
    ++summary_.unknown_moves;
    summary_.first_unknown = summary_.first_unknown == 0 ? lines_ : summary_.first_unknown;
  }
  return leaves || code == 100 || code == 920;
}

void GcodeJob::State::shift(Block& block)
{
  if (!block.hasAny("XYZE"))
    throw std::invalid_argument("G92 needs X, Y or Z");
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    if (!block.has(gcode::AXES[axis]))
      continue;
    if (!is_known_[axis])
      throw std::invalid_argument(std::string("G92 ") + gcode::AXES[axis] +
                                  " says where the program's zero is by the tool's place, which is not known here; "
                                  "give the offset of G54 and remove this");
    offsets_.shift(axis, place_[axis], gcode::readExactly(block.take(gcode::AXES[axis]), unit_));
  }
}

void GcodeJob::State::loseTool()
{
  is_known_.fill(false);
}

void GcodeJob::State::count(Block& block)
{
  for (const char letter : { 'E', 'N', 'S', 'T' })
  {
    ignored_letters_[static_cast<std::size_t>(letter - 'A')] += block.has(letter) ? 1 : 0;
    block.take(letter);
  }
  for (const int code : block.otherCodes())
    ++ignored_g_[code];
  for (const int code : block.machineCodes())
    ++ignored_m_[code];
  if (block.code(Group::ONCE) == 40)
    ++ignored_g_[40];
}

GcodeSummary GcodeJob::State::summary() const
{
  GcodeSummary summary = summary_;
  for (std::size_t k = 0; k < ignored_letters_.size(); ++k)
    if (ignored_letters_[k] > 0)
      summary.ignored[std::string(1, static_cast<char>('A' + static_cast<int>(k)))] = ignored_letters_[k];
  for (const auto& [code, count] : ignored_g_)
    summary.ignored[gcode::nameOf('G', code)] = count;
  for (const auto& [code, count] : ignored_m_)
    summary.ignored[gcode::nameOf('M', code)] = count;
  return summary;
}
}  // namespace pkm_workspace
