// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/paving/box_tree.h"

#include <algorithm>
#include <stdexcept>

#include "pkm_workspace/interval/text_stream.h"

namespace pkm_workspace
{
namespace
{
/// Parts are counted in 32 bits.
constexpr int MOST_HALVINGS = 31;
}  // namespace

Bisection::Bisection(const Box& root, double resolution) : root_(root), halvings_({ { 0, 0, 0 } })
{
  for (std::size_t k = 0; k < 3; ++k)
    sides_[k] = DyadicPartition(root.lower[static_cast<int>(k)], root.upper[static_cast<int>(k)]);
  for (;;)
  {
    std::array<int, 3> counts = halvings_.back();
    std::size_t widest = 0;
    for (std::size_t k = 1; k < 3; ++k)
      if (sides_[k].width(counts[k]) > sides_[widest].width(counts[widest]))
        widest = k;
    if (sides_[widest].width(counts[widest]) <= resolution || !sides_[widest].canDivide(counts[widest]))
      return;
    if (++counts[widest] > MOST_HALVINGS)
    {
      TextStream text;
      text << "resolution = " << resolution << " m must be at least " << sides_[widest].width(MOST_HALVINGS)
           << " m: a side of the box can be halved " << MOST_HALVINGS << " times";
      throw std::invalid_argument(text.str());
    }
    axes_.push_back(static_cast<int>(widest));
    halvings_.push_back(counts);
  }
}

Box Bisection::box(const Cell& cell, std::size_t level) const
{
  const std::array<int, 3>& counts = halvings_[level];
  Box result;
  for (std::size_t k = 0; k < 3; ++k)
  {
    result.lower[static_cast<int>(k)] = sides_[k].face(counts[k], cell[k]);
    result.upper[static_cast<int>(k)] = sides_[k].face(counts[k], cell[k] + 1);
  }
  return result;
}

int Bisection::dimension() const
{
  return static_cast<int>(((root_.upper - root_.lower).array() > 0.0).count());
}

Interval Bisection::volume(std::size_t level) const
{
  Interval volume(dimension() > 0 ? 1.0 : 0.0);
  for (std::size_t k = 0; k < 3; ++k)
    if (sides_[k].width(0) > 0.0)
      volume *= sides_[k].length(halvings_[level][k]);
  return volume;
}

void BoxTree::addLevel(std::vector<CellState> states)
{
  StateCounts counts{};
  for (const CellState state : states)
    ++counts[static_cast<std::size_t>(state)];
  addLevel(std::move(states), counts);
}

void BoxTree::addLevel(std::vector<CellState> states, const StateCounts& counts)
{
  counts_.push_back(counts);
  levels_.push_back(std::move(states));
}

std::size_t BoxTree::bytes() const
{
  std::size_t sum = 0;
  for (const std::vector<CellState>& level : levels_)
    sum += level.capacity() * sizeof(CellState);
  return sum;
}

std::int64_t BoxTree::count(CellState state, std::size_t level) const
{
  return counts_[level][static_cast<std::size_t>(state)];
}

std::int64_t BoxTree::count(CellState state) const
{
  std::int64_t sum = 0;
  for (std::size_t level = 0; level < levels(); ++level)
    sum += count(state, level);
  return sum;
}

Interval BoxTree::volume(CellState state) const
{
  Interval sum(0.0);
  for (std::size_t level = 0; level < levels(); ++level)
    if (count(state, level) > 0)
      sum += Interval(static_cast<double>(count(state, level))) * bisection_.volume(level);
  return sum;
}

BoxTree BoxTree::coarsened(std::int64_t most) const
{
  std::size_t last = 0;
  std::int64_t settled = 0;  // in the levels before
  for (std::size_t number = 0; number < levels(); ++number)
  {
    settled +=
        count(CellState::INSIDE, number) + count(CellState::BOUNDARY, number) + count(CellState::PENDING, number);
    if (settled + count(CellState::SPLIT, number) <= most)
      last = number;
  }
  BoxTree coarse(bisection_);
  for (std::size_t number = 0; number < levels() && number <= last; ++number)
  {
    std::vector<CellState> states = levels_[number];
    if (number == last)
      std::replace(states.begin(), states.end(), CellState::SPLIT, CellState::BOUNDARY);
    coarse.addLevel(std::move(states));
  }
  return coarse;
}

void BoxTree::each(CellState state, std::size_t most,
                   const std::function<void(std::size_t level, const std::vector<Box>&)>& take) const
{
  std::vector<Box> found;
  const auto hand = [&](std::size_t level, std::size_t least) {
    if (found.size() < least)
      return;
    take(level, found);
    found.clear();
  };
  std::vector<Cell> cells = { Cell{ 0, 0, 0 } };
  for (std::size_t level = 0; level < levels(); ++level)
  {
    std::vector<Cell> next;
    next.reserve(2 * static_cast<std::size_t>(count(CellState::SPLIT, level)));
    for (std::size_t k = 0; k < cells.size(); ++k)
    {
      if (levels_[level][k] == state)
        found.push_back(bisection_.box(cells[k], level));
      if (levels_[level][k] == CellState::SPLIT)
        for (const std::uint32_t side : { 0U, 1U })
          next.push_back(bisection_.half(cells[k], level, side));
      hand(level, most);
    }
    hand(level, 1);
    cells = std::move(next);
  }
}

std::vector<std::vector<Box>> BoxTree::boxes(CellState state) const
{
  std::vector<std::vector<Box>> found(levels());
  for (std::size_t level = 0; level < levels(); ++level)
    found[level].reserve(static_cast<std::size_t>(count(state, level)));
  each(state, 1 << 16, [&found](std::size_t level, const std::vector<Box>& boxes) {
    found[level].insert(found[level].end(), boxes.begin(), boxes.end());
  });
  return found;
}
}  // namespace pkm_workspace
