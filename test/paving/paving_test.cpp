// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/paving/paving.h"

#include <gtest/gtest.h>

#include "support/cases.h"
#include "support/expect_throw.h"
#include "support/machines.h"
#include "support/oracle.h"

namespace pkm_workspace
{
namespace
{
constexpr unsigned SEED = 20260605;

PavingQuery query(double resolution, Criterion::Set set = Criterion::Set::DEXTROUS,
                  Criterion::Aspect aspect = Criterion::Aspect::OWN)
{
  PavingQuery query;
  query.criterion.set = set;
  query.criterion.aspect = aspect;
  query.box = Box{ Eigen::Vector3d::Constant(-1.0), Eigen::Vector3d::Constant(1.0) };
  query.resolution = resolution;
  return query;
}

using Boxes = std::vector<std::vector<Box>>;

bool holds(const Boxes& levels, const Eigen::Vector3d& point)
{
  return std::any_of(levels.begin(), levels.end(), [&](const std::vector<Box>& boxes) {
    return std::any_of(boxes.begin(), boxes.end(), [&](const Box& box) { return box.contains(point); });
  });
}

void expectSameBoxes(const Boxes& a, const Boxes& b)
{
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t level = 0; level < a.size(); ++level)
  {
    ASSERT_EQ(a[level].size(), b[level].size());
    for (std::size_t k = 0; k < a[level].size(); ++k)
      ASSERT_TRUE(a[level][k].lower == b[level][k].lower && a[level][k].upper == b[level][k].upper) << k;
  }
}
}  // namespace

// values.md: 8 (2 - sqrt 2) for both aspects together, 4.227 for the machine's own.
TEST(Paving, reachableVolumeOfTheOrthoglide)
{
  const Interval exact = Interval(8.0) * (Interval(2.0) - sqrt(Interval(2.0)));
  const Paving both = pave(orthoglide(), query(0.05, Criterion::Set::REACHABLE, Criterion::Aspect::BOTH));
  EXPECT_TRUE(both.complete);
  EXPECT_LE(both.volumeLower(), exact.lower());
  EXPECT_GE(both.volumeUpper(), exact.upper());
  EXPECT_LT(both.volumeUpper() - both.volumeLower(), 0.25 * exact.mid());

  const Paving own = pave(orthoglide(), query(0.05, Criterion::Set::REACHABLE));
  EXPECT_LE(own.volumeLower(), 4.227);
  EXPECT_GE(own.volumeUpper(), 4.227);
}

TEST(Paving, dextrousVolumeOfTheOrthoglide)
{
  const Paving own = pave(orthoglide(), query(0.04));
  EXPECT_LE(own.volumeLower(), 1.633);
  EXPECT_GE(own.volumeUpper(), 1.631);
  EXPECT_GT(own.volumeLower(), 1.3);
  EXPECT_LT(own.volumeUpper(), 2.0);
  const Paving other = pave(orthoglide(), query(0.02, Criterion::Set::DEXTROUS, Criterion::Aspect::OTHER));
  EXPECT_LE(other.volumeLower(), 0.0059);
  EXPECT_GE(other.volumeUpper(), 0.0059);
}

TEST(Paving, coversTheSetAndNothingElseIsInside)
{
  for (const Machine& machine : { orthoglide(), test::crooked(7) })
  {
    const PavingQuery wanted = query(0.1);
    const Paving paving = pave(machine, wanted);
    const test::Oracle oracle(machine, wanted.criterion);
    const Boxes inside = paving.tree.boxes(CellState::INSIDE);
    const Boxes boundary = paving.tree.boxes(CellState::BOUNDARY);
    test::RandomBoxes random(SEED);
    for (int k = 0; k < test::cases(1000); ++k)
    {
      const Eigen::Vector3d point = random.pointIn(*wanted.box);
      const bool good = oracle.isGood(point);
      EXPECT_TRUE(!holds(inside, point) || good) << machine.name() << ", seed " << SEED << ", " << point.transpose();
      EXPECT_TRUE(!good || holds(inside, point) || holds(boundary, point))
          << machine.name() << ", seed " << SEED << ", " << point.transpose();
    }
  }
}

TEST(Paving, isTheSameForAnyNumberOfThreads)
{
  PavingQuery wanted = query(0.05);
  const Paving one = pave(orthoglide(), wanted);
  for (const int threads : { 2, 3, 8 })
  {
    wanted.budget.threads = threads;
    const Paving many = pave(orthoglide(), wanted);
    for (const CellState state : { CellState::INSIDE, CellState::BOUNDARY, CellState::OUTSIDE })
      expectSameBoxes(one.tree.boxes(state), many.tree.boxes(state));
    EXPECT_EQ(one.volume_inside, many.volume_inside);
    EXPECT_EQ(one.boxes, many.boxes);
  }
}

TEST(Paving, aBudgetLeavesBoxesPendingAndTheVolumesTrue)
{
  for (const int boxes : { 1, 100, 5000 })
  {
    PavingQuery wanted = query(0.05);
    wanted.budget.max_boxes = boxes;
    const Paving paving = pave(orthoglide(), wanted);
    EXPECT_FALSE(paving.complete);
    EXPECT_GT(paving.tree.count(CellState::PENDING), 0);
    EXPECT_EQ(paving.boxes, boxes);
    EXPECT_LE(paving.volumeLower(), 1.632);
    EXPECT_GE(paving.volumeUpper(), 1.632);
  }
  std::atomic<bool> stop(true);
  PavingQuery wanted = query(0.05);
  wanted.budget.stop = &stop;
  EXPECT_EQ(pave(orthoglide(), wanted).volumeUpper(), 8.0);
}

TEST(Paving, findsItsOwnBoxAndRefusesAnUnboundedOne)
{
  PavingQuery wanted = query(0.2);
  wanted.box.reset();
  const Paving paving = pave(orthoglide(), wanted);
  EXPECT_LE(paving.box.lower.maxCoeff(), -0.8);
  EXPECT_GE(paving.box.upper.minCoeff(), 0.8);
  test::expectThrow<std::invalid_argument>([&] { pave(uranesx(), wanted); }, "parallel.*give a box");
}

TEST(PavingQuery, refusesEverythingThatIsOutOfRangeAtOnce)
{
  PavingQuery wanted = query(-0.1);
  wanted.budget.threads = 5000;
  wanted.box = Box{ { 0.0, 1.0, 0.0 }, { 1.0, 0.0, 1.0 } };
  const auto run = [&wanted] { pave(orthoglide(), wanted); };
  for (const char* pattern : { "resolution = -0.1", "threads = 5000", "box y = \\[1, 0\\] m" })
    test::expectThrow<std::invalid_argument>(run, pattern);
}
}  // namespace pkm_workspace
