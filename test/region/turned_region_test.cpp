// SPDX-License-Identifier: BSD-3-Clause
// Regions that may be turned about the vertical, from what "turned" means: c + R k for the points k of the shape, with
// R from cos and sin; and against the search for regions that are not turned, of a machine that is.
#include "pkm_workspace/region/turned_region.h"

#include <gtest/gtest.h>

#include <cmath>

#include "pkm_workspace/machine/frame.h"
#include "region/turned_wishes.h"
#include "support/body_points.h"
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
using test::turnedQuery;
using test::TurnedWish;
using test::turnedWishes;

/// A point of the shape turned about the center, on its surface more often than not.
Vector3d turnedPoint(const Shape& shape, const Vector3d& center, double size, double angle, RandomBoxes& random)
{
  const Vector3d k = (1.0 - 1e-12) * test::pointOf(shape, Vector3d::Zero(), size, random);
  return center + Vector3d(std::cos(angle) * k.x() - std::sin(angle) * k.y(),
                           std::sin(angle) * k.x() + std::cos(angle) * k.y(), k.z());
}

bool holdsBadPoint(const Oracle& oracle, const Shape& shape, const Vector3d& center, double size, double angle,
                   RandomBoxes& random)
{
  for (int k = 0; k < 3000; ++k)
    if (!oracle.isGood(turnedPoint(shape, center, size, angle, random)))
      return true;
  return false;
}

/// One near another center and angle, or anywhere. @param flat whether only z is kept
std::pair<Vector3d, double> anotherPlace(int k, const Vector3d& center, double angle, double scale, bool flat,
                                         RandomBoxes& random)
{
  const double reach = k == 0 ? 0.0 : k % 3 == 0 ? 0.5 : k % 3 == 1 ? 0.05 : 2e-3;
  Vector3d there(random.between(-1.0, 1.0), random.between(-1.0, 1.0), flat ? 0.0 : random.between(-1.0, 1.0));
  there = center + reach * scale * there;
  const double turn = k == 0 ? 0.0 : k % 2 == 0 ? random.between(-0.02, 0.02) : random.between(-M_PI, M_PI);
  return { there, angle + turn };
}
}  // namespace

namespace
{
/// @return whether one was found
bool holdsFromOutside(const Machine& machine, const RegionQuery& query)
{
  const LargestRegion region = findLargestRegion(machine, query);
  EXPECT_NE(region.status, LargestRegion::Status::STOPPED) << region.size << " to " << region.size_upper_bound;
  const bool is_found = region.size > 0.0;
  const double at = region.angle.value_or(0.0);
  const Vector3d middle = is_found ? region.center : Vector3d(machine.zero());
  const Oracle oracle(machine, query.criterion);
  RandomBoxes random(SEED);
  for (int k = 0; is_found && k < cases(500) && !testing::Test::HasFailure(); ++k)
    EXPECT_TRUE(oracle.isGood(turnedPoint(*region.shape, region.center, region.size, at, random))) << "case " << k;
  for (int k = 0; k < cases(60) && !testing::Test::HasFailure(); ++k)
  {
    const auto [center, angle] = anotherPlace(k, middle, at, machine.scale(), false, random);
    EXPECT_TRUE(holdsBadPoint(oracle, *region.shape, center, region.size_upper_bound * (1.0 + 1e-9), angle, random))
        << "case " << k << ", center (" << center.transpose() << ") m, angle " << angle;
  }
  return is_found;
}

/// Of a machine that is turned the other way round, regions along the axes are the same regions.
/// @param near how near the best of these steps comes to the best of all, relative
void holdsAtEveryAngle(const Machine& machine, const RegionQuery& query, double period, int steps, double near)
{
  const LargestRegion best = findLargestRegion(machine, query);
  RegionQuery fixed = query;
  fixed.angles = 0.0;
  double largest = 0.0;
  for (int k = 0; k < steps; ++k)
  {
    const double angle = period * k / steps;
    const Pose pose{ { 0.0, 0.0, -std::sin(0.5 * angle), std::cos(0.5 * angle) }, Vector3d::Zero() };
    for (Zone& zone : fixed.criterion.zones)
      zone.frame = pose;
    const LargestRegion there = findLargestRegion(machineInFrame(machine, pose), fixed);
    EXPECT_LE(there.size, best.size_upper_bound) << angle;
    largest = std::max(largest, there.size_upper_bound);
  }
  EXPECT_GE(largest, best.size - near * best.size);
}
}  // namespace

TEST(TurnedRegion, foundRegionsAreGoodAndLargerOnesAreNot)
{
  int found = 0;
  for (const Machine& machine : test::machinesToTurnIn())
    for (const TurnedWish& turned : turnedWishes())
    {
      SCOPED_TRACE(machine.name() + ", " + turned.wish.name + ", seed " + std::to_string(SEED));
      found += holdsFromOutside(machine, turnedQuery(turned.wish, 2e-3 * machine.scale())) ? 1 : 0;
    }
  EXPECT_GT(found, 24);
}

TEST(TurnedRegion, isTheLargestOfThoseAtEveryAngle)
{
  for (const Machine& machine : test::machinesToTurnIn())
    for (const TurnedWish& turned : turnedWishes())
    {
      SCOPED_TRACE(machine.name() + ", " + turned.wish.name);
      holdsAtEveryAngle(machine, turnedQuery(turned.wish, 1e-3 * machine.scale()), turned.period, cases(24), 0.05);
    }
}

TEST(TurnedRegion, keepsOutOfZones)
{
  for (const Machine& machine : { orthoglide(), test::deltaWithLimits(), test::crooked(4) })
    for (const TurnedWish& turned : turnedWishes())
    {
      if (turned.wish.footprint || (turned.wish.proportions && turned.wish.proportions->y() == 0.0))
        continue;
      SCOPED_TRACE(machine.name() + ", " + turned.wish.name + ", seed " + std::to_string(SEED));
      RegionQuery query = turnedQuery(turned.wish, 1e-2 * machine.scale());
      query.criterion.zones = test::zonesBeside(machine, turned.wish.name);
      EXPECT_TRUE(holdsFromOutside(machine, query));
      holdsAtEveryAngle(machine, query, turned.period, cases(6), 0.2);
    }
}

// Turned, the square gains nothing; a box does.
TEST(TurnedRegion, squareOfTheUranesx)
{
  RegionQuery query = turnedQuery({ "square" }, 1e-7);
  const LargestRegion turned = findLargestRegion(uranesx(), query);
  query.angles = 0.0;
  const LargestRegion straight = findLargestRegion(uranesx(), query);
  EXPECT_EQ(turned.status, LargestRegion::Status::PROVEN);
  EXPECT_NEAR(turned.size, 0.5194884, 2e-7);
  EXPECT_LE(turned.size_upper_bound - straight.size, 2e-7);
  const double sixth = std::fmod(*turned.angle + 1e-6, M_PI / 6.0);
  EXPECT_LT(sixth, 2e-6) << *turned.angle;
  EXPECT_FALSE(straight.angle);
  EXPECT_GT(findLargestRegion(orthoglide(), turnedQuery({ "box", Vector3d(2.0, 1.0, 0.5) }, 1e-4)).size, 0.669);
}

TEST(TurnedRegion, isLookedForAtItsPlace)
{
  const PlaceWish at_center{ {}, Vector3d(0.125, 0.0, 0.0625), {} };
  const LargestRegion about = findLargestRegion(orthoglide(), turnedQuery({ "square" }, 1e-3, at_center));
  EXPECT_EQ(about.center, *at_center.center);
  EXPECT_EQ(about.status, LargestRegion::Status::PROVEN);
  const Box box{ Vector3d(0.1, 0.1, -0.1), Vector3d(0.3, 0.2, 0.1) };
  const LargestRegion within = findLargestRegion(orthoglide(), turnedQuery({ "cube" }, 1e-3, { box, {}, {} }));
  EXPECT_TRUE((within.center.array() >= box.lower.array() && within.center.array() <= box.upper.array()).all());
  for (const TurnedWish& turned : turnedWishes())
    for (const Machine& machine : { orthoglide(), test::deltaWithLimits() })
    {
      SCOPED_TRACE(machine.name() + ", " + turned.wish.name);
      const double base_z = machine.zero().z() - 0.0625;
      const RegionQuery query = turnedQuery(turned.wish, 2e-3, { {}, {}, base_z });
      const LargestRegion standing = findLargestRegion(machine, query);
      EXPECT_NE(standing.status, LargestRegion::Status::STOPPED);
      Vector3d middle = standing.size > 0.0 ? standing.center : Vector3d(machine.zero());
      EXPECT_TRUE(standing.size == 0.0 || middle.z() == base_z);
      middle.z() = base_z;
      EXPECT_EQ(standing.shape->lower().at(1.0).z(), 0.0);
      const Oracle oracle(machine, query.criterion);
      RandomBoxes random(SEED);
      for (int k = 0; k < cases(20); ++k)
      {
        const auto [center, angle] = anotherPlace(k, middle, *standing.angle, machine.scale(), true, random);
        EXPECT_TRUE(
            holdsBadPoint(oracle, *standing.shape, center, standing.size_upper_bound * (1.0 + 1e-9), angle, random))
            << "case " << k << ", angle " << angle;
      }
    }
}

TEST(TurnedRegion, jointRangesAreThoseOfTheTurnedRegion)
{
  for (const Machine& machine : test::machinesToTurnIn())
  {
    SCOPED_TRACE(machine.name());
    const RegionQuery query = turnedQuery({ "box", Vector3d(2.0, 1.0, 0.5) }, 2e-3 * machine.scale());
    const LargestRegion region = findLargestRegion(machine, query);
    const Oracle oracle(machine, query.criterion);
    RandomBoxes random(SEED);
    std::array<Interval, 3> seen = { Interval::empty(), Interval::empty(), Interval::empty() };
    for (int k = 0; k < 3000; ++k)
    {
      const Vector3d p = turnedPoint(*region.shape, region.center, region.size, *region.angle, random);
      for (int i = 0; i < 3; ++i)
      {
        const double joint = static_cast<double>(oracle.joint(i, { p.x(), p.y(), p.z() }));
        Interval& values = seen[static_cast<std::size_t>(i)];
        values = values.isEmpty() ? Interval(joint) : hull(values, joint);
      }
    }
    for (std::size_t i = 0; i < 3; ++i)
    {
      const JointRange& range = region.joint_ranges[i];
      EXPECT_LE(range.lower.lower(), seen[i].lower());
      EXPECT_GE(range.upper.upper(), seen[i].upper());
      EXPECT_NEAR(range.lower.lower(), seen[i].lower(), 0.02 * machine.scale());
      EXPECT_NEAR(range.upper.upper(), seen[i].upper(), 0.02 * machine.scale());
    }
  }
}
}  // namespace pkm_workspace
