// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <limits>

#include "pkm_workspace/dexterity/unbounded.h"
#include "pkm_workspace/region/region_height.h"
#include "pkm_workspace/region/region_wish.h"
#include "support/expect_throw.h"
#include "support/machines.h"

namespace pkm_workspace
{
namespace
{
constexpr double EDGE = 0.643950551;  // docs/values.md, rounded up

void expectHonest(const LargestRegion& region)
{
  EXPECT_EQ(region.status, LargestRegion::Status::STOPPED);
  EXPECT_LE(region.size, EDGE);
  EXPECT_GE(region.size_upper_bound, EDGE - 1e-9);
  EXPECT_FALSE(region.message.empty());
}
}  // namespace

TEST(Budget, boxesRunOutWithAnHonestBracketThatOnlyImproves)
{
  double width = std::numeric_limits<double>::infinity();
  for (const int boxes : { 1, 10, 50, 100, 200 })
  {
    RegionQuery query;
    query.budget.max_boxes = boxes;
    const LargestRegion region = findLargestRegion(orthoglide(), query);
    expectHonest(region);
    EXPECT_EQ(region.boxes, boxes);
    EXPECT_LE(region.size_upper_bound - region.size, width);
    width = region.size_upper_bound - region.size;
  }
  EXPECT_LT(width, 0.3);
}

TEST(Budget, theStopFlagEndsTheSearch)
{
  std::atomic<bool> stop(true);
  RegionQuery query;
  query.budget.stop = &stop;
  const LargestRegion region = findLargestRegion(orthoglide(), query);
  expectHonest(region);
  EXPECT_EQ(region.boxes, 0);
}

TEST(Budget, aTimeLimitThatHasPassedEndsTheSearch)
{
  RegionQuery query;
  query.budget.time_limit = 1e-9;
  expectHonest(findLargestRegion(orthoglide(), query));
}

TEST(Budget, aRegionIsNotMovedAlongTheRailsWhenTheTimeIsOver)
{
  const Machine machine = uranesx();
  RegionQuery query;
  setShape({ "square", std::nullopt, std::nullopt }, query);
  LargestRegion region = findLargestRegion(machine, query);
  const double settled = region.center.z();
  region.center.z() = settled + 0.01;
  std::atomic<bool> stop(true);
  query.budget.stop = &stop;
  const std::int64_t proved = region.verification_boxes;
  settleHeight(machine, query, RunningBudget(query.budget), region);
  EXPECT_EQ(region.center.z(), settled + 0.01);
  EXPECT_EQ(region.verification_boxes, proved);
  stop = false;
  settleHeight(machine, query, RunningBudget(query.budget), region);
  EXPECT_EQ(region.center.z(), settled);
  EXPECT_GT(region.verification_boxes, proved);
}

TEST(Budget, theMemoryEndsTheSearchWithAnHonestBracket)
{
  constexpr std::int64_t BOX_BYTES = sizeof(Box) + 2 * sizeof(double);
  std::int64_t boxes = 0;
  for (const std::int64_t bytes : { Budget::LEAST_MEMORY, std::int64_t(8000), std::int64_t(12000) })
  {
    RegionQuery query;
    query.accuracy = 1e-9;
    query.budget.max_memory = bytes;
    query.budget.max_boxes = 1000000;
    query.progress_period = 0.0;
    query.progress = [bytes](const RegionProgress& state) { EXPECT_LE(3 * state.boxes_open * BOX_BYTES, bytes); };
    const LargestRegion region = findLargestRegion(orthoglide(), query);
    expectHonest(region);
    EXPECT_TRUE(region.out_of_memory);
    EXPECT_EQ(region.message, "the limit of " + std::to_string(bytes) +
                                  " bytes of memory ended the search: the bracket holds, but is wide");
    EXPECT_GT(region.boxes, boxes);
    boxes = region.boxes;
  }
}

TEST(Budget, theMemoryEndsTheSearchOverRatios)
{
  RegionQuery query;
  setShape({ "cylinder", std::nullopt, RatioRange{ 0.5, 0.8 } }, query);
  query.accuracy = 1e-2;
  query.budget.max_boxes = 2000;
  const LargestRegion free = findLargestRegion(orthoglide(), query);
  EXPECT_FALSE(free.out_of_memory);
  query.budget.max_memory = Budget::LEAST_MEMORY;
  const LargestRegion kept = findLargestRegion(orthoglide(), query);
  EXPECT_TRUE(kept.out_of_memory);
  EXPECT_LT(kept.boxes, free.boxes);
  EXPECT_LE(kept.volume, free.volume_upper_bound);
  EXPECT_GE(kept.volume_upper_bound, free.volume);
}

TEST(Budget, anAccuracyBelowDoublesIsSaidToBe)
{
  RegionQuery query;
  query.accuracy = 1e-17;
  query.budget.max_boxes = 20000;
  const LargestRegion region = findLargestRegion(orthoglide(), query);
  expectHonest(region);
  EXPECT_NE(region.message.find("below what this precision can settle"), std::string::npos) << region.message;
  EXPECT_LT(region.size_upper_bound - region.size, 1e-9);
}

TEST(Budget, progressIsReported)
{
  RegionQuery query;
  query.shape = makeSquare();
  query.accuracy = 1e-9;
  int reports = 0;
  std::atomic<bool> stop(false);
  query.budget.stop = &stop;
  query.progress = [&](const RegionProgress& progress) {
    EXPECT_LE(progress.size, progress.size_upper_bound);
    EXPECT_GE(progress.boxes_done, 0);
    stop = ++reports >= 2;
  };
  // a spot inside the square is only just bad (docs/values.md, R - r = 0.3848): the search lasts longer than two
  // reports
  const LargestRegion region = findLargestRegion(uranesx(Interval(0.4848), Interval(0.1)), query);
  EXPECT_EQ(reports >= 2, region.status == LargestRegion::Status::STOPPED);
}

TEST(RegionQuery, refusesEverythingThatIsOutOfRangeAtOnce)
{
  RegionQuery query;
  query.shape = nullptr;
  query.accuracy = 0.0;
  query.criterion.psi_min = -1.0;
  query.budget.time_limit = -1.0;
  query.budget.max_boxes = -5;
  query.budget.max_memory = 4095;
  query.budget.threads = 0;
  query.search_box = Box{ { 1.0, 0.0, 0.0 }, { 0.0, 0.0, std::numeric_limits<double>::infinity() } };
  const auto find = [&query] { findLargestRegion(orthoglide(), query); };
  for (const char* pattern :
       { "shape is missing", "accuracy = 0 .*must be positive", "psi_min = -1", "time_limit = -1 s", "max_boxes = -5",
         "max_memory = 4095 bytes must be at least 4096", "threads = 0 must be from 1 to 1024",
         "search_box x = \\[1, 0\\] m", "search_box z = \\[0, inf\\] m" })
    test::expectThrow<std::invalid_argument>(find, pattern);
}

TEST(RegionQuery, refusesAccuraciesOutOfAllProportion)
{
  RegionQuery query;
  for (const double accuracy : { 1e300, 1e4, 1e-19, 1e-300 })
  {
    query.accuracy = accuracy;
    test::expectThrow<std::invalid_argument>([&] { findLargestRegion(orthoglide(), query); },
                                             "accuracy = 1.* must be from 1e-18 to 1000 for this machine");
  }
  query.shape = makeBox({ 0.01, 0.02, 0.01 });  // sizes are a hundred times larger
  test::expectThrow<std::invalid_argument>([&] { findLargestRegion(orthoglide(), query); }, "from 5e-17 to 50000 ");
}

TEST(RegionQuery, refusesWhatHasNoBound)
{
  RegionQuery query;
  query.shape = makeBox({ 0.0, 0.0, 1.0 });
  test::expectThrow<Unbounded>([&] { findLargestRegion(uranesx(), query); }, "as long as one likes$");

  Machine::Legs legs = uranesx().legs();
  const Interval length = norm(IntervalVector{ 1e-9, 0.0, 1.0 });
  slidingStrut(legs[0]).axis = { Interval(1e-9) / length, 0.0, Interval(1.0) / length };
  const Machine nearly("nearly parallel", legs, uranesx().zero());
  query.shape = makeSquare();
  test::expectThrow<Unbounded>([&] { findLargestRegion(nearly, query); }, "parallel.*longer than 1000 struts$");
  query.search_box = Box{ { -0.1, -0.1, -1.0 }, { 0.1, 0.1, -0.8 } };
  EXPECT_EQ(findLargestRegion(nearly, query).status, LargestRegion::Status::PROVEN);
}

// With a limit on one side only one plane of centers still stands for all, as each place has a height within the
// limits.
TEST(RegionQuery, answersParallelRailsWithHalfOfTheirLimits)
{
  Machine::Legs legs = uranesx().legs();
  for (Leg& leg : legs)
    leg.limits = Interval(-0.05, std::numeric_limits<double>::infinity());
  const Machine half("half limited", legs, uranesx().zero());
  RegionQuery query;
  query.shape = makeSquare();
  query.criterion.joint_limits = true;
  const LargestRegion anywhere = findLargestRegion(half, query);
  EXPECT_EQ(anywhere.status, LargestRegion::Status::PROVEN);
  EXPECT_GE(anywhere.size_upper_bound, 0.5194883);
  for (const JointRange& range : anywhere.joint_ranges)
    EXPECT_GE(range.lower.lower(), -0.05);
  query.search_box = Box{ half.zero() - Eigen::Vector3d::Constant(0.5), half.zero() + Eigen::Vector3d::Constant(0.5) };
  const LargestRegion within = findLargestRegion(half, query);
  EXPECT_EQ(within.status, LargestRegion::Status::PROVEN);
  EXPECT_GE(within.size_upper_bound, 0.5194883);  // there is room for the square of the machine without limits
}
}  // namespace pkm_workspace
