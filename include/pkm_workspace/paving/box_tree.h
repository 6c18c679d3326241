// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include "pkm_workspace/interval/box.h"
#include "pkm_workspace/interval/dyadic_partition.h"

namespace pkm_workspace
{
/// What is known of a box of a paving.
enum class CellState : std::uint8_t
{
  SPLIT,     ///< its halves are in the next level
  INSIDE,    ///< every point satisfies the criterion
  OUTSIDE,   ///< no point does
  BOUNDARY,  ///< undecided at the resolution
  PENDING,   ///< not looked at
};
/// How many boxes have each state.
using StateCounts = std::array<std::int64_t, 5>;

/// A box of a bisection by its numbers: which part it is along each axis.
using Cell = std::array<std::uint32_t, 3>;

/// The bisection of a box: always across the side that is widest by then, the first of equals, so that all boxes of a
/// level have one size. Ends where no side is wider than the resolution.
class Bisection
{
public:
  Bisection() : Bisection(Box(), 1.0) {}
  /// @param resolution [m], > 0 @throws std::invalid_argument when that takes more than 31 halvings of a side
  Bisection(const Box& root, double resolution);

  const Box& root() const { return root_; }
  /// The level whose boxes are not divided any more; the root is level 0.
  std::size_t depth() const { return axes_.size(); }
  /// The box of a cell at a level.
  Box box(const Cell& cell, std::size_t level) const;
  /// One half of a cell of that level.
  Cell half(const Cell& cell, std::size_t level, std::uint32_t side) const
  {
    Cell result = cell;
    const auto axis = static_cast<std::size_t>(axes_[level]);
    result[axis] = 2 * cell[axis] + side;
    return result;
  }
  /// How often each side has been halved at a level.
  const std::array<int, 3>& halvings(std::size_t level) const { return halvings_[level]; }
  /// How many sides of the root have a width: 3, or 2 for a flat box.
  int dimension() const;
  /// Encloses the volume of every box of a level [m^3]; of flat boxes the area [m^2], of lines the length [m].
  Interval volume(std::size_t level) const;

private:
  Box root_;
  std::array<DyadicPartition, 3> sides_;
  std::vector<int> axes_;                     ///< along which the boxes of each level are divided
  std::vector<std::array<int, 3>> halvings_;  ///< of each side, by level
};

/// The boxes of a paving, level by level, one byte each: the halves of the k-th SPLIT of a level are the boxes 2 k and
/// 2 k + 1 of the next.
class BoxTree
{
public:
  BoxTree() = default;
  explicit BoxTree(const Bisection& bisection) : bisection_(bisection) {}

  const Bisection& bisection() const { return bisection_; }
  std::size_t levels() const { return levels_.size(); }
  /// The states of a level's boxes, in order.
  const std::vector<CellState>& level(std::size_t number) const { return levels_[number]; }
  /// @param states as many as the levels before leave open
  void addLevel(std::vector<CellState> states);
  /// The same where the states are counted already.
  void addLevel(std::vector<CellState> states, const StateCounts& counts);

  /// Memory that the boxes take [bytes].
  std::size_t bytes() const;

  /// How many boxes of a level, or of all, have that state.
  std::int64_t count(CellState state, std::size_t level) const;
  std::int64_t count(CellState state) const;
  /// Encloses the volume of the root, which all boxes fill together, in its own dimension [m^3].
  Interval wholeVolume() const { return levels() > 0 ? bisection_.volume(0) : Interval(0.0); }
  /// Encloses the volume of these, in the root's own dimension [m^3].
  Interval volume(CellState state) const;
  /// The same boxes as coarsely as it takes for no more than @p most that are not OUTSIDE (or one): boxes below a level
  /// are left out, and those of that level that hold them are BOUNDARY.
  BoxTree coarsened(std::int64_t most) const;
  /// Called with the boxes of that state, level by level, no more than @p most at a time.
  void each(CellState state, std::size_t most,
            const std::function<void(std::size_t level, const std::vector<Box>&)>& take) const;
  /// All of them, for each level.
  std::vector<std::vector<Box>> boxes(CellState state) const;

private:
  Bisection bisection_;
  std::vector<std::vector<CellState>> levels_;
  std::vector<StateCounts> counts_;
};
}  // namespace pkm_workspace
