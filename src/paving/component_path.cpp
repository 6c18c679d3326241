// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <functional>
#include <limits>
#include <queue>
#include <stdexcept>

#include "pkm_workspace/paving/components.h"

namespace pkm_workspace
{
namespace
{
using Eigen::Vector3d;

/// The point of a box that is nearest to another one; a point of the box itself for every rounding.
Vector3d nearestIn(const Box& box, const Vector3d& point)
{
  return point.cwiseMax(box.lower).cwiseMin(box.upper);
}

/// A way that ends in a box: where it came in, and how long it is.
struct Entry
{
  TreeNode node;
  Vector3d point;
  double length = 0.0;
  std::uint32_t from = 0;  ///< number of the box before
};

/// What is looked at next: the least first.
template <class Item>
struct Ranked
{
  double rank;
  Item item;

  bool operator>(const Ranked& other) const { return rank > other.rank; }
};
template <class Item>
using Queue = std::priority_queue<Ranked<Item>, std::vector<Ranked<Item>>, std::greater<Ranked<Item>>>;

/// From where the entries begin to a point of a box.
std::vector<Vector3d> wayBack(const std::unordered_map<std::uint32_t, Entry>& entries, std::uint32_t box,
                              const Vector3d& to)
{
  std::vector<Vector3d> points = { to };
  for (bool goes_on = true; goes_on;)
  {
    const Entry& entry = entries.at(box);
    if (points.back() != entry.point)
      points.push_back(entry.point);
    goes_on = entry.from != box;
    box = entry.from;
  }
  std::reverse(points.begin(), points.end());
  return points;
}
}  // namespace

std::vector<Vector3d> Components::path(const Vector3d& from, const Vector3d& to) const
{
  // A*: the way so far, and the straight rest
  std::unordered_map<std::uint32_t, Entry> best;
  Queue<std::uint32_t> queue;
  const auto reach = [&](const Entry& entry) {
    const std::uint32_t number = numberOf(entry.node);
    const auto known = best.find(number);
    if (known != best.end() && known->second.length <= entry.length)
      return;
    best[number] = entry;
    queue.push({ entry.length + (to - entry.point).norm(), number });
  };
  const auto isInside = [this](const TreeNode& node) { return walk_.state(node) == CellState::INSIDE; };
  walk_.each([&](const TreeNode& node) { return walk_.box(node).contains(from); },
             [&](const TreeNode& node) {
               if (isInside(node))
                 reach({ node, from, 0.0, numberOf(node) });
             });
  while (!queue.empty())
  {
    const std::uint32_t number = queue.top().item;
    const double rank = queue.top().rank;
    queue.pop();
    const Entry here = best.at(number);
    if (rank > here.length + (to - here.point).norm())
      continue;  // a shorter way was found since
    if (walk_.box(here.node).contains(to))
      return wayBack(best, number, to);
    walk_.each([&](const TreeNode& node) { return walk_.touch(node, here.node); },
               [&](const TreeNode& node) {
                 if (!isInside(node) || numberOf(node) == number)
                   return;
                 const Vector3d crossing = nearestIn(intersection(walk_.box(here.node), walk_.box(node)), here.point);
                 reach({ node, crossing, here.length + (crossing - here.point).norm(), number });
               });
  }
  throw std::logic_error("the points are in no common component");
}

std::vector<Box> Components::nearest(const Vector3d& point, std::size_t most) const
{
  std::vector<Box> found;
  Queue<TreeNode> queue;
  const auto add = [&](const TreeNode& node) {
    const CellState state = walk_.state(node);
    if (state == CellState::SPLIT || state == CellState::INSIDE)
      queue.push({ (nearestIn(walk_.box(node), point) - point).norm(), node });
  };
  if (walk_.tree().levels() > 0)
    add({});
  while (!queue.empty() && found.size() < most)
  {
    const TreeNode node = queue.top().item;
    queue.pop();
    if (walk_.state(node) == CellState::INSIDE)
      found.push_back(walk_.box(node));
    else
      for (const TreeNode& half : walk_.halves(node))
        add(half);
  }
  return found;
}
}  // namespace pkm_workspace
