// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "pkm_workspace/paving/box_tree.h"

namespace pkm_workspace
{
/// A box of a tree.
struct TreeNode
{
  std::size_t level = 0;
  std::size_t index = 0;  ///< within its level
  Cell cell = { 0, 0, 0 };
};

/// Goes down a tree from its root to any box, without a list of its boxes.
class TreeWalk
{
public:
  /// @param tree has to outlive this object
  explicit TreeWalk(const BoxTree& tree);

  const BoxTree& tree() const { return tree_; }
  CellState state(const TreeNode& node) const { return tree_.level(node.level)[node.index]; }
  Box box(const TreeNode& node) const { return tree_.bisection().box(node.cell, node.level); }
  /// @pre the box is SPLIT
  std::array<TreeNode, 2> halves(const TreeNode& node) const;
  /// Whether the closed boxes share a point, exactly.
  bool touch(const TreeNode& a, const TreeNode& b) const;

  /// Calls @p take for every box that is not SPLIT, below those for which @p enters is true.
  template <class Enters, class Take>
  void each(const Enters& enters, const Take& take, const TreeNode& node = {}) const
  {
    if (tree_.levels() == 0 || !enters(node))
      return;
    if (state(node) != CellState::SPLIT)
      return take(node);
    for (const TreeNode& half : halves(node))
      each(enters, take, half);
  }

private:
  static constexpr std::size_t STRIDE = 64;

  const BoxTree& tree_;
  std::vector<std::vector<std::uint32_t>> splits_before_;  ///< of each level, at every STRIDE-th box
};
}  // namespace pkm_workspace
