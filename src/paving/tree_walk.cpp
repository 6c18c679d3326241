// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/paving/tree_walk.h"

namespace pkm_workspace
{
TreeWalk::TreeWalk(const BoxTree& tree) : tree_(tree)
{
  for (std::size_t level = 0; level < tree.levels(); ++level)
  {
    const std::vector<CellState>& states = tree.level(level);
    splits_before_.emplace_back();
    std::uint32_t splits = 0;
    for (std::size_t k = 0; k < states.size(); ++k)
    {
      if (k % STRIDE == 0)
        splits_before_.back().push_back(splits);
      splits += states[k] == CellState::SPLIT ? 1 : 0;
    }
  }
}

std::array<TreeNode, 2> TreeWalk::halves(const TreeNode& node) const
{
  const auto states = tree_.level(node.level).begin();
  const auto at = [&states](std::size_t k) { return states + static_cast<std::ptrdiff_t>(k); };
  const std::size_t known = node.index / STRIDE;
  const std::size_t splits = splits_before_[node.level][known] +
                             static_cast<std::size_t>(std::count(at(known * STRIDE), at(node.index), CellState::SPLIT));
  const auto half = [&](std::uint32_t side) {
    return TreeNode{ node.level + 1, 2 * splits + side, tree_.bisection().half(node.cell, node.level, side) };
  };
  return { half(0), half(1) };
}

bool TreeWalk::touch(const TreeNode& a, const TreeNode& b) const
{
  const std::array<int, 3>& one = tree_.bisection().halvings(a.level);
  const std::array<int, 3>& other = tree_.bisection().halvings(b.level);
  for (std::size_t k = 0; k < 3; ++k)
  {
    // in parts of the finer of the two; neighbours share a face, which is one double
    const int finest = std::max(one[k], other[k]);
    const auto face = [&](const TreeNode& node, int halvings, std::uint64_t side) {
      return (node.cell[k] + side) << (finest - halvings);
    };
    if (face(a, one[k], 1) < face(b, other[k], 0) || face(b, other[k], 1) < face(a, one[k], 0))
      return false;
  }
  return true;
}
}  // namespace pkm_workspace
