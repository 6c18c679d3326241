// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <stdexcept>
#include <string>

#include "gcode_state.h"
#include "pkm_workspace/interval/decimal.h"

namespace pkm_workspace
{
namespace gcode
{
std::int64_t fromMetres(double metres)
{
  if (!(metres >= -1000.0 && metres <= 1000.0))
    throw std::invalid_argument(exact(metres) + " m must be from -1000 to 1000 m");
  const std::string text = exact(metres);
  const std::size_t digits = std::min(text.find('e'), text.size());
  const int decimals = METRES.decimals + (digits < text.size() ? std::stoi(text.substr(digits + 1)) : 0);
  return decimals < 0 ? 0 : readExactly(std::string_view(text).substr(0, digits), { 1, decimals, METRES.name });
}

Place fromMetres(const Eigen::Vector3d& metres)
{
  return { fromMetres(metres.x()), fromMetres(metres.y()), fromMetres(metres.z()) };
}

Place difference(const Place& a, const Place& b)
{
  return { a[0] - b[0], a[1] - b[1], a[2] - b[2] };
}

int readWhole(char letter, std::string_view number, int least, int most)
{
  const std::int64_t count = readExactly(number, PLAIN);
  constexpr std::int64_t ONE = 1000000000;
  if (count % ONE != 0 || count < least * ONE || count > most * ONE)
    throw std::invalid_argument(letter + std::string(number) + " must be a whole number from " + std::to_string(least) +
                                " to " + std::to_string(most));
  return static_cast<int>(count / ONE);
}

Offsets::Offsets(const GcodeSetup& setup)
{
  for (std::size_t k = 0; k < systems_.size(); ++k)
    systems_[k] = fromMetres(setup.work_offsets[k]);
  for (const auto& [number, length] : setup.tool_lengths)
    lengths_[number] = fromMetres(length);
}

void Offsets::select(Block& block)
{
  const int system = block.code(Group::SYSTEM);
  if (system != NO_CODE)
    system_ = static_cast<std::size_t>(system <= 590 ? (system - 540) / 10 : system - 585);
  const int length = block.code(Group::TOOL_LENGTH);
  if (length == 490)
    tool_ = 0;
  if (length != 430)
    return;
  if (!block.has('H'))
    throw std::invalid_argument(
        "G43 without H counts with the tool in the spindle, which is not known; write G43 H1 "
        "and give the length of tool 1");
  const int number = readWhole('H', block.take('H'), 0, 1000000);
  const auto found = lengths_.find(number);
  if (number != 0 && found == lengths_.end())
    throw std::invalid_argument("G43 H" + std::to_string(number) + ": the length of this tool is not given");
  tool_ = number == 0 ? 0 : found->second;
}

void Offsets::set(Block& block, const Unit& unit)
{
  if (!block.has('L'))
    throw std::invalid_argument("G10 without L is a retraction that may lift the tool; let the slicer write it as E");
  if (readWhole('L', block.take('L'), 0, 100) != 2 || !block.has('P') || block.has('R'))
    throw std::invalid_argument("of G10 only G10 L2 P1 to P9 with X, Y, Z is read");
  const auto index = static_cast<std::size_t>(readWhole('P', block.take('P'), 0, GcodeSetup::SYSTEMS));
  Place& system = systems_[index == 0 ? system_ : index - 1];
  for (std::size_t axis = 0; axis < 3; ++axis)
    if (block.has(AXES[axis]))
      system[axis] = readExactly(block.take(AXES[axis]), unit);
}

void Offsets::shift(std::size_t axis, std::int64_t place, std::int64_t coordinate)
{
  shift_[axis] = place - coordinate - (at(axis) - shift_[axis]);
  kept_shift_ = shift_;
}

void Offsets::changeShift(int code)
{
  if (code == 923)
    shift_ = kept_shift_;
  else
    shift_ = {};
  if (code == 921)
    kept_shift_ = {};
}
}  // namespace gcode
}  // namespace pkm_workspace
