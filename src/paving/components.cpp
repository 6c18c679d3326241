// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/paving/components.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <stdexcept>

namespace pkm_workspace
{
namespace
{
/// Boxes whose halves are looked at between two looks at the clock.
constexpr std::size_t DIVIDED_A_LOOK = 1024;

std::vector<std::size_t> firstNumbers(const BoxTree& tree)
{
  std::vector<std::size_t> first = { 0 };
  for (std::size_t level = 0; level < tree.levels(); ++level)
    first.push_back(first.back() + tree.level(level).size());
  if (first.back() > std::numeric_limits<std::uint32_t>::max())
    throw std::invalid_argument("the paving has " + std::to_string(first.back()) +
                                " boxes: connected components are known of at most 4294967295; give a coarser "
                                "resolution");
  return first;
}

std::vector<std::uint32_t> eachByItself(std::size_t count)
{
  std::vector<std::uint32_t> links(count);
  std::iota(links.begin(), links.end(), 0);
  return links;
}

/// A component in the making.
struct Sum
{
  Component component;
  std::vector<std::int64_t> boxes;  ///< of each level
  std::size_t level = std::numeric_limits<std::size_t>::max();

  void add(const TreeNode& node, const Box& box)
  {
    boxes.resize(std::max(boxes.size(), node.level + 1));
    ++boxes[node.level];
    Box& bounds = component.bounds;
    bounds = component.boxes == 0 ? box : Box{ bounds.lower.cwiseMin(box.lower), bounds.upper.cwiseMax(box.upper) };
    ++component.boxes;
    if (node.level < level)
    {
      level = node.level;
      component.point = box.center();
    }
  }

  Component finished(const Bisection& bisection) const
  {
    Component result = component;
    for (std::size_t k = 0; k < boxes.size(); ++k)
      if (boxes[k] > 0)
        result.volume += Interval(static_cast<double>(boxes[k])) * bisection.volume(k);
    return result;
  }
};
}  // namespace

Components::Components(const BoxTree& tree, const std::function<bool()>& is_over)
  : walk_(tree)
  , first_(firstNumbers(tree))
  , inside_(eachByItself(first_.back()))
  , not_outside_(eachByItself(first_.back()))
{
  if (tree.levels() == 0)
    return;
  uniteWithin({}, is_over);
  if (complete_)
    sumUp();
}

std::uint32_t Components::root(const Links& links, std::uint32_t number)
{
  while (links[number] != number)
    number = links[number];
  return number;
}

/// The same, and shortens the way.
std::uint32_t Components::rootOf(Links& links, std::uint32_t number)
{
  for (; links[number] != number; number = links[number])
    links[number] = links[links[number]];
  return number;
}

/// @pre they touch, and neither is OUTSIDE
void Components::unite(const TreeNode& a, const TreeNode& b)
{
  const auto link = [&](Links& links) {
    const std::uint32_t one = rootOf(links, numberOf(a));
    const std::uint32_t other = rootOf(links, numberOf(b));
    links[std::max(one, other)] = std::min(one, other);
  };
  link(not_outside_);
  if (walk_.state(a) == CellState::INSIDE && walk_.state(b) == CellState::INSIDE)
    link(inside_);
}

/// All boxes below one that touch each other.
void Components::uniteWithin(const TreeNode& node, const std::function<bool()>& is_over)
{
  if (walk_.state(node) != CellState::SPLIT || !complete_)
    return;
  if (++divided_ % DIVIDED_A_LOOK == 0 && is_over())
    complete_ = false;
  const std::array<TreeNode, 2> halves = walk_.halves(node);
  uniteWithin(halves[0], is_over);
  uniteWithin(halves[1], is_over);
  uniteBetween(halves[0], halves[1]);
}

/// All boxes below one that touch any below the other.
void Components::uniteBetween(const TreeNode& a, const TreeNode& b)
{
  const CellState one = walk_.state(a);
  const CellState other = walk_.state(b);
  if (one == CellState::OUTSIDE || other == CellState::OUTSIDE || !walk_.touch(a, b))
    return;
  if (one != CellState::SPLIT && other != CellState::SPLIT)
    return unite(a, b);
  const bool divides_a = one == CellState::SPLIT && (other != CellState::SPLIT || a.level <= b.level);
  for (const TreeNode& half : walk_.halves(divides_a ? a : b))
    uniteBetween(half, divides_a ? b : a);
}

void Components::sumUp()
{
  std::unordered_map<std::uint32_t, Sum> sums;
  walk_.each([](const TreeNode&) { return true; },
             [&](const TreeNode& node) {
               if (walk_.state(node) == CellState::INSIDE)
                 sums[rootOf(inside_, numberOf(node))].add(node, walk_.box(node));
             });
  std::vector<std::pair<Component, std::uint32_t>> found;
  for (const auto& sum : sums)
    found.emplace_back(sum.second.finished(walk_.tree().bisection()), sum.first);
  std::sort(found.begin(), found.end(), [](const auto& a, const auto& b) {
    const double one = a.first.volume.lower();
    const double other = b.first.volume.lower();
    return one != other ? one > other : a.second < b.second;
  });
  std::unordered_map<std::uint32_t, std::size_t> clusters;
  for (auto& [component, root] : found)
  {
    // a box is the root of a class of boxes INSIDE, and one of the boxes that are not OUTSIDE
    component.cluster = clusters.emplace(rootOf(not_outside_, root), clusters.size()).first->second;
    component_[root] = list_.size();
    list_.push_back(component);
  }
  clusters_ = clusters.size();
}

std::optional<std::size_t> Components::at(const Eigen::Vector3d& point) const
{
  std::optional<std::size_t> found;
  if (!complete_)
    return found;
  walk_.each([&](const TreeNode& node) { return walk_.box(node).contains(point); },
             [&](const TreeNode& node) {
               if (walk_.state(node) == CellState::INSIDE)
                 found = component_.at(root(inside_, numberOf(node)));
             });
  return found;
}

/// Of all boxes around the point that are not OUTSIDE, ascending.
std::vector<std::uint32_t> Components::clustersAt(const Eigen::Vector3d& point) const
{
  std::vector<std::uint32_t> found;
  walk_.each([&](const TreeNode& node) { return walk_.box(node).contains(point); },
             [&](const TreeNode& node) {
               if (walk_.state(node) != CellState::OUTSIDE)
                 found.push_back(root(not_outside_, numberOf(node)));
             });
  std::sort(found.begin(), found.end());
  return found;
}

bool Components::areApart(const Eigen::Vector3d& a, const Eigen::Vector3d& b) const
{
  const std::vector<std::uint32_t> one = clustersAt(a);
  const std::vector<std::uint32_t> other = clustersAt(b);
  std::vector<std::uint32_t> both;
  std::set_intersection(one.begin(), one.end(), other.begin(), other.end(), std::back_inserter(both));
  return complete_ && !one.empty() && !other.empty() && both.empty();
}
}  // namespace pkm_workspace
