// SPDX-License-Identifier: BSD-3-Clause
// Certified regions of every shape from outside, by an oracle that shares nothing with the proofs: their points are
// good, and above the upper bound every placement has a bad one.
#include <gtest/gtest.h>

#include <Eigen/LU>

#include "pkm_workspace/machine/frame.h"
#include "pkm_workspace/region/containment.h"
#include "pkm_workspace/region/region_wish.h"
#include "support/body_points.h"
#include "support/cases.h"
#include "support/machines.h"
#include "support/oracle.h"
#include "support/random.h"

namespace pkm_workspace
{
namespace test
{
namespace
{
using Eigen::Vector3d;

constexpr double NEAR_BORDER = 1e-9;  // where doubles are not trusted [m, and without unit]

/// Decides points in doubles, and those near the border in 100 digits.
class Judge
{
public:
  explicit Judge(const Machine& machine) : machine_(machine), oracle_(machine, Criterion()) {}

  bool isGood(const Vector3d& point) const
  {
    const auto jacobian = jacobians(machine_, point);
    if (!jacobian)
      return oracle_.isGood(point);
    const Vector3d psi = transmissionFactors(*jacobian);
    const double det = machine_.aspect() * jacobian->a.determinant();
    const double margin = std::min({ psi[0] - 0.5, 2.0 - psi[2], det });
    return std::abs(margin) < NEAR_BORDER ? oracle_.isGood(point) : margin > 0.0;
  }

private:
  Machine machine_;
  Oracle oracle_;
};

/// Whether a bad point of c + K(h) is found: the extreme points first, others afterwards.
bool hasBadPoint(const Judge& judge, const Shape& shape, const Vector3d& center, double size, RandomBoxes& random)
{
  for (const Vector3d& point : pointsOf(shape.extremePoints(), center, size))
    if (!judge.isGood(point))
      return true;
  for (int k = 0; k < 20000; ++k)
    if (!judge.isGood(pointOf(shape, center, size, random)))
      return true;
  return false;
}

/// Centers from all around, and half of them near the best one, where a larger region nearly fits.
void expectHoldsFromOutside(const Machine& machine, const RegionQuery& query, int points, int placements)
{
  const LargestRegion region = findLargestRegion(machine, query);
  SCOPED_TRACE(machine.name() + ", " + region.shape->name() + ", seed " + std::to_string(SEED));
  ASSERT_EQ(region.status, LargestRegion::Status::PROVEN);
  ASSERT_LE(region.size_upper_bound - region.size, query.accuracy);
  const Judge judge(machine);
  RandomBoxes random(SEED);
  for (int k = 0; k < points; ++k)
  {
    const Vector3d point = pointOf(*region.shape, region.center, region.size, random);
    ASSERT_TRUE(judge.isGood(point)) << "case " << k << ", (" << point.transpose() << ") m";
  }
  const double beyond = region.size_upper_bound * (1.0 + 1e-9);
  const Vector3d reach = Vector3d::Constant(query.accuracy);
  for (int k = 0; k < placements; ++k)
  {
    const Box near{ region.center - reach, region.center + reach };
    const Vector3d center = k == 0 ? region.center : random.pointIn(k % 2 == 0 ? near : spaceOf(machine));
    ASSERT_TRUE(hasBadPoint(judge, *region.shape, center, beyond, random))
        << "case " << k << ", center (" << center.transpose() << ") m";
  }
}

RegionQuery outsideQuery(const ShapePtr& shape, double accuracy = 1e-3)
{
  RegionQuery query;
  query.shape = shape;
  query.accuracy = accuracy;
  return query;
}
}  // namespace

// With PKM_WORKSPACE_TEST_CASES=1000: 10^5 points and 10^4 placements of every shape.
TEST(RegionsFromOutside, everyShapeOfEveryMachine)
{
  for (const Machine& machine : { orthoglide(), crooked(4), cone() })
    for (const ShapePtr& shape : { makeCube(), makeSquare(), makeBox({ 1.0, 0.6, 1.3 }), makeSphere(), makeDisc(),
                                   makeCylinder(0.5), makeCylinder(3.0) })
      expectHoldsFromOutside(machine, outsideQuery(shape), cases(100), cases(10));
  for (const ShapePtr& shape : { makeSquare(), makeDisc() })
    expectHoldsFromOutside(uranesx(), outsideQuery(shape), cases(100), cases(10));
}

TEST(RegionsFromOutside, theCylinderOfTheBestRatio)
{
  RegionQuery query = outsideQuery(makeCube(), 1e-2);
  setShape({ "cylinder", std::nullopt, RatioRange{ 0.5, 0.8 } }, query);
  const LargestRegion best = findLargestRegion(orthoglide(), query);
  const Judge judge(orthoglide());
  RandomBoxes random(SEED);
  for (int k = 0; k < cases(100); ++k)
    ASSERT_TRUE(judge.isGood(pointOf(*best.shape, best.center, best.size, random))) << "seed " << SEED;
  const double volume = best.volume_upper_bound * (1.0 + 1e-9);
  for (int k = 0; k < cases(10); ++k)
  {
    const ShapePtr other = makeCylinder(random.between(0.5, 0.8));
    const double size = std::cbrt(volume / other->volume(1.0).lower());
    const Box space{ Vector3d::Constant(-0.3), Vector3d::Constant(0.3) };
    const Vector3d center = k % 2 == 0 ? best.center : random.pointIn(space);
    ASSERT_TRUE(hasBadPoint(judge, *other, center, size, random)) << "seed " << SEED << ", case " << k;
  }
}

// The same machine in another frame: what is found there is as large, and its points turned back are good.
TEST(RegionsFromOutside, turnedMachinesHaveTheSameSphere)
{
  const Pose tilted{ { std::sin(0.2), 0.0, 0.0, std::cos(0.2) }, Vector3d(0.3, -1.0, 2.0) };
  const Pose turned{ { 0.1, -0.5, 0.3, std::sqrt(1.0 - 0.35) }, Vector3d(0.0, 0.0, 0.1) };
  for (const Machine& machine : { orthoglide(), crooked(4), cone() })
  {
    const LargestRegion here = findLargestRegion(machine, outsideQuery(makeSphere(), 1e-4));
    for (const Pose& pose : { tilted, turned })
    {
      const LargestRegion there = findLargestRegion(machineInFrame(machine, pose), outsideQuery(makeSphere(), 1e-4));
      EXPECT_LE(there.size, here.size_upper_bound) << machine.name();
      EXPECT_LE(here.size, there.size_upper_bound) << machine.name();
    }
  }
}

TEST(RegionsFromOutside, aQuarterTurnKeepsTheCubeAndTheRailsDirection)
{
  const double s = std::sqrt(0.5);
  const LargestRegion here = findLargestRegion(crooked(4), outsideQuery(makeCube(), 1e-4));
  for (const Pose& pose :
       { Pose{ { s, 0.0, 0.0, s }, Vector3d(1.0, 2.0, 3.0) }, Pose{ { 0.5, 0.5, 0.5, 0.5 }, Vector3d::Zero() } })
  {
    const LargestRegion there = findLargestRegion(machineInFrame(crooked(4), pose), outsideQuery(makeCube(), 1e-4));
    EXPECT_LE(there.size, here.size_upper_bound);
    EXPECT_LE(here.size, there.size_upper_bound);
  }
  const LargestRegion square = findLargestRegion(uranesx(), outsideQuery(makeSquare(), 1e-4));
  const Pose about_the_rails{ { 0.0, 0.0, s, s }, Vector3d(0.5, 0.0, 1.0) };
  const LargestRegion moved =
      findLargestRegion(machineInFrame(uranesx(), about_the_rails), outsideQuery(makeSquare(), 1e-4));
  EXPECT_LE(moved.size, square.size_upper_bound);
  EXPECT_LE(square.size, moved.size_upper_bound);
}

// A box along the axes of a frame that is turned by 30 degrees: its points, turned back, are judged by the original.
TEST(RegionsFromOutside, boxesInATurnedFrame)
{
  const double half_angle = 15.0 * 3.141592653589793 / 180.0;
  const Pose pose{ { 0.0, std::sin(half_angle), 0.0, std::cos(half_angle) }, Vector3d(0.2, 0.1, -0.4) };
  const Pose back{ { 0.0, -std::sin(half_angle), 0.0, std::cos(half_angle) }, Vector3d::Zero() };
  const Machine machine = crooked(4);
  const BoxTest test(machineInFrame(machine, pose), Criterion());
  const Judge judge(machine);
  RandomBoxes random(SEED);
  int inside = 0;
  for (int k = 0; k < cases(100); ++k)
  {
    const Box around{ machine.zero().array() - 0.4, machine.zero().array() + 0.4 };
    const Vector3d center = mid(transformed(pose, enclose(random.pointIn(around))));
    const double size = random.between(0.05, 0.4);
    const ShapePtr shape = makeBox({ 1.0, 0.5, 0.7 });
    const ContainmentResult result = checkContainment(test, *shape, center, size);
    ASSERT_NE(result.verdict, Containment::UNDECIDED) << "seed " << SEED << ", case " << k;
    inside += result.verdict == Containment::INSIDE ? 1 : 0;
    const auto original = [&](const Vector3d& p) -> Vector3d {
      return mid(transformed(back, enclose(Vector3d(p - pose.translation))));
    };
    EXPECT_FALSE(result.bad_point && judge.isGood(original(*result.bad_point))) << "case " << k;
    for (int sample = 0; sample < 20 && !result.bad_point; ++sample)
      EXPECT_TRUE(judge.isGood(original(pointOf(*shape, center, size, random)))) << "case " << k;
  }
  EXPECT_GT(inside, cases(10));
}
}  // namespace test
}  // namespace pkm_workspace
