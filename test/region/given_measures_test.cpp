// SPDX-License-Identifier: BSD-3-Clause
// The largest regions of families that grow from given measures.
#include <gtest/gtest.h>

#include "pkm_workspace/dexterity/unbounded.h"
#include "pkm_workspace/region/containment.h"
#include "pkm_workspace/region/region_parts.h"
#include "pkm_workspace/report/largest_sentence.h"
#include "region/parallel_rails.h"
#include "support/cases.h"
#include "support/expect_throw.h"
#include "support/oracle.h"

namespace pkm_workspace
{
namespace
{
using Eigen::Vector3d;
using test::cases;
using test::Oracle;
using test::RandomBoxes;
using test::SEED;

/// A family, and the solid that its region of a size is, about its middle.
struct Family
{
  ShapePtr shape;
  ShapePtr (*solid)(double size);
  bool is_on_base;

  Vector3d middle(const Vector3d& center, double size) const
  {
    return center + (is_on_base ? 0.5 * size : 0.0) * Vector3d::UnitZ();
  }
};

std::vector<Family> families()
{
  return {
    { makeCylinderOfRadius(0.25, Stand::ON_BASE), [](double h) { return makeCylinder(0.25, h); }, true },
    { makeCylinderOfRadius(0.25, Stand::ABOUT_CENTER), [](double h) { return makeCylinder(0.25, h); }, false },
    { makeCylinderOfHeight(0.375), [](double r) { return makeCylinder(r, 0.375); }, false },
    { makeBoxOnBase(0.5, 0.125),
      [](double h) {
        return makeBox({ 0.5, 0.125, h });
      },
      true },
  };
}

Machine limitedUranesx()
{
  Machine::Legs legs = uranesx().legs();
  for (Leg& leg : legs)
    leg.limits = Interval(-0.3, 0.3);
  return Machine("limited", legs, uranesx().zero());
}

std::vector<Machine> machines()
{
  return { orthoglide(), limitedUranesx(), test::withParallelRails(SEED) };
}

/// A point of the solid of that size, from its definition: on its surface more often than not.
Vector3d pointOf(const Family& family, const Vector3d& center, double size, RandomBoxes& random)
{
  const ShapePtr solid = family.solid(size);
  const Vector3d middle = family.middle(center, size);
  const Vector3d reach = 0.75 * (solid->boundingBox(middle, 1.0).upper - middle);
  const Vector3d far = random.pointIn({ middle - 2.0 * reach, middle + 2.0 * reach });
  return nearestInside(*solid, far, middle, 1.0).value_or(middle);
}

bool hasBadPoint(const Oracle& oracle, const Family& family, const Vector3d& center, double size, RandomBoxes& random)
{
  const ShapePtr solid = family.solid(size);
  for (const Vector3d& point : pointsOf(solid->extremePoints(), family.middle(center, size), 1.0))
    if (!oracle.isGood(point))
      return true;
  for (int k = 0; k < 3000; ++k)
    if (!oracle.isGood(pointOf(family, center, size, random)))
      return true;
  return false;
}

std::string nameOf(const Machine& machine, const Family& family)
{
  return machine.name() + ", " + family.shape->name() + ", seed " + std::to_string(SEED);
}
}  // namespace

TEST(GivenMeasures, regionsAreGoodAndLargerOnesAreNot)
{
  for (const Machine& machine : machines())
    for (const Family& family : families())
    {
      SCOPED_TRACE(nameOf(machine, family));
      const RegionQuery query = test::queryFor(family.shape, 1e-3);
      const LargestRegion region = test::expectProven(machine, query);
      EXPECT_GT(region.size, 0.05);
      const Oracle oracle(machine, query.criterion);
      RandomBoxes random(SEED);
      for (int k = 0; k < cases(200); ++k)
      {
        const double size = k % 2 == 0 ? region.size : random.between(0.0, 1.0) * region.size;
        ASSERT_TRUE(oracle.isGood(pointOf(family, region.center, size, random))) << "case " << k;
      }
      const double beyond = region.size_upper_bound * (1.0 + 1e-9);
      for (int k = 0; k < cases(40); ++k)
      {
        const Vector3d reach = Vector3d::Constant(k % 3 == 0 ? 0.5 : k % 3 == 1 ? 0.05 : query.accuracy);
        const Vector3d center =
            k == 0 ? region.center : random.pointIn({ region.center - reach, region.center + reach });
        ASSERT_TRUE(hasBadPoint(oracle, family, center, beyond, random))
            << "case " << k << ", center (" << center.transpose() << ") m";
      }
    }
}

TEST(GivenMeasures, noCenterOfAGridCarriesALargerOne)
{
  constexpr int GRID = 15;
  const Machine machine = orthoglide();
  for (const Family& family : families())
  {
    SCOPED_TRACE(nameOf(machine, family));
    const RegionQuery query = test::queryFor(family.shape, 1e-2);
    const LargestRegion region = test::expectProven(machine, query);
    const Oracle oracle(machine, query.criterion);
    RandomBoxes random(SEED);
    const double beyond = region.size_upper_bound * (1.0 + 1e-9);
    for (int index = 0; index < GRID * GRID * GRID; ++index)
    {
      const Vector3d step(index % GRID, index / GRID % GRID, index / (GRID * GRID));
      const Vector3d center = (2.0 / (GRID - 1) * step).array() - 1.0;
      ASSERT_TRUE(hasBadPoint(oracle, family, center, beyond, random)) << center.transpose();
    }
  }
}

// The same sets of points, seen from their base and from their middle; and as one among solids of a proportion.
TEST(GivenMeasures, bracketsAgreeWithThoseOfOtherFamilies)
{
  for (const Machine& machine : machines())
  {
    const auto solve = [&](const ShapePtr& shape) { return test::expectProven(machine, test::queryFor(shape, 1e-3)); };
    const LargestRegion standing = solve(makeCylinderOfRadius(0.25, Stand::ON_BASE));
    const LargestRegion about = solve(makeCylinderOfRadius(0.25, Stand::ABOUT_CENTER));
    EXPECT_LE(standing.size, about.size_upper_bound) << machine.name();
    EXPECT_LE(about.size, standing.size_upper_bound) << machine.name();
    const LargestRegion cylinder = solve(makeCylinder(0.5));
    const double radius = (Interval(0.5) * Interval(cylinder.size)).lower();
    EXPECT_GE(solve(makeCylinderOfRadius(radius, Stand::ON_BASE)).size_upper_bound, cylinder.size) << machine.name();
    EXPECT_GE(solve(makeCylinderOfHeight(cylinder.size)).size_upper_bound, radius) << machine.name();
    const LargestRegion cube = solve(makeCube());
    const LargestRegion on_base = solve(makeBoxOnBase(cube.size, cube.size));
    EXPECT_GE(on_base.size_upper_bound, cube.size) << machine.name();
    EXPECT_GE(solve(makeBoxOnBase(0.9 * cube.size, 0.9 * cube.size)).size, cube.size - 1e-3) << machine.name();
  }
}

TEST(GivenMeasures, containmentRangesAndConditioningAreThoseOfTheSolid)
{
  for (const Machine& machine : machines())
    for (const Family& family : families())
    {
      SCOPED_TRACE(nameOf(machine, family));
      const BoxTest test(machine, Criterion());
      RandomBoxes random(SEED);
      int inside = 0;
      for (int k = 0; k < cases(20); ++k)
      {
        const Vector3d center = machine.zero() + random.pointIn({ Vector3d::Constant(-0.2), Vector3d::Constant(0.2) });
        const double size = std::ldexp(random.between(64.0, 512.0), -10);
        const ShapePtr solid = family.solid(size);
        const Vector3d middle = family.middle(center, size);
        const ContainmentResult result = checkContainment(test, *family.shape, center, size);
        EXPECT_EQ(result.verdict, checkContainment(test, *solid, middle, 1.0).verdict) << "case " << k;
        if (result.verdict != Containment::INSIDE)
          continue;
        ++inside;
        const auto ranges = jointRanges(machine, *family.shape, center, size);
        const auto expected = jointRanges(machine, *solid, middle, 1.0);
        for (std::size_t leg = 0; leg < 3; ++leg)
        {
          EXPECT_NEAR(ranges[leg].lower.mid(), expected[leg].lower.mid(), 1e-11) << "case " << k;
          EXPECT_NEAR(ranges[leg].upper.mid(), expected[leg].upper.mid(), 1e-11) << "case " << k;
          EXPECT_LE(ranges[leg].lower.width() + ranges[leg].upper.width(), 1e-11) << "case " << k;
          EXPECT_NEAR(ranges[leg].across.mid(), expected[leg].across.mid(), 1e-11) << "case " << k;
        }
      }
      EXPECT_GT(inside, 0);
    }
}

TEST(GivenMeasures, haveTheConditioningOfTheSolid)
{
  for (const Family& family : families())
  {
    ConditioningQuery query;
    query.accuracy = 0.05;
    const Vector3d center(0.1, 0.05, 0.0625);
    const auto index = globalConditioning(orthoglide(), *family.shape, center, 0.25, query);
    const auto expected =
        globalConditioning(orthoglide(), *family.solid(0.25), family.middle(center, 0.25), 1.0, query);
    EXPECT_TRUE(index.complete) << family.shape->name();
    EXPECT_NEAR(index.index.mid(), expected.index.mid(), 0.01) << family.shape->name();
    EXPECT_TRUE(index.measure.intersects(expected.measure)) << index.measure << " " << expected.measure;
  }
}

// Their regions of size 0 are no points: where none of these is good, there is no region at all.
TEST(GivenMeasures, wereTooLargeForAnyRegion)
{
  for (const Machine& machine : machines())
    for (const ShapePtr& shape :
         { makeCylinderOfRadius(0.7, Stand::ON_BASE), makeCylinderOfRadius(100.0, Stand::ON_BASE),
           makeCylinderOfHeight(2.2), makeBoxOnBase(0.01, 1.5) })
    {
      const RegionQuery query = test::queryFor(shape, 1e-3);
      const LargestRegion none = findLargestRegion(machine, query);
      SCOPED_TRACE(machine.name() + ", " + shape->name());
      EXPECT_EQ(none.status, LargestRegion::Status::NONE) << none.message;
      EXPECT_EQ(none.size, 0.0);
      EXPECT_EQ(none.size_upper_bound, 0.0);
      EXPECT_EQ(none.message, "no region of any size exists where the center may lie, proved");
      EXPECT_LE(none.boxes, 2000);
      EXPECT_NE(describe(none, machine, query).find("no " + shape->name() + " of any size, wherever its center"),
                std::string::npos)
          << describe(none, machine, query);
    }
}

TEST(GivenMeasures, alongRailsWithoutAnEnd)
{
  RegionQuery query;
  query.shape = makeCylinderOfRadius(0.1, Stand::ON_BASE);
  test::expectThrow<Unbounded>([&] { findLargestRegion(uranesx(), query); },
                               "a cylinder of radius 0.1 m on its base along the rails can be as long as one likes");
  query.shape = makeCylinderOfRadius(2.0, Stand::ON_BASE);
  const LargestRegion none = findLargestRegion(uranesx(), query);
  EXPECT_EQ(none.status, LargestRegion::Status::NONE) << none.message;
  EXPECT_EQ(none.size_upper_bound, 0.0);
}

// Next to the largest radius: whatever is said, it is said soon, and not that there is more than there is.
TEST(GivenMeasures, thatNearlyLeaveNothing)
{
  const LargestRegion disc = test::expectProven(orthoglide(), test::queryFor(makeDisc(), 1e-6));
  for (const double more : { -1e-3, -1e-5, -2e-6, 0.0, 2e-6, 1e-5, 1e-3 })
  {
    RegionQuery query = test::queryFor(makeCylinderOfRadius(disc.size + more, Stand::ABOUT_CENTER), 1e-3);
    const LargestRegion region = findLargestRegion(orthoglide(), query);
    EXPECT_NE(region.status, LargestRegion::Status::STOPPED) << more << ": " << region.message;
    EXPECT_LE(region.boxes, 10000) << more;
    EXPECT_TRUE(more < 1e-6 || region.size == 0.0) << more << ": no disc is that wide";
    EXPECT_TRUE(more > -1e-4 || region.size > 0.0) << more;
  }
}
}  // namespace pkm_workspace
