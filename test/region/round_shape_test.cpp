// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_bin_float.hpp>

#include "pkm_workspace/region/containment.h"
#include "pkm_workspace/region/region_wish.h"
#include "support/body_points.h"
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
using Exact = boost::multiprecision::cpp_bin_float_100;

std::vector<ShapePtr> roundShapes()
{
  return { makeSphere(), makeDisc(), makeCylinder(0.5), makeCylinder(3.0) };
}

LargestRegion solve(const Machine& machine, const ShapePtr& shape, double accuracy)
{
  RegionQuery query;
  query.shape = shape;
  query.accuracy = accuracy;
  return findLargestRegion(machine, query);
}

bool isInRegion(const Eigen::Vector3d& point, const Eigen::Vector3d& center, double radius)
{
  Exact sum = 0;
  for (int axis = 0; axis < 3; ++axis)
    sum += (Exact(point[axis]) - center[axis]) * (Exact(point[axis]) - center[axis]);
  return sum <= Exact(radius) * radius;
}
}  // namespace

// docs/values.md: 0.5304 and 0.3554.
TEST(RoundShapes, largestOfThePapersMachines)
{
  for (const double accuracy : { 1e-3, 1e-5 })
  {
    const LargestRegion sphere = solve(orthoglide(), makeSphere(), accuracy);
    EXPECT_EQ(sphere.status, LargestRegion::Status::PROVEN);
    EXPECT_GE(sphere.size, 0.53036);
    EXPECT_LE(sphere.size, 0.53045);
    EXPECT_GE(sphere.size_upper_bound, 0.53035);
    EXPECT_LE(sphere.size_upper_bound - sphere.size, accuracy);
    const LargestRegion disc = solve(uranesx(), makeDisc(), accuracy);
    EXPECT_EQ(disc.status, LargestRegion::Status::PROVEN);
    EXPECT_GE(disc.size, 0.35539);
    EXPECT_LE(disc.size, 0.35545);
    EXPECT_GE(disc.size_upper_bound, 0.35535);
  }
}

TEST(RoundShapes, certifiedRegionsAreGoodAndLargerOnesAreNot)
{
  for (const Machine& machine : { orthoglide(), test::crooked(4), test::cone() })
    for (const ShapePtr& shape : roundShapes())
    {
      const LargestRegion region = solve(machine, shape, 1e-3);
      ASSERT_EQ(region.status, LargestRegion::Status::PROVEN) << machine.name() << ' ' << shape->name();
      const BoxTest test(machine, Criterion());
      const test::Oracle oracle(machine, Criterion());
      test::RandomBoxes random(SEED);
      for (int k = 0; k < test::cases(300); ++k)
        EXPECT_TRUE(oracle.isGood(test::pointOf(*shape, region.center, region.size, random)))
            << machine.name() << ' ' << shape->name() << ", seed " << SEED << ", case " << k;
      const Box around{ region.center.array() - 0.05, region.center.array() + 0.05 };
      for (int k = 0; k < test::cases(50); ++k)
      {
        const auto larger = checkContainment(test, *shape, random.pointIn(around), region.size_upper_bound);
        EXPECT_EQ(larger.verdict, Containment::OUTSIDE)
            << machine.name() << ' ' << shape->name() << ", seed " << SEED << ", case " << k;
      }
    }
}

TEST(RoundShapes, containmentAgreesWithTheOracle)
{
  for (const Machine& machine : test::everyKind())
    for (const ShapePtr& shape : roundShapes())
    {
      const BoxTest test(machine, Criterion());
      const test::Oracle oracle(machine, Criterion());
      test::RandomBoxes random(SEED);
      const Box space = test::spaceOf(machine);
      for (int k = 0; k < test::cases(20); ++k)
      {
        const Eigen::Vector3d center = random.pointIn(space);
        const double size = machine.scale() * random.between(0.01, 0.3);
        const ContainmentResult result = checkContainment(test, *shape, center, size);
        ASSERT_NE(result.verdict, Containment::UNDECIDED)
            << machine.name() << ' ' << shape->name() << ", seed " << SEED << ", case " << k;
        EXPECT_FALSE(result.bad_point && oracle.isGood(*result.bad_point))
            << machine.name() << ", seed " << SEED << ", case " << k;
        for (int sample = 0; sample < 10 && !result.bad_point; ++sample)
          EXPECT_TRUE(oracle.isGood(test::pointOf(*shape, center, size, random)))
              << machine.name() << ' ' << shape->name() << ", seed " << SEED << ", case " << k;
      }
    }
}

TEST(RoundShapes, halfSpacesAndBoundsHoldEveryPoint)
{
  test::RandomBoxes random(SEED);
  const Box space{ Eigen::Vector3d::Constant(-3.0), Eigen::Vector3d::Constant(3.0) };
  for (const ShapePtr& shape : roundShapes())
    for (int k = 0; k < test::cases(300); ++k)
    {
      const Eigen::Vector3d center = random.pointIn(space);
      const double size = random.between(0.1, 2.0);
      const Eigen::Vector3d elsewhere = random.pointIn(space);
      const HalfSpace half = shape->halfSpace(Box{ elsewhere, elsewhere }, center, size);
      const Eigen::Vector3d point = test::pointOf(*shape, center, size, random);
      EXPECT_TRUE(shape->contains(point, Box{ center, center }, size));
      Exact along = 0;
      for (int axis = 0; axis < 3; ++axis)
        along += Exact(half.normal[axis]) * point[axis];
      EXPECT_TRUE(along <= half.offset) << shape->name() << ", seed " << SEED << ", case " << k;
      EXPECT_TRUE(shape->boundingBox(center, size).contains(point));
      EXPECT_FALSE(shape->misses(Box{ point, point }, center, size));
      EXPECT_GE(shape->support(enclose(half.normal)).at(size).upper(), half.normal.dot(point - center) - 1e-12);
    }
}

TEST(RoundShapes, pointsOfASphereAreWithinItsRadiusExactly)
{
  test::RandomBoxes random(SEED);
  const Box space{ Eigen::Vector3d::Constant(-2.0), Eigen::Vector3d::Constant(2.0) };
  const ShapePtr sphere = makeSphere();
  for (const GrowingVector& k : sphere->extremePoints())
    EXPECT_TRUE(isInRegion(k.per_size, Eigen::Vector3d::Zero(), 1.0)) << k.per_size.transpose();
  for (int k = 0; k < test::cases(1000); ++k)
  {
    const Eigen::Vector3d point = random.pointIn(space);
    const bool contained = sphere->contains(point, Box{ Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero() }, 1.0);
    EXPECT_EQ(contained, isInRegion(point, Eigen::Vector3d::Zero(), 1.0)) << "seed " << SEED << ", case " << k;
    EXPECT_TRUE(isInRegion(test::pointOf(*sphere, point, 0.7, random), point, 0.7));
  }
}

TEST(RoundShapes, jointRangesHoldEveryPointAndAreTight)
{
  for (const Machine& machine : test::everyKind())
    for (const ShapePtr& shape : roundShapes())
    {
      const double size = 0.1 * machine.scale();
      const auto ranges = jointRanges(machine, *shape, machine.zero(), size);
      const test::Oracle oracle(machine, Criterion());
      test::RandomBoxes random(SEED);
      for (int leg = 0; leg < 3; ++leg)
      {
        const JointRange& range = ranges[static_cast<std::size_t>(leg)];
        EXPECT_LE(range.stroke.width(), 1e-6 * size) << machine.name() << ' ' << shape->name();
        for (int k = 0; k < test::cases(50); ++k)
        {
          const Eigen::Vector3d point = test::pointOf(*shape, machine.zero(), size, random);
          const test::Oracle::Number rho = oracle.joint(leg, { point.x(), point.y(), point.z() });
          EXPECT_TRUE(range.lower.lower() <= rho && rho <= range.upper.upper())
              << machine.name() << ' ' << shape->name() << ", seed " << SEED << ", point " << point.transpose();
        }
      }
    }
}

TEST(RoundShapes, volumesAndDimensions)
{
  EXPECT_NEAR(makeSphere()->volume(0.5).mid(), 0.5235987755982989, 1e-15);
  EXPECT_NEAR(makeCylinder(0.5)->volume(2.0).mid(), 6.283185307179586, 1e-14);
  EXPECT_EQ(makeDisc()->volume(1.0), Interval(0.0));
  EXPECT_EQ(makeSphere()->dimensions(0.5), (std::vector<double>{ 0.5 }));
  EXPECT_EQ(makeDisc()->dimensions(0.5), (std::vector<double>{ 0.0, 0.5 }));
  EXPECT_EQ(makeCylinder(0.25)->dimensions(2.0), (std::vector<double>{ 2.0, 0.5 }));
  for (const double ratio : { 0.0, -1.0, 1e-9, 1e9, std::nan("") })
    test::expectThrow<std::invalid_argument>([&] { makeCylinder(ratio); }, "ratio = .* must be from 1e-6 to 1e6");
}
TEST(RoundShapes, aFreeRatioFindsTheCylinderOfTheLargestVolume)
{
  RegionQuery query;
  setShape({ "cylinder", std::nullopt, RatioRange{ 0.5, 0.8 } }, query);
  query.accuracy = 1e-2;
  const LargestRegion best = findLargestRegion(orthoglide(), query);
  ASSERT_EQ(best.status, LargestRegion::Status::PROVEN) << best.message;
  const double ratio = best.shape->halfExtents().per_size.x();
  EXPECT_GE(ratio, 0.5);
  EXPECT_LE(ratio, 0.8);
  EXPECT_EQ(checkContainment(BoxTest(orthoglide(), query.criterion), *best.shape, best.center, best.size).verdict,
            Containment::INSIDE);
  for (const double other : { 0.5, 0.57, 0.63, 0.7, 0.8 })
  {
    const LargestRegion fixed = solve(orthoglide(), makeCylinder(other), 1e-3);
    EXPECT_LE(fixed.shape->volume(fixed.size).lower(), best.volume_upper_bound) << other;
    EXPECT_LE(fixed.size, best.size_upper_bound) << other;
  }
}

TEST(RoundShapes, refuseRatiosAndNamesThatMakeNoShape)
{
  RegionQuery query;
  const auto set = [&query](const char* name, std::optional<RatioRange> ratio) {
    setShape({ name, std::nullopt, ratio }, query);
  };
  using Bad = std::invalid_argument;
  test::expectThrow<Bad>([&] { set("cylinder", std::nullopt); }, "cylinder needs a ratio");
  test::expectThrow<Bad>([&] { set("cylinder", RatioRange{ 2.0, 1.0 }); }, "ratio = .2, 1. must have the least one");
  test::expectThrow<Bad>([&] { set("cylinder", RatioRange{ 0.0, 1.0 }); }, "ratio = 0 .* must be from 1e-6 to 1e6");
  test::expectThrow<Bad>([&] { set("cube", RatioRange{ 1.0, 1.0 }); }, "for the shape cylinder only.* cube");
  test::expectThrow<Bad>([&] { set("cone", std::nullopt); }, "must be cube, .*disc, cylinder or polytope");
}
}  // namespace pkm_workspace
