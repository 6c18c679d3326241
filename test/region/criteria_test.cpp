// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "pkm_workspace/region/largest_region.h"
#include "support/cases.h"
#include "support/expect_throw.h"
#include "support/machines.h"
#include "support/oracle.h"
#include "support/random.h"

namespace pkm_workspace
{
namespace
{
using test::SEED;

RegionQuery cubeQuery(const Criterion& criterion, double accuracy = 1e-3)
{
  RegionQuery query;
  query.criterion = criterion;
  query.accuracy = accuracy;
  return query;
}

Criterion onlyReachable()
{
  Criterion criterion;
  criterion.set = Criterion::Set::REACHABLE;
  return criterion;
}

/// Points of the certified region are good, among them its corners; a region of the upper bound has a bad point, at any
/// of the random centers.
void expectHoldsFromOutside(const Machine& machine, const RegionQuery& query, const LargestRegion& region)
{
  SCOPED_TRACE(machine.name() + ", " + describe(query.criterion) + ", seed " + std::to_string(SEED));
  const test::Oracle oracle(machine, query.criterion);
  test::RandomBoxes random(SEED);
  const Eigen::Vector3d half = Eigen::Vector3d::Constant(0.5 * region.size * (1.0 - 1e-12));
  const Box cube{ region.center - half, region.center + half };
  for (int k = 0; k < test::cases(300); ++k)
  {
    Eigen::Vector3d point = random.pointIn(cube);
    for (int axis = 0; axis < 3 && k < 8; ++axis)
      point[axis] = (k >> axis & 1 ? cube.upper : cube.lower)[axis];
    EXPECT_TRUE(oracle.isGood(point)) << point.transpose();
  }
  const Eigen::Vector3d beyond = Eigen::Vector3d::Constant(0.5 * region.size_upper_bound * (1.0 + 1e-12));
  for (int k = 0; k < test::cases(30); ++k)
  {
    const Eigen::Vector3d center = k == 0 ? region.center : random.pointIn(test::spaceOf(machine));
    bool is_good = true;
    for (int corner = 0; corner < 8; ++corner)
      is_good = is_good && oracle.isGood(Eigen::Vector3d(center.x() + (corner & 1 ? 1 : -1) * beyond.x(),
                                                         center.y() + (corner & 2 ? 1 : -1) * beyond.y(),
                                                         center.z() + (corner & 4 ? 1 : -1) * beyond.z()));
    EXPECT_FALSE(is_good) << center.transpose() << ": all corners of a larger cube are good";
  }
}

LargestRegion expectProven(const Machine& machine, const RegionQuery& query)
{
  const LargestRegion region = findLargestRegion(machine, query);
  EXPECT_EQ(region.status, LargestRegion::Status::PROVEN) << describe(query.criterion) << ": " << region.message;
  expectHoldsFromOutside(machine, query, region);
  return region;
}
}  // namespace

// Force factors are the reciprocals of velocity factors: [1/2, 2] of the one are [1/2, 2] of the other.
TEST(Criteria, forceFactorsGiveTheSameCube)
{
  Criterion force = onlyReachable();
  force.force_min = 0.5;
  force.force_max = 2.0;
  const LargestRegion by_force = expectProven(orthoglide(), cubeQuery(force));
  const LargestRegion by_velocity = findLargestRegion(orthoglide(), cubeQuery(Criterion()));
  EXPECT_EQ(by_force.size, by_velocity.size);
  EXPECT_EQ(by_force.size_upper_bound, by_velocity.size_upper_bound);
  EXPECT_EQ(by_force.boxes, by_velocity.boxes);
}

TEST(Criteria, eachSideOfTheFactorsCountsByItself)
{
  Criterion above = onlyReachable();
  above.force_min = 0.5;
  Criterion below = onlyReachable();
  below.force_max = 2.0;
  const LargestRegion region_above = expectProven(orthoglide(), cubeQuery(above));
  const LargestRegion region_below = expectProven(orthoglide(), cubeQuery(below));
  const LargestRegion both = findLargestRegion(orthoglide(), cubeQuery(Criterion()));
  EXPECT_LT(both.size, region_above.size_upper_bound);
  EXPECT_LE(both.size, region_below.size_upper_bound);
}

TEST(Criteria, conditionNumberBoundsTheCube)
{
  double last = 0.0;
  for (const double kappa_max : { 1.5, 2.0, 4.0 })
  {
    Criterion criterion = onlyReachable();
    criterion.kappa_max = kappa_max;
    const LargestRegion region = expectProven(orthoglide(), cubeQuery(criterion));
    EXPECT_GT(region.size, last) << "a weaker bound leaves a larger cube";
    last = region.size;
  }
}

TEST(Criteria, conditionNumberAtFineAccuracyAndForCrookedMachines)
{
  Criterion criterion = onlyReachable();
  criterion.kappa_max = 3.0;
  for (const Machine& machine : { orthoglide(), test::crooked(1), test::crooked(2, 1000.0) })
    expectProven(machine, cubeQuery(criterion, 1e-6 * machine.scale()));
}

TEST(Criteria, aConjunctionIsNoLargerThanItsParts)
{
  Criterion condition = onlyReachable();
  condition.kappa_max = 2.0;
  Criterion all;
  all.kappa_max = 2.0;
  all.force_max = 1.8;
  all.joint_limits = true;
  const Machine machine = test::limited(orthoglide());
  const LargestRegion part = expectProven(machine, cubeQuery(condition));
  const LargestRegion whole = expectProven(machine, cubeQuery(all));
  EXPECT_GT(whole.size, 0.0);
  EXPECT_LE(whole.size, part.size_upper_bound);
}

// Without a sign of det A the reachable set of the Orthoglide is the intersection of three cylinders of radius L: its
// largest cube has an edge of sqrt(2) L and its center in the origin.
TEST(Criteria, reachabilityAloneInEitherAspect)
{
  Criterion criterion = onlyReachable();
  criterion.aspect = Criterion::Aspect::BOTH;
  const LargestRegion region = expectProven(orthoglide(), cubeQuery(criterion));
  EXPECT_LE(region.size, sqrt(Interval(2.0)).upper());
  EXPECT_GE(region.size_upper_bound, sqrt(Interval(2.0)).lower());
}

TEST(Criteria, boundedFactorsLieInOneAspect)
{
  for (const int kind : { 0, 1, 2 })
  {
    Criterion criterion = kind == 0 ? Criterion() : onlyReachable();
    criterion.aspect = Criterion::Aspect::BOTH;
    criterion.kappa_max = kind == 1 ? 2.0 : 0.0;
    criterion.force_max = kind == 2 ? 2.0 : 0.0;
    test::expectThrow<std::invalid_argument>([&] { findLargestRegion(orthoglide(), cubeQuery(criterion)); },
                                             "lies in one aspect");
  }
}
}  // namespace pkm_workspace
