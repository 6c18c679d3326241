// SPDX-License-Identifier: BSD-3-Clause
// How a set hangs together, against every pair of boxes of random trees, and against a flood of good points.
#include "pkm_workspace/paving/components.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <queue>
#include <set>

#include "paving/pavings.h"
#include "support/flood.h"
#include "support/random.h"

namespace pkm_workspace
{
namespace
{
using Eigen::Vector3d;

using test::SEED;

struct Leaf
{
  CellState state;
  Box box;
};

/// How often each is chosen.
const std::vector<CellState> STATES = [] {
  std::vector<CellState> states(13, CellState::SPLIT);
  states.insert(states.end(), { CellState::INSIDE, CellState::INSIDE, CellState::OUTSIDE, CellState::OUTSIDE,
                                CellState::OUTSIDE, CellState::BOUNDARY, CellState::PENDING });
  return states;
}();

/// Boxes that are divided at random down to the last level, with any states.
BoxTree randomTree(const Box& root, double resolution, test::Random& random)
{
  BoxTree tree{ Bisection(root, resolution) };
  for (std::size_t count = 1; count > 0;)
  {
    std::vector<CellState> states(count);
    const bool is_last = tree.levels() == tree.bisection().depth();
    for (CellState& state : states)
      do
        state = STATES[random.integer(0, 19)];
      while (is_last && state == CellState::SPLIT);
    count = 2 * static_cast<std::size_t>(std::count(states.begin(), states.end(), CellState::SPLIT));
    tree.addLevel(states);
  }
  return tree;
}

std::vector<Leaf> leavesOf(const BoxTree& tree)
{
  std::vector<Leaf> leaves;
  for (const CellState state : { CellState::INSIDE, CellState::OUTSIDE, CellState::BOUNDARY, CellState::PENDING })
    for (const std::vector<Box>& level : tree.boxes(state))
      for (const Box& box : level)
        leaves.push_back({ state, box });
  return leaves;
}

bool shareAPoint(const Box& a, const Box& b)
{
  for (int k = 0; k < 3; ++k)
    if (a.upper[k] < b.lower[k] || b.upper[k] < a.lower[k])
      return false;
  return true;
}

/// A number for each leaf, the same for those that a chain of leaves joins that count; -1 for those that do not.
template <class Counts>
std::vector<int> classesOf(const std::vector<Leaf>& leaves, const Counts& counts)
{
  std::vector<int> classes(leaves.size(), -1);
  int next = 0;
  for (std::size_t first = 0; first < leaves.size(); ++first)
  {
    if (classes[first] >= 0 || !counts(leaves[first].state))
      continue;
    std::queue<std::size_t> open({ first });
    for (classes[first] = next; !open.empty(); open.pop())
      for (std::size_t k = 0; k < leaves.size(); ++k)
        if (classes[k] < 0 && counts(leaves[k].state) && shareAPoint(leaves[open.front()].box, leaves[k].box))
        {
          classes[k] = next;
          open.push(k);
        }
    ++next;
  }
  return classes;
}

void expectPathInBoxes(const Components& components, const std::vector<Leaf>& leaves, const Vector3d& from,
                       const Vector3d& to)
{
  const std::vector<Vector3d> path = components.path(from, to);
  ASSERT_GE(path.size(), 2U);
  EXPECT_EQ(path.front(), from);
  EXPECT_EQ(path.back(), to);
  for (std::size_t k = 1; k < path.size(); ++k)
    EXPECT_TRUE(std::any_of(leaves.begin(), leaves.end(),
                            [&](const Leaf& leaf) {
                              return leaf.state == CellState::INSIDE && leaf.box.contains(path[k - 1]) &&
                                     leaf.box.contains(path[k]);
                            }))
        << "from (" << path[k - 1].transpose() << ") to (" << path[k].transpose() << ")";
}

void expectAsPairsOfBoxes(const BoxTree& tree, std::set<std::size_t>& counts)
{
  const std::vector<Leaf> leaves = leavesOf(tree);
  const auto inside = classesOf(leaves, [](CellState state) { return state == CellState::INSIDE; });
  const auto clusters = classesOf(leaves, [](CellState state) { return state != CellState::OUTSIDE; });
  const Components components(tree);
  std::map<int, std::size_t> known;
  std::set<int> held;
  std::int64_t boxes = 0;
  for (std::size_t k = 0; k < leaves.size(); ++k)
  {
    const Vector3d center = leaves[k].box.center();
    const auto component = components.at(center);
    ASSERT_EQ(component.has_value(), leaves[k].state == CellState::INSIDE);
    if (!component)
      continue;
    EXPECT_EQ(known.emplace(inside[k], *component).first->second, *component);
    held.insert(clusters[k]);
  }
  EXPECT_EQ(known.size(), components.list().size());
  EXPECT_EQ(held.size(), components.clusters());
  for (const Component& component : components.list())
    boxes += component.boxes;
  EXPECT_EQ(boxes, tree.count(CellState::INSIDE));
  counts.insert(components.list().size());
  test::Random random(SEED);
  const auto any = [&] { return static_cast<std::size_t>(random.integer(0, static_cast<int>(leaves.size()) - 1)); };
  for (int k = 0; k < 300; ++k)
  {
    const std::size_t one = any();
    const std::size_t other = any();
    const Vector3d a = leaves[one].box.center();
    const Vector3d b = leaves[other].box.center();
    EXPECT_EQ(components.areApart(a, b),
              clusters[one] >= 0 && clusters[other] >= 0 && clusters[one] != clusters[other]);
    if (one != other && inside[one] >= 0 && inside[one] == inside[other])
      expectPathInBoxes(components, leaves, a, b);
  }
}

/// The set has exactly these components, and the flood finds the same.
void expectAsFlood(const Machine& machine, const PavingQuery& query, std::size_t count, std::size_t clusters, int steps)
{
  const Paving paving = pave(machine, query);
  const Components components(paving.tree);
  EXPECT_EQ(components.list().size(), count);
  EXPECT_EQ(components.clusters(), clusters);
  const test::Flood flood(machine, query.criterion, paving.box, steps);
  std::map<std::size_t, std::set<int>> labels;       // of each component
  std::map<int, std::set<std::size_t>> clusters_of;  // of each label
  for (std::size_t k = 0; k < flood.size(); ++k)
    if (const auto component = components.at(flood.point(k)))
    {
      ASSERT_GE(flood.label(k), 0) << "(" << flood.point(k).transpose() << ")";
      labels[*component].insert(flood.label(k));
      clusters_of[flood.label(k)].insert(components.list()[*component].cluster);
    }
  EXPECT_EQ(labels.size(), count);
  for (const auto& component : labels)
    EXPECT_EQ(component.second.size(), 1U) << "component " << component.first;
  for (const auto& label : clusters_of)
    EXPECT_EQ(label.second.size(), 1U) << "the flood joins what is told to be apart";
}
}  // namespace

TEST(Components, areThoseOfAllPairsOfBoxes)
{
  test::Random random(SEED);
  std::set<std::size_t> counts;
  const Box roots[] = { { Vector3d(-1.0, -1.0, -1.0), Vector3d(1.0, 1.0, 1.0) },
                        { Vector3d(0.1, -0.3, 0.7), Vector3d(0.4, 0.11, 0.9) },
                        { Vector3d(-1.0, -1.0, 0.3), Vector3d(1.0, 0.7, 0.3) } };
  for (int k = 0; k < 60; ++k)
  {
    const Box& root = roots[k % 3];
    expectAsPairsOfBoxes(randomTree(root, root.maxWidth() / (k % 3 == 2 ? 16 : 8), random), counts);
    ASSERT_FALSE(testing::Test::HasFailure()) << "seed " << SEED << ", tree " << k;
  }
  EXPECT_GT(counts.size(), 5U);
}

TEST(Components, boxesThatShareACornerHangTogether)
{
  const Box root = { Vector3d::Zero(), Vector3d::Ones() };
  BoxTree tree{ Bisection(root, 0.5) };
  const CellState in = CellState::INSIDE;
  const CellState out = CellState::OUTSIDE;
  const CellState split = CellState::SPLIT;
  tree.addLevel({ split });
  tree.addLevel({ split, split });
  tree.addLevel({ split, split, split, split });
  tree.addLevel({ in, out, out, out, out, out, out, in });
  const Components corner(tree);
  EXPECT_EQ(corner.list().size(), 1U);
  EXPECT_EQ(corner.path(Vector3d::Zero(), Vector3d::Ones()).size(), 3U);
}

TEST(Components, areNoneOfAnEmptyTree)
{
  EXPECT_TRUE(Components(BoxTree()).list().empty());
}

TEST(Components, areLeftOpenWhereTheTimeIsOver)
{
  const Paving paving = pave(orthoglide(), test::query(0.03));
  const Components components(paving.tree, [] { return true; });
  EXPECT_FALSE(components.complete());
  EXPECT_FALSE(components.at(Vector3d::Zero()));
  EXPECT_FALSE(components.areApart(Vector3d::Zero(), Vector3d::Constant(0.66)));
}

TEST(Components, orthoglideHasPointsOfItsAspectThatZeroDoesNotReach)
{
  PavingQuery query = test::query(0.02);
  query.criterion.psi_min = 0.2;
  query.criterion.psi_max = 5.0;
  expectAsFlood(orthoglide(), query, 2, 2, 90);
  query.criterion.aspect = Criterion::Aspect::OTHER;
  expectAsFlood(orthoglide(), query, 4, 4, 90);
}

TEST(Components, reachableSetIsOnePiece)
{
  expectAsFlood(orthoglide(), test::query(0.05, Criterion::Set::REACHABLE, Criterion::Aspect::BOTH), 1, 1, 40);
}
}  // namespace pkm_workspace
