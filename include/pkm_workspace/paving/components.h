// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <unordered_map>
#include <vector>

#include "pkm_workspace/paving/box_tree.h"
#include "pkm_workspace/paving/tree_walk.h"

namespace pkm_workspace
{
/// A connected piece of a set: boxes that are INSIDE, each of which shares a point with another one of them.
struct Component
{
  Interval volume = 0.0;    ///< of its boxes, in the dimension of the root [m^3]
  std::int64_t boxes = 0;   ///< how many
  Box bounds;               ///< the smallest box around them [m]
  Eigen::Vector3d point;    ///< the center of its largest box [m]
  std::size_t cluster = 0;  ///< components of different clusters are proved apart
};

/// What a paving proves of how its set hangs together, as a subset of the box that was paved. Boxes are closed.
///
/// All points of boxes that are INSIDE are in the set, so those that share a point, be it a corner, are connected. The
/// set lies in the boxes that are not OUTSIDE. Where these fall apart, into clusters, the set does.
///
/// Takes BYTES_A_BOX for each box of the tree, and about linear time.
class Components
{
public:
  static constexpr std::size_t BYTES_A_BOX = 8;

  /// @param tree has to outlive this object @param is_over asked now and then: once it is true, all is left open
  /// @throws std::invalid_argument for more than 2^32 - 1 boxes
  explicit Components(
      const BoxTree& tree, const std::function<bool()>& is_over = [] { return false; });

  /// Whether it was not over before the end: otherwise nothing is known.
  bool complete() const { return complete_; }

  /// The largest first.
  const std::vector<Component>& list() const { return list_; }
  /// How many clusters hold a component: the set has so many connected components at the least.
  std::size_t clusters() const { return clusters_; }

  /// The component that a point is proved to belong to.
  std::optional<std::size_t> at(const Eigen::Vector3d& point) const;
  /// Whether no path in the set and the box joins the points, if they are points of the set.
  bool areApart(const Eigen::Vector3d& a, const Eigen::Vector3d& b) const;
  /// Points from @p from to @p to, both among them: from each to the next the straight line lies in one box that is
  /// INSIDE. Short, not the shortest. @pre at() gives the same component for both
  std::vector<Eigen::Vector3d> path(const Eigen::Vector3d& from, const Eigen::Vector3d& to) const;
  /// The boxes that are INSIDE nearest to a point, the nearest first.
  std::vector<Box> nearest(const Eigen::Vector3d& point, std::size_t most) const;

private:
  /// Numbers of boxes that are united: each leads to another one of its class, the last to itself.
  using Links = std::vector<std::uint32_t>;

  std::uint32_t numberOf(const TreeNode& node) const
  {
    return static_cast<std::uint32_t>(first_[node.level] + node.index);
  }
  static std::uint32_t root(const Links& links, std::uint32_t number);
  static std::uint32_t rootOf(Links& links, std::uint32_t number);
  void unite(const TreeNode& a, const TreeNode& b);
  void uniteWithin(const TreeNode& node, const std::function<bool()>& is_over);
  void uniteBetween(const TreeNode& a, const TreeNode& b);
  void sumUp();
  std::vector<std::uint32_t> clustersAt(const Eigen::Vector3d& point) const;

  TreeWalk walk_;
  std::vector<std::size_t> first_;  ///< of each level, the number of its first box
  Links inside_;                    ///< boxes that are INSIDE
  Links not_outside_;               ///< boxes that are not OUTSIDE
  std::vector<Component> list_;
  std::unordered_map<std::uint32_t, std::size_t> component_;  ///< of each root
  std::size_t clusters_ = 0;
  bool complete_ = true;
  std::size_t divided_ = 0;  ///< boxes whose halves were looked at
};
}  // namespace pkm_workspace
