// SPDX-License-Identifier: BSD-3-Clause
// No inner box holds a bad point, no discarded box a good one.
#include <gtest/gtest.h>

#include "paving/pavings.h"
#include "support/cases.h"
#include "support/oracle.h"
#include "support/random.h"

namespace pkm_workspace
{
namespace
{
using test::SEED;

/// Finds the box of a paving that a point lies in.
class Finder
{
public:
  explicit Finder(const BoxTree& tree) : tree_(tree)
  {
    for (std::size_t level = 0; level < tree.levels(); ++level)
    {
      splits_before_.emplace_back();
      std::size_t splits = 0;
      for (const CellState state : tree.level(level))
      {
        splits_before_.back().push_back(splits);
        splits += state == CellState::SPLIT ? 1 : 0;
      }
    }
  }

  CellState at(const Eigen::Vector3d& point) const
  {
    Cell cell = { 0, 0, 0 };
    std::size_t index = 0;
    for (std::size_t level = 0;; ++level)
    {
      const CellState state = tree_.level(level)[index];
      if (state != CellState::SPLIT)
        return state;
      const Cell first = tree_.bisection().half(cell, level, 0);
      const bool in_first = tree_.bisection().box(first, level + 1).contains(point);
      cell = in_first ? first : tree_.bisection().half(cell, level, 1);
      index = 2 * splits_before_[level][index] + (in_first ? 0 : 1);
      EXPECT_TRUE(tree_.bisection().box(cell, level + 1).contains(point)) << point.transpose();
    }
  }

private:
  const BoxTree& tree_;
  std::vector<std::vector<std::size_t>> splits_before_;
};

void expectTruth(const Machine& machine, const PavingQuery& wanted, int count)
{
  const Paving paving = pave(machine, wanted);
  ASSERT_TRUE(paving.complete);
  const Finder finder(paving.tree);
  const test::Oracle oracle(machine, wanted.criterion);
  test::RandomBoxes random(SEED);
  int decided = 0;
  for (int k = 0; k < count; ++k)
  {
    const Eigen::Vector3d point = random.pointIn(paving.box);
    const CellState state = finder.at(point);
    if (state == CellState::BOUNDARY)
      continue;
    ++decided;
    ASSERT_EQ(state == CellState::INSIDE, oracle.isGood(point))
        << machine.name() << ", seed " << SEED << ", (" << point.transpose() << ") m";
  }
  EXPECT_GT(decided, count / 2) << machine.name();
}
}  // namespace

TEST(PavingPoints, dextrous)
{
  expectTruth(orthoglide(), test::query(0.04), test::cases(30000));
}

TEST(PavingPoints, dextrousInTheOtherAspect)
{
  expectTruth(orthoglide(), test::query(0.04, Criterion::Set::DEXTROUS, Criterion::Aspect::OTHER), test::cases(10000));
}

TEST(PavingPoints, reachableInEachAspect)
{
  for (const auto aspect : { Criterion::Aspect::BOTH, Criterion::Aspect::OWN, Criterion::Aspect::OTHER })
    expectTruth(orthoglide(), test::query(0.06, Criterion::Set::REACHABLE, aspect), test::cases(10000));
}

TEST(PavingPoints, machinesWithoutSymmetry)
{
  expectTruth(test::crooked(7), test::query(0.08), test::cases(10000));
  PavingQuery limited = test::query(0.08);
  limited.criterion.joint_limits = true;
  expectTruth(test::limited(test::crooked(7)), limited, test::cases(10000));
}

TEST(PavingPoints, inAPlane)
{
  PavingQuery wanted = test::query(0.005);
  wanted.box.reset();
  expectTruth(uranesx(), wanted, test::cases(10000));
}
}  // namespace pkm_workspace
