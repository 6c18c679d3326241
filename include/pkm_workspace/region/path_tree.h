// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "pkm_workspace/interval/box.h"
#include "pkm_workspace/interval/curve.h"

namespace pkm_workspace
{
/// All moves of a path, held in groups of groups with a box around each: moves that follow each other lie together.
class PathTree
{
public:
  /// A group of moves, or a piece of one.
  struct Part
  {
    std::uint32_t level = 0;  ///< 0 of a move, n of a group of up to GROUP^n moves
    std::uint32_t index = 0;  ///< of the move, or of the group at its level
    double first = 0.0;       ///< of a move: the piece first <= t <= last
    double last = 1.0;
  };

  /// @param tool_speed encloses the speed of the tool there [m/s]; 0 where no limit on rates is held
  void add(const Curve& curve, const Interval& tool_speed);
  /// After the last one.
  void close();

  std::size_t size() const { return curves_.size(); }
  const Curve& curve(const Part& part) const { return curves_[part.index]; }
  /// All of it. @pre there is a move
  Part all() const { return { static_cast<std::uint32_t>(groups_.size()), 0 }; }

  /// Contains all points, and hardly more: box() of an arc is loose, the more so the longer it is [m]. @pre as all()
  Box bounds() const;
  /// Contains the points of the part [m].
  Box box(const Part& part) const;
  /// Encloses the speeds of the tool on it [m/s].
  Interval speed(const Part& part) const;
  /// No point of it bends more [1/m].
  double curvature(const Part& part) const;
  /// Calls use(part) for each of the parts that make up this one: those of a group, or halves of a piece.
  template <class Use>
  void divide(const Part& part, const Use& use) const
  {
    if (part.level == 0)
    {
      const double middle = 0.5 * part.first + 0.5 * part.last;
      use(Part{ 0, part.index, part.first, middle });
      use(Part{ 0, part.index, middle, part.last });
      return;
    }
    const std::size_t end = std::min<std::size_t>(GROUP * (part.index + std::size_t(1)), countAt(part.level - 1));
    for (std::size_t k = GROUP * std::size_t(part.index); k < end; ++k)
      use(Part{ part.level - 1, static_cast<std::uint32_t>(k) });
  }
  bool isDivisible(const Part& part) const { return part.level > 0 || part.last - part.first > LEAST_PIECE; }

private:
  static constexpr std::size_t GROUP = 8;
  static constexpr double LEAST_PIECE = 0x1p-45;

  struct Group
  {
    Box box;
    Interval speed;
    double curvature;
  };

  std::size_t countAt(std::uint32_t level) const { return level == 0 ? curves_.size() : groups_[level - 1].size(); }

  std::vector<Curve> curves_;
  std::vector<Interval> speeds_;
  std::vector<std::vector<Group>> groups_;  ///< those of level 1 first
};
}  // namespace pkm_workspace
