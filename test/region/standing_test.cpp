// SPDX-License-Identifier: BSD-3-Clause
// Regions that stand on a plane, from what "standing" means: the shape's points above one of the plane.
#include <gtest/gtest.h>

#include "pkm_workspace/region/containment.h"
#include "pkm_workspace/region/region_wish.h"
#include "pkm_workspace/region/solid.h"
#include "region/parallel_rails.h"
#include "support/body_points.h"
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

/// A shape that is asked for, and the bounds of what its region of a size measures: half along x and y, and the height.
struct Standing
{
  ShapeWish wish;
  Vector3d (*measures)(double size);
  bool is_round;
};

std::vector<Standing> wishes()
{
  ShapeWish of_radius{ "cylinder" };
  of_radius.radius = 0.125;
  ShapeWish of_height{ "cylinder" };
  of_height.height = 0.1875;
  ShapeWish of_footprint{ "box" };
  of_footprint.footprint = std::array<double, 2>{ 0.25, 0.125 };
  return {
    { { "cube" }, [](double h) { return Vector3d(h / 2, h / 2, h); }, false },
    { { "square" }, [](double h) { return Vector3d(h / 2, h / 2, 0.0); }, false },
    { { "box", Vector3d(2.0, 1.0, 0.5) }, [](double h) { return Vector3d(h, h / 2, h / 2); }, false },
    { { "disc" }, [](double h) { return Vector3d(h, h, 0.0); }, true },
    { { "cylinder", {}, RatioRange{ 0.5, 0.5 } }, [](double h) { return Vector3d(h / 2, h / 2, h); }, true },
    { of_radius, [](double h) { return Vector3d(0.125, 0.125, h); }, true },
    { of_height, [](double h) { return Vector3d(h, h, 0.1875); }, true },
    { of_footprint, [](double h) { return Vector3d(0.125, 0.0625, h); }, false },
  };
}

Machine limitedDelta()
{
  Machine::Legs legs = uranesx().legs();
  for (Leg& leg : legs)
    leg.limits = Interval(-0.3, 0.3);
  return Machine("limited delta", legs, uranesx().zero());
}

/// Machines, and a plane through each.
std::vector<std::pair<Machine, double>> machinesAndPlanes()
{
  const Machine leaning = test::leaning(test::withParallelRails(SEED));
  return { { orthoglide(), 0.0625 },
           { limitedDelta(), limitedDelta().zero().z() - 0.1 },
           { test::crooked(4), test::crooked(4).zero().z() },
           { leaning, leaning.zero().z() - 0.05 } };
}

RegionQuery queryOf(const ShapeWish& wish, double base_z, double accuracy)
{
  RegionQuery query = test::queryFor(nullptr, accuracy);
  setShape(wish, query);
  PlaceWish place;
  place.base_z = base_z;
  setPlace(place, query);
  return query;
}

/// A point of what stands on a point of the plane, on its surface more often than not.
Vector3d pointOn(const Standing& standing, const Vector3d& base, double size, RandomBoxes& random)
{
  const Vector3d measures = (1.0 - 1e-12) * standing.measures(size);
  const auto share = [&random] { return std::max(-1.0, std::min(1.0, random.between(-1.6, 1.6))); };
  Vector3d offset(share(), share(), 0.5 + 0.5 * share());
  if (standing.is_round)
    offset.head<2>() /= std::max(1.0, offset.head<2>().norm());
  return base + offset.cwiseProduct(measures);
}

bool hasBadPoint(const Oracle& oracle, const Standing& standing, const Vector3d& base, double size, RandomBoxes& random)
{
  for (int k = 0; k < 3000; ++k)
    if (!oracle.isGood(pointOn(standing, base, size, random)))
      return true;
  return false;
}
}  // namespace

TEST(Standing, regionsAreGoodAndLargerOnesAreNot)
{
  int found = 0;
  for (const auto& [machine, base_z] : machinesAndPlanes())
    for (const Standing& standing : wishes())
    {
      SCOPED_TRACE(machine.name() + ", " + standing.wish.name + ", seed " + std::to_string(SEED));
      const RegionQuery query = queryOf(standing.wish, base_z, 2e-3 * machine.scale());
      const LargestRegion region = findLargestRegion(machine, query);
      ASSERT_NE(region.status, LargestRegion::Status::STOPPED) << region.size << " to " << region.size_upper_bound;
      const Oracle oracle(machine, query.criterion);
      RandomBoxes random(SEED);
      const Vector3d middle = region.size > 0.0 ? region.center : Vector3d(machine.zero());
      if (region.size > 0.0)
      {
        ++found;
        ASSERT_EQ(region.center.z(), base_z);
        for (int k = 0; k < cases(300); ++k)
          ASSERT_TRUE(oracle.isGood(pointOn(standing, region.center, region.size, random))) << "case " << k;
      }
      for (int k = 0; k < cases(40); ++k)
      {
        const double reach = k == 0 ? 0.0 : (k % 3 == 0 ? 0.5 : k % 3 == 1 ? 0.05 : 2e-3) * machine.scale();
        Vector3d base = middle + reach * Vector3d(random.between(-1.0, 1.0), random.between(-1.0, 1.0), 0.0);
        base.z() = base_z;
        ASSERT_TRUE(hasBadPoint(oracle, standing, base, region.size_upper_bound * (1.0 + 1e-9), random))
            << "case " << k << ", base (" << base.transpose() << ") m";
      }
    }
  EXPECT_GT(found, 24);
}

// What is found anywhere stands on a plane too: through its lowest face, and there none is larger.
TEST(Standing, agreesWithWhatStandsAnywhere)
{
  for (const auto& [machine, any_base] : machinesAndPlanes())
    for (const Standing& standing : wishes())
    {
      SCOPED_TRACE(machine.name() + ", " + standing.wish.name);
      RegionQuery anywhere = test::queryFor(nullptr, 2e-3 * machine.scale());
      setShape(standing.wish, anywhere);
      const LargestRegion free = findLargestRegion(machine, anywhere);
      const double lowest = free.center.z() + free.shape->lower().at(free.size).z();
      const LargestRegion there = findLargestRegion(machine, queryOf(standing.wish, lowest, anywhere.accuracy));
      EXPECT_LE(there.size, free.size_upper_bound);
      EXPECT_GE(there.size_upper_bound, free.size * (1.0 - 1e-9));
    }
}

TEST(Standing, freeRatiosHaveTheVolumeOfTheBestOfThem)
{
  const ShapeWish free{ "cylinder", {}, RatioRange{ 0.25, 1.0 } };
  const LargestRegion best = findLargestRegion(orthoglide(), queryOf(free, 0.0, 1e-2));
  EXPECT_EQ(best.status, LargestRegion::Status::PROVEN);
  EXPECT_EQ(best.shape->lower().at(1.0).z(), 0.0);
  EXPECT_EQ(best.center.z(), 0.0);
  for (const double ratio : { 0.25, 0.4, 0.6, 1.0 })
  {
    const ShapeWish fixed{ "cylinder", {}, RatioRange{ ratio, ratio } };
    EXPECT_LE(findLargestRegion(orthoglide(), queryOf(fixed, 0.0, 1e-2)).volume, best.volume_upper_bound) << ratio;
  }
}

// The solid about its middle, as others take it, lies in the region.
TEST(Standing, hasASolidAboutItsMiddle)
{
  RandomBoxes random(SEED);
  for (const Standing& standing : wishes())
    for (int k = 0; k < cases(100); ++k)
    {
      RegionQuery query;
      setShape(standing.wish, query);
      const Vector3d base = random.pointIn({ Vector3d::Constant(-3.0), Vector3d::Constant(3.0) });
      const double size = random.between(0.01, 2.0);
      const ShapePtr shape = query.shape->standing();
      const CenteredSolid solid = centeredSolid(*shape, base, size);
      const Solid about = makeSolid(shape->isBox() ? SolidKind::BOX : SolidKind::CYLINDER, solid.dimensions);
      for (const Vector3d& corner : pointsOf(about.shape->extremePoints(), solid.center, (1.0 - 1e-15) * about.size))
        EXPECT_GE(corner.z(), base.z() - 1e-15) << standing.wish.name;
      const double height = shape->isBox() ? solid.dimensions[2] : solid.dimensions[0];
      const Interval lowest = Interval(solid.center.z()) - Interval(0.5) * Interval(height);
      const Interval highest = Interval(solid.center.z()) + Interval(0.5) * Interval(height);
      EXPECT_GE(lowest.upper(), base.z());
      EXPECT_NEAR(lowest.mid(), base.z(), 1e-15) << standing.wish.name;
      const double top = standing.measures(size).z();
      EXPECT_NEAR(highest.mid(), base.z() + top, 2e-15) << standing.wish.name;
      EXPECT_LE(highest.lower(), (Interval(base.z()) + Interval(top)).upper());
      EXPECT_EQ(centeredSolid(*query.shape, base, size).center, base) << "what is about its center stays there";
    }
}

TEST(Standing, placesThatExcludeEachOtherAreRefused)
{
  using Bad = std::invalid_argument;
  const auto refused = [](const char* shape, const PlaceWish& place, const char* why) {
    RegionQuery query;
    setShape({ shape }, query);
    test::expectThrow<Bad>([&] { setPlace(place, query); }, why);
  };
  const Box box{ Vector3d::Constant(-1.0), Vector3d::Constant(1.0) };
  refused("sphere", { {}, {}, 0.0 }, "base_z is for regions with a lowest face, and a sphere has none: give");
  refused("cube", { {}, Vector3d::Zero(), 0.0 }, "exclude each other.*give the search box X X Y Y Z Z");
  refused("cube", { box, Vector3d::Zero(), {} }, "only one of the two");
  refused("cube", { box, {}, 2.0 }, "from z = -1 m to 1 m and base_z = 2 m is not between");
  refused("cube", { {}, {}, 1e10 }, "base_z = 10000000000 m must be finite, within 1e9 m");
  refused("cube", { {}, {}, std::nan("") }, "base_z = nan m");
  refused("cube", { {}, Vector3d(0.0, 1e10, 0.0), {} }, "center = .* must be finite, within 1e9 m");
}
}  // namespace pkm_workspace
