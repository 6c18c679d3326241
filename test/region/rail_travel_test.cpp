// SPDX-License-Identifier: BSD-3-Clause
// Parallel rails with joint limits: places are searched, centers are proved. Held against the search over all centers,
// for a machine with the same numbers that is not known to have parallel rails, and against an oracle.
#include "pkm_workspace/region/rail_travel.h"
#include "pkm_workspace/machine/rails.h"

#include <gtest/gtest.h>

#include "region/parallel_rails.h"
#include "support/body_points.h"
#include "support/cases.h"
#include "support/oracle.h"

namespace pkm_workspace
{
namespace test
{
namespace
{
using Eigen::Vector3d;

void expectTheSame(const Machine& machine, const RegionQuery& query)
{
  const LargestRegion region = expectProven(machine, query);
  RegionQuery within_budget = query;
  within_budget.budget.max_boxes = 5000;  // ended early its bracket is wider, and holds
  const LargestRegion general = findLargestRegion(withoutSharedDirection(machine), within_budget);
  EXPECT_LE(region.size, general.size_upper_bound) << machine.name() << ", " << query.shape->name();
  EXPECT_LE(general.size, region.size_upper_bound) << machine.name() << ", " << query.shape->name();
  EXPECT_LE(region.boxes, 2 * general.boxes + 32) << machine.name() << ", " << query.shape->name();
}

bool hasBadPoint(const Oracle& oracle, const Shape& shape, const Vector3d& center, double size, RandomBoxes& random)
{
  for (const Vector3d& point : pointsOf(shape.extremePoints(), center, size))
    if (!oracle.isGood(point))
      return true;
  for (const Circle& rim : shape.extremeCircles(center, size))
    for (int k = 0; k < 1000; ++k)
    {
      const double angle = 2.0 * M_PI * k / 1000.0;
      const Vector3d point = mid(rim.center) + rim.radius.mid() * Vector3d(std::cos(angle), std::sin(angle), 0.0);
      if (!oracle.isGood(nearestInside(shape, point, center, size).value_or(center)))
        return true;
    }
  for (int k = 0; k < 3000; ++k)
    if (!oracle.isGood(pointOf(shape, center, size, random)))
      return true;
  return false;
}

/// Points of the region are good; a larger one has a bad point wherever it is put, near by more often than not.
void expectHoldsFromOutside(const Machine& machine, const RegionQuery& query)
{
  const LargestRegion region = expectProven(machine, query);
  SCOPED_TRACE(machine.name() + ", " + query.shape->name() + ", seed " + std::to_string(SEED));
  const Oracle oracle(machine, query.criterion);
  RandomBoxes random(SEED);
  for (int k = 0; k < cases(60); ++k)
  {
    const Vector3d point = pointOf(*region.shape, region.center, region.size, random);
    ASSERT_TRUE(oracle.isGood(point)) << "case " << k << ", (" << point.transpose() << ") m";
  }
  const double beyond = region.size_upper_bound * (1.0 + 1e-9);
  for (int k = 0; k < cases(30); ++k)
  {
    const Vector3d reach = Vector3d::Constant(k % 3 == 0 ? 0.5 : k % 3 == 1 ? 0.05 : query.accuracy);
    const Vector3d center = random.pointIn({ region.center - reach, region.center + reach });
    ASSERT_TRUE(hasBadPoint(oracle, *region.shape, center, beyond, random))
        << "case " << k << ", center (" << center.transpose() << ") m";
  }
}
}  // namespace

TEST(RailTravel, theSearchOverAllCentersFindsTheSame)
{
  for (unsigned seed = SEED; seed < SEED + 3; ++seed)
    for (const ShapePtr& shape : everyShape())
      expectTheSame(withParallelRails(seed), queryFor(shape, 1e-2));
}

TEST(RailTravel, theSearchOverAllCentersFindsTheSameAlongAnyDirection)
{
  for (unsigned seed = SEED; seed < SEED + 2; ++seed)
    for (const ShapePtr& shape : { makeCube(), makeDisc() })
      for (const Machine& machine : { leaning(withParallelRails(seed)), lyingAlongX(withParallelRails(seed)) })
        expectTheSame(machine, queryFor(shape, 1e-2));
}

TEST(RailTravel, regionsHoldFromOutside)
{
  for (unsigned seed = SEED; seed < SEED + 2; ++seed)
    for (const Machine& machine : { withParallelRails(seed), leaning(withParallelRails(seed)) })
      for (const ShapePtr& shape : everyShape())
        expectHoldsFromOutside(machine, queryFor(shape, 1e-3));
}

TEST(RailTravel, aSearchBoxBoundsTheCenterOnly)
{
  RandomBoxes random(SEED);
  for (unsigned seed = SEED; seed < SEED + 2; ++seed)
    for (const Machine& machine :
         { withParallelRails(seed), leaning(withParallelRails(seed)), lyingAlongX(withParallelRails(seed)) })
      for (const bool limits : { true, false })
      {
        RegionQuery query = queryFor(makeCube(), 1e-2);
        query.criterion.joint_limits = limits;
        query.search_box = random.boxIn({ machine.zero().array() - 0.1, machine.zero().array() + 0.1 }, 0.3);
        expectTheSame(machine, query);
        const LargestRegion region = findLargestRegion(machine, query);
        EXPECT_TRUE(query.search_box->contains(region.center)) << machine.name();
      }
}

// Where a thin box lies across the rails its places have one height each, the outermost ones at the ends of the travel.
TEST(RailTravel, theEndsOfASearchBoxCount)
{
  for (const Machine& machine : { leaning(withParallelRails(SEED)), leaning(withParallelRails(SEED + 1)) })
    for (int axis = 0; axis < 3; ++axis)
    {
      RegionQuery query = queryFor(makeCube(), 1e-3);
      query.criterion.joint_limits = false;
      const Vector3d reach = Vector3d::Constant(1e-3) + 0.1 * Vector3d::Unit(axis);
      query.search_box = Box{ machine.zero() - reach, machine.zero() + reach };
      expectTheSame(machine, query);
    }
}

TEST(RailTravel, aGivenCenterIsKept)
{
  const Machine machine = leaning(withParallelRails(SEED));
  RegionQuery query = queryFor(makeSphere(), 1e-6);
  const LargestRegion best = expectProven(machine, query);
  const LargestRegion there = largestRegionAt(machine, query, best.center);
  EXPECT_EQ(there.center, best.center);
  EXPECT_LE(there.size, best.size_upper_bound);
  EXPECT_GE(there.size_upper_bound, best.size);
  const LargestRegion besides = largestRegionAt(machine, query, machine.zero());
  EXPECT_GT(besides.size, 0.0);
  EXPECT_EQ(besides.center, machine.zero());
  EXPECT_EQ(besides.status, LargestRegion::Status::PROVEN);
}

// Limits on one side leave every place some travel: only the centers differ from those without limits.
TEST(RailTravel, limitsOnOneSideCostNothing)
{
  for (const bool upward : { true, false })
    for (const Machine& both : { withParallelRails(SEED), leaning(withParallelRails(SEED)) })
    {
      Machine::Legs legs = both.legs();
      for (Leg& leg : legs)
        leg.limits = (parallelSense(legs[0], leg) > 0) == upward ? Interval(leg.limits.lower(), INF)
                                                                 : Interval(-INF, leg.limits.upper());
      const Machine machine("one-sided", legs, both.zero());
      RegionQuery query = queryFor(makeSquare(), 1e-3);
      const LargestRegion limited = expectProven(machine, query);
      const Oracle oracle(machine, query.criterion);
      RandomBoxes random(SEED);
      for (int k = 0; k < cases(100); ++k)
        EXPECT_TRUE(oracle.isGood(pointOf(*query.shape, limited.center, limited.size, random)));
      query.criterion.joint_limits = false;
      const LargestRegion free = expectProven(machine, query);
      EXPECT_EQ(limited.boxes, free.boxes);
      EXPECT_EQ(limited.size_upper_bound, free.size_upper_bound);
    }
}

// One rail bounds from below, another one from above.
TEST(RailTravel, limitsOnOneSideOfTwoRailsBindTogether)
{
  Machine::Legs legs = withParallelRails(SEED).legs();
  const auto oneSided = [&legs](std::size_t leg, bool from_below) {
    const bool same = parallelSense(legs[0], legs[leg]) > 0;
    const Interval& limits = legs[leg].limits;
    return same == from_below ? Interval(limits.lower(), INF) : Interval(-INF, limits.upper());
  };
  legs[0].limits = oneSided(0, true);
  legs[1].limits = oneSided(1, false);
  legs[2].limits = Interval::entire();
  const Machine machine("from both sides", legs, Vector3d::Zero());
  for (const ShapePtr& shape : { makeCube(), makeBox({ 0.0, 0.0, 1.0 }) })
    expectHoldsFromOutside(machine, queryFor(shape, 1e-3));
}

TEST(RailTravel, limitsThatLeaveNoTravelLeaveNothing)
{
  Machine::Legs legs = withParallelRails(SEED).legs();
  legs[0].limits = Interval(5.0, 6.0);
  const Machine upright("apart", legs, Vector3d::Zero());
  for (const Machine& machine : { upright, leaning(upright) })
  {
    const LargestRegion region = findLargestRegion(machine, queryFor(makeCube(), 1e-3));
    EXPECT_EQ(region.status, LargestRegion::Status::NONE);
    EXPECT_EQ(region.size, 0.0);
  }
}
}  // namespace test
}  // namespace pkm_workspace
