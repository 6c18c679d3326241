// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "checked_leg.h"

namespace pkm_workspace
{
namespace checking
{
/// What a reason, or a test of a box, asks for: a condition of the criterion, of a leg or along a vector.
struct Question
{
  std::string of;
  int leg = 0;
  Vector v = {};
};

/// The machine and what is asked of it.
class CheckedClaims
{
public:
  explicit CheckedClaims(const Json& json);

  const std::vector<std::unique_ptr<const CheckedLeg>>& legs() const { return legs_; }
  bool hasLimit(int leg, int side) const
  {
    return joint_limits_ && legs_[static_cast<std::size_t>(leg)]->limit(side).has_value();
  }
  bool hasJointLimits() const { return joint_limits_; }
  /// Whether all legs slide in one direction.
  bool hasParallelRails() const;
  int aspect() const { return aspect_; }
  const std::optional<Ball>& factor(bool is_largest) const { return is_largest ? psi_max_ : psi_min_; }

  std::array<LegAt, 3> at(const JetVector& p) const;
  Question questionOf(const Json& json) const;
  /// What is not negative wherever the criterion holds.
  Jet value(const Question& question, const std::array<LegAt, 3>& legs) const;
  /// Semidefinite wherever it holds: entries 11, 22, 33, 23, 13, 12.
  std::array<Jet, 6> matrix(bool is_largest, const std::array<LegAt, 3>& legs) const;

private:
  std::vector<std::unique_ptr<const CheckedLeg>> legs_;
  std::optional<Ball> psi_min_;
  std::optional<Ball> psi_max_;
  int aspect_;
  bool joint_limits_;
};

/// How often the box of a leaf is halved until its reason holds.
constexpr int MOST_SPLITS = 10;

/// Walks a tree of cuts and calls leaf(box, json) for each leaf, in the order of the file.
template <class Leaf>
void walk(const Json& tree, const Cube& root, const Leaf& leaf)
{
  std::vector<Cube> open = { root };
  std::size_t next = 0;
  while (!open.empty())
  {
    const Cube box = open.back();
    open.pop_back();
    need(next < tree.size(), "the tree ends early");
    const Json& node = tree[next++];
    if (!node.is_array())
    {
      leaf(box, node);
      continue;
    }
    need(node.size() == 2, "a cut that is none");
    const std::size_t axis = indexOf(node[0], 3);
    const double plane = numberOf(node[1]);
    need(box.lower[axis] <= plane && plane <= box.upper[axis], "a cut beside its box");
    open.push_back(box);
    open.back().lower[axis] = plane;
    open.push_back(box);
    open.back().upper[axis] = plane;
  }
  need(next == tree.size(), "the tree goes on behind its end");
}

/// Holds a box against its reason, or else its halves.
/// @param check whether it holds all over a box
template <class Check>
void prove(const Check& check, const Cube& box, int splits, const std::string& what)
{
  if (check(box))
    return;
  std::size_t axis = 0;
  for (std::size_t j = 1; j < 3; ++j)
    if (box.upper[j] - box.lower[j] > box.upper[axis] - box.lower[axis])
      axis = j;
  need(splits > 0 && box.lower[axis] < box.upper[axis], what + " does not hold in the box " + textOf(box));
  const double middle = 0.5 * box.lower[axis] + 0.5 * box.upper[axis];
  Cube part = box;
  part.upper[axis] = middle;
  prove(check, part, splits - 1, what);
  part = box;
  part.lower[axis] = middle;
  prove(check, part, splits - 1, what);
}
}  // namespace checking
}  // namespace pkm_workspace
