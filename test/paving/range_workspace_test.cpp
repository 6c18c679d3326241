// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/paving/range_workspace.h"

#include <gtest/gtest.h>

#include <cmath>

#include "pkm_workspace/paving/reachable_volume.h"
#include "pkm_workspace/region/joint_ranges.h"
#include "support/cases.h"
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

Criterion reachable(Criterion::Aspect aspect, bool joint_limits)
{
  Criterion criterion;
  criterion.set = Criterion::Set::REACHABLE;
  criterion.aspect = aspect;
  criterion.joint_limits = joint_limits;
  return criterion;
}

Interval volumeOf(const Machine& machine, const Criterion& criterion, double resolution)
{
  PavingQuery query;
  query.criterion = criterion;
  query.resolution = resolution;
  return reachableVolume(machine, criterion, pave(machine, query));
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
  EXPECT_NEAR(found.other_aspect.mid(), 0.0071, 2e-4);
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

// docs/values.md: 8 (2 - sqrt 2) in both aspects, 4.227 of it in the machine's own.
TEST(ReachableVolume, orthoglideWithoutLimits)
{
  const Interval exact = Interval(8.0) * (Interval(2.0) - sqrt(Interval(2.0)));
  double width = 1.0;
  for (const double resolution : { 0.1, 0.05, 0.025 })
  {
    const Interval both = volumeOf(orthoglide(), reachable(Criterion::Aspect::BOTH, false), resolution);
    EXPECT_TRUE(exact.isSubsetOf(both)) << both;
    EXPECT_LT(both.width(), 0.5 * width);
    width = both.width();
  }
  EXPECT_LT(width, 0.01 * exact.mid());
  const Interval own = volumeOf(orthoglide(), reachable(Criterion::Aspect::OWN, false), 0.025);
  EXPECT_TRUE(own.intersects({ 4.226, 4.228 })) << own;
  test::expectThrow<std::invalid_argument>([] { reachableVolume(orthoglide(), Criterion(), Paving()); }, "reachable");
}

// The share of seeded points that belong to the set, within five standard deviations.
TEST(ReachableVolume, agreesWithSeededPoints)
{
  for (const Machine& kind : { test::crooked(1), test::cone(), orthoglide(0.31058) })
  {
    const Machine machine = test::limited(kind);
    const Criterion criterion = reachable(Criterion::Aspect::OWN, true);
    const BoxTest verdict(machine, criterion);
    const Interval volume = volumeOf(machine, criterion, 0.02 * machine.scale());
    const Box space = test::spaceOf(machine);
    test::RandomBoxes random(SEED);
    const int points = test::cases(100000);
    int hits = 0;
    for (int k = 0; k < points; ++k)
      hits += verdict.margin(random.pointIn(space)) >= 0.0 ? 1 : 0;
    const double share = static_cast<double>(hits) / points;
    const double deviation = std::sqrt(share * (1.0 - share) / points);
    EXPECT_TRUE(volume.intersects(space.volume() * Interval(share - 5 * deviation, share + 5 * deviation)))
        << machine.name() << ", seed " << SEED << ", volume " << volume << ", share " << share;
  }
}

TEST(ReachableVolume, shareOfACubeAboveAPlane)
{
  EXPECT_TRUE(shareAbove(0.0, { 0.3, -0.2, 1.0 }).contains(0.5));
  EXPECT_TRUE((shareAbove(-2.0, { 1.0, 1.0, -1.0 }) * Interval(48.0)).contains(1.0));  // a corner, 1/6 of 8
  EXPECT_TRUE((shareAbove(-1.0, { 1.0, 0.0, 1.0 }) * Interval(8.0)).contains(1.0));    // an edge, 1/2 of 4
  EXPECT_EQ(shareAbove(0.5, { 0.0, 1.0, 0.0 }), Interval(0.75));
  EXPECT_EQ(shareAbove(-1e-300, { 0.0, 0.0, 0.0 }), Interval(0.0));
  EXPECT_EQ(shareAbove(0.0, { 0.0, 0.0, 0.0 }), Interval(1.0));
  test::RandomBoxes random(SEED);
  for (int k = 0; k < test::cases(1000); ++k)
  {
    std::array<double, 3> slopes;
    for (double& slope : slopes)
      slope = random.between(-1.0, 1.0) * std::pow(10.0, random.between(-6.0, 0.0));
    const double constant = random.between(-1.0, 1.0);
    const Interval above = shareAbove(constant, slopes);
    const Interval below = shareAbove(-constant, slopes);
    EXPECT_TRUE((above + below).contains(1.0)) << "seed " << SEED << ", constant " << constant;
    EXPECT_TRUE(above.width() < 1e-2 || std::abs(constant) < 1e-2) << above;
  }
}
}  // namespace pkm_workspace
