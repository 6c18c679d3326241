// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/paving/paving.h"

#include <gtest/gtest.h>

#include "paving/pavings.h"
#include "pkm_workspace/dexterity/unbounded.h"
#include "support/expect_throw.h"
#include "support/machines.h"

namespace pkm_workspace
{
namespace
{
using test::query;
}  // namespace

// docs/values.md: 8 (2 - sqrt 2) for both aspects together, 4.227 for the machine's own.
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

TEST(Paving, isTheSameForAnyNumberOfThreads)
{
  PavingQuery wanted = query(0.05);
  const Paving one = pave(orthoglide(), wanted);
  for (const int threads : { 2, 3, 8 })
  {
    wanted.budget.threads = threads;
    const Paving many = pave(orthoglide(), wanted);
    test::expectSame(one, many);
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

TEST(Paving, keepsToItsMemory)
{
  PavingQuery wanted = query(0.02);
  const Paving free = pave(orthoglide(), wanted);
  std::int64_t boxes = 0;
  for (const std::int64_t bytes : { Budget::LEAST_MEMORY, std::int64_t(30000), std::int64_t(1000000) })
  {
    wanted.budget.max_memory = bytes;
    wanted.budget.threads = 1;
    const Paving one = pave(orthoglide(), wanted);
    wanted.budget.threads = 3;
    test::expectSame(one, pave(orthoglide(), wanted));
    EXPECT_LE(static_cast<std::int64_t>(one.tree.bytes()), bytes);
    EXPECT_FALSE(one.complete);
    EXPECT_LE(one.volumeLower(), free.volumeLower());
    EXPECT_GE(one.volumeUpper(), free.volumeUpper());
    EXPECT_GT(one.boxes, boxes);
    boxes = one.boxes;
  }
  wanted.budget.max_memory = 20000000;
  test::expectSame(free, pave(orthoglide(), wanted));
}

TEST(Paving, tellsProgress)
{
  constexpr double ROUNDING = 1e-12;  // of sums in another order [m^3]
  PavingQuery wanted = query(5e-4);
  std::atomic<bool> stop(false);
  std::vector<PavingProgress> told;
  wanted.budget.stop = &stop;
  wanted.progress = [&](const PavingProgress& state) {
    told.push_back(state);
    stop = told.size() >= 2;
  };
  const Paving paving = pave(orthoglide(), wanted);
  ASSERT_GE(told.size(), 2U);
  for (const PavingProgress& state : told)
  {
    EXPECT_LE(state.volume_inside, paving.volumeLower() + ROUNDING);
    EXPECT_GE(state.volume_inside + state.volume_boundary, paving.volumeUpper() - ROUNDING);
    EXPECT_GT(state.boxesPerSecond(), 0.0);
    EXPECT_LE(state.boxes, paving.boxes);
  }
}

TEST(Paving, findsItsOwnBoxAndRefusesAnUnboundedOne)
{
  PavingQuery wanted = query(0.2);
  wanted.box.reset();
  const Paving paving = pave(orthoglide(), wanted);
  EXPECT_LE(paving.box.lower.maxCoeff(), -0.8);
  EXPECT_GE(paving.box.upper.minCoeff(), 0.8);
  test::expectThrow<Unbounded>([&] { pave(test::nearlyParallel(), wanted); }, "parallel.*1000 struts$");
  wanted.criterion.joint_limits = true;  // of which the machine has one, upward only
  Machine::Legs legs = uranesx().legs();
  legs[1].limits = Interval(-0.1, std::numeric_limits<double>::infinity());
  const Machine half_bounded("half_bounded", legs, uranesx().zero());
  const std::string rails =
      "parallel.*1000 struts; the joints go: 'rail_1' without limits, 'rail_2' from -0.1 m upwards, 'rail_3' without "
      "limits";
  test::expectThrow<Unbounded>([&] { pave(half_bounded, wanted); }, rails + "$");
  test::expectThrow<std::invalid_argument>(
      [&] {
        withRemedy({ "joint_limits = ON", "a box by use_box" }, [&] { return pave(half_bounded, wanted); });
      },
      rails + ": ask for closer joint limits at both ends of a rail, or for a box by use_box$");
  wanted.box = Box{ { -0.2, -0.2, -1.0 }, { 0.2, 0.2, 0.0 } };
  EXPECT_TRUE(pave(half_bounded, wanted).complete);
}

TEST(PavingQuery, refusesEverythingThatIsOutOfRangeAtOnce)
{
  PavingQuery wanted = query(-0.1);
  wanted.budget.threads = 5000;
  wanted.budget.max_memory = 4095;
  wanted.box = Box{ { 0.0, 1.0, 0.0 }, { 1.0, 0.0, 1.0 } };
  const auto run = [&wanted] { pave(orthoglide(), wanted); };
  for (const char* pattern :
       { "resolution = -0.1", "threads = 5000", "max_memory = 4095 bytes", "box y = \\[1, 0\\] m" })
    test::expectThrow<std::invalid_argument>(run, pattern);
}
}  // namespace pkm_workspace
