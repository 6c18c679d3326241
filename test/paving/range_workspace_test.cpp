// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/paving/range_workspace.h"

#include <gtest/gtest.h>

#include <cmath>

#include "pkm_workspace/region/joint_ranges.h"
#include "support/expect_throw.h"
#include "support/machines.h"
#include "support/random.h"

namespace pkm_workspace
{
namespace
{
using Eigen::Vector3d;

using test::SEED;

JointIntervals equalisedOver(const Machine& machine, const Shape& shape, const Vector3d& center, double size)
{
  const auto over = jointRanges(machine, shape, center, size);
  return equalisedRanges({ over[0].lower, over[1].lower, over[2].lower },
                         { over[0].stroke, over[1].stroke, over[2].stroke });
}
}  // namespace

// docs/values.md: 0.5742 in the machine's aspect, 0.0071 more in the other one.
TEST(RangeWorkspace, orthoglideCube)
{
  RangeQuery query;
  query.ranges = equalisedOver(orthoglide(), *makeCube(), Vector3d::Constant(0.086273015), 0.64395);
  const RangeWorkspace found = workspaceOfRanges(orthoglide(), query);
  EXPECT_TRUE(found.complete);
  EXPECT_LE(found.own_aspect.width(), query.accuracy * found.own_aspect.upper());
  EXPECT_NEAR(found.own_aspect.mid(), 0.5742, 0.001 * 0.5742);
  EXPECT_TRUE(found.other_aspect.contains(0.0071));
  EXPECT_LE(found.other_aspect.width(), query.accuracy * found.own_aspect.upper());
}

// The optimum and the paper's square at (-0.018, 0), with the edge added to the ranges: 2e7 random points give 0.5701
// and 0.5451, each good to 0.0005.
TEST(RangeWorkspace, uranesxSquares)
{
  const Machine machine = uranesx();
  struct Row
  {
    double x, edge, volume;
  };
  for (const Row& row : { Row{ -0.01329, 0.51949, 0.5701 }, Row{ -0.018, 0.510, 0.5451 } })
  {
    RangeQuery query;
    query.ranges = equalisedOver(machine, *makeCube(), { row.x, 0.0, machine.zero().z() }, row.edge);
    const RangeWorkspace found = workspaceOfRanges(machine, query);
    EXPECT_TRUE(found.complete);
    EXPECT_NEAR(found.own_aspect.mid(), row.volume, 1.5e-3);
    EXPECT_EQ(found.other_aspect.upper(), 0.0) << "R - r < L leaves one sign of det A";
  }
}

TEST(RangeWorkspace, rangesBeginWhereTheyDidAndHaveTheLargestStroke)
{
  const JointIntervals equal = equalisedRanges({ Interval(-1.0), Interval(0.0), Interval(2.0) },
                                               { Interval(1.25), Interval(0.5), Interval(0.125) });
  EXPECT_EQ(equal.outer, (std::array<Interval, 3>{ Interval(-1.0, 0.25), Interval(0.0, 1.25), Interval(2.0, 3.25) }));
  EXPECT_EQ(equal.outer, equal.inner);
}

// Whatever the ends are, the ranges hold the inner ones and lie in the outer ones.
TEST(RangeWorkspace, rangesWithEnclosedEnds)
{
  const JointIntervals equal = equalisedRanges({ Interval(-1.0, -0.75), Interval(0.0, 2.0), Interval(2.0) },
                                               { Interval(1.0, 1.5), Interval(0.25, 1.75), Interval(0.5) });
  EXPECT_EQ(equal.outer, (std::array<Interval, 3>{ Interval(-1.0, 1.0), Interval(0.0, 3.75), Interval(2.0, 3.75) }));
  EXPECT_EQ(equal.inner, (std::array<Interval, 3>{ Interval(-0.75, 0.0), Interval::empty(), Interval(2.0, 3.0) }));
}

// A volume for ranges that are known by enclosures brackets that of the inner and that of the outer ones.
TEST(RangeWorkspace, enclosedRangesGiveAWiderBracket)
{
  RangeQuery query;
  const auto volumeWithin = [&query](const std::array<Interval, 3>& inner, const std::array<Interval, 3>& outer) {
    query.ranges.inner = inner;
    query.ranges.outer = outer;
    return workspaceOfRanges(orthoglide(), query);
  };
  const auto all = [](double reach) {
    return std::array<Interval, 3>{ Interval(-reach, reach), Interval(-reach, reach), Interval(-reach, reach) };
  };
  const Interval smaller = volumeWithin(all(0.38), all(0.38)).own_aspect;
  const Interval larger = volumeWithin(all(0.4), all(0.4)).own_aspect;
  const RangeWorkspace between = volumeWithin(all(0.38), all(0.4));
  EXPECT_LE(between.own_aspect.lower(), smaller.lower());
  EXPECT_GE(between.own_aspect.upper(), larger.lower());
  EXPECT_LE(between.own_aspect.upper(), larger.upper());
  EXPECT_GT(between.own_aspect.lower(), 0.0);
  EXPECT_FALSE(between.complete) << "the ranges are not known well enough";
  const std::array<Interval, 3> none = { Interval::empty(), Interval::empty(), Interval::empty() };
  EXPECT_EQ(volumeWithin(none, all(0.4)).own_aspect.lower(), 0.0);
  test::expectThrow<std::invalid_argument>([&] { volumeWithin(all(0.5), all(0.4)); }, "inner range of joint 1");
}

TEST(RangeWorkspace, budgetEndsWithAnHonestBracket)
{
  RangeQuery query;
  query.ranges = std::array<Interval, 3>{ Interval(-0.4, 0.4), Interval(-0.4, 0.4), Interval(-0.4, 0.4) };
  const Interval volume = workspaceOfRanges(orthoglide(), query).own_aspect;
  query.budget.max_boxes = 500;
  const RangeWorkspace stopped = workspaceOfRanges(orthoglide(), query);
  EXPECT_FALSE(stopped.complete);
  EXPECT_TRUE(stopped.own_aspect.intersects(volume));
  EXPECT_LE(stopped.own_aspect.lower(), volume.upper());
}

TEST(RangeWorkspace, refusesRangesWithoutEnds)
{
  RangeQuery query;
  query.ranges.outer[1] = Interval::entire();
  query.accuracy = -1.0;
  test::expectThrow<std::invalid_argument>([&] { workspaceOfRanges(orthoglide(), query); }, "joint 2");
  test::expectThrow<std::invalid_argument>([&] { workspaceOfRanges(orthoglide(), query); }, "accuracy");
}
}  // namespace pkm_workspace
