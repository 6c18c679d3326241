// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/region/largest_region.h"

#include <gtest/gtest.h>

#include "pkm_workspace/region/containment.h"
#include "support/cases.h"
#include "support/driven_criteria.h"
#include "support/machines.h"
#include "support/oracle.h"
#include "support/random.h"
#include "support/rounding_mode.h"

namespace pkm_workspace
{
namespace
{
using test::SEED;

// docs/values.md: 1/sqrt(6) + 1/(3 sqrt(2)), between two doubles.
const Interval CUBE_EDGE = Interval(1.0) / sqrt(Interval(6.0)) + Interval(1.0) / (Interval(3.0) * sqrt(Interval(2.0)));
constexpr double CUBE_COORDINATE = 0.086273015;
// Values called "search" in docs/values.md are good to this.
constexpr double SEARCH_ERROR = 1e-5;

RegionQuery query(const ShapePtr& shape, double accuracy)
{
  RegionQuery query;
  query.shape = shape;
  query.accuracy = accuracy;
  return query;
}

void expectProven(const LargestRegion& region, const RegionQuery& query)
{
  EXPECT_EQ(region.status, LargestRegion::Status::PROVEN) << region.message;
  EXPECT_LE(region.size, region.size_upper_bound);
  EXPECT_LE((Interval(region.size_upper_bound) - Interval(region.size)).lower(), query.accuracy);
}

/// The bracket holds a value that is known to SEARCH_ERROR.
void expectHolds(const LargestRegion& region, double value)
{
  EXPECT_LE(region.size, value + SEARCH_ERROR);
  EXPECT_GE(region.size_upper_bound, value - SEARCH_ERROR);
}

Machine uranesxWith(double lambda)
{
  return uranesx(Interval(7.0) / Interval(13.0) + Interval(lambda), Interval(3.0) / Interval(26.0));
}
}  // namespace

TEST(LargestRegion, orthoglideCubeAtEveryAccuracy)
{
  for (const double accuracy : { 1e-1, 1e-2, 1e-3, 1e-5, 1e-7 })
  {
    const RegionQuery wanted = query(makeCube(), accuracy);
    const LargestRegion region = findLargestRegion(orthoglide(), wanted);
    expectProven(region, wanted);
    EXPECT_LE(region.size, CUBE_EDGE.upper()) << accuracy;
    EXPECT_GE(region.size_upper_bound, CUBE_EDGE.lower()) << accuracy;
  }
}

TEST(LargestRegion, orthoglideCubeOfTheIssue)
{
  const LargestRegion region = findLargestRegion(orthoglide(), query(makeCube(), 1e-3));
  EXPECT_GE(region.size, 0.64295);
  EXPECT_LE(region.size, 0.6439506);
  EXPECT_GE(region.size_upper_bound, 0.6439505);
  EXPECT_LE(region.size_upper_bound, region.size + 1e-3);
  for (int axis = 0; axis < 3; ++axis)
    EXPECT_NEAR(region.center[axis], CUBE_COORDINATE, 1e-3);
}

// docs/values.md: bounds [1/f, f].
TEST(LargestRegion, orthoglideCubeForOtherBounds)
{
  const std::pair<double, double> known[] = {
    { 1.5, 0.397924 }, { 2.5, 0.733668 }, { 3.0, 0.786583 }, { 4.0, 0.845790 }
  };
  for (const auto& [factor, edge] : known)
  {
    RegionQuery wanted = query(makeCube(), 1e-4);
    wanted.criterion.psi_min = 1.0 / factor;
    wanted.criterion.psi_max = factor;
    const LargestRegion region = findLargestRegion(orthoglide(), wanted);
    expectProven(region, wanted);
    expectHolds(region, edge);
  }
}

TEST(LargestRegion, theOtherAspectIsNeverMixedIn)
{
  const Machine elsewhere("other", orthoglide().legs(), Eigen::Vector3d::Constant(-0.546));
  EXPECT_EQ(elsewhere.aspect(), -orthoglide().aspect());
  RegionQuery wanted = query(makeCube(), 1e-5);
  const LargestRegion region = findLargestRegion(elsewhere, wanted);
  expectProven(region, wanted);
  expectHolds(region, 0.062854514);
  EXPECT_NEAR(region.center.x(), -0.545923012, 1e-5);

  wanted.criterion.aspect = Criterion::Aspect::OTHER;
  expectHolds(findLargestRegion(orthoglide(), wanted), 0.062854514);
}

// Table 2 of the paper with the search values of docs/values.md; the last row is the one that the paper calls not
// satisfied.
TEST(LargestRegion, uranesxSquares)
{
  struct Row
  {
    double lambda, paper, edge;
  };
  for (const Row& row : { Row{ 0.00, 0.510, 0.51949 }, Row{ 0.05, 0.470, 0.47585 }, Row{ 0.10, 0.420, 0.42859 },
                          Row{ 0.15, 0.370, 0.377935 }, Row{ 0.20, 0.320, 0.324062 }, Row{ -0.035, 0.0, 0.54774 } })
  {
    const RegionQuery wanted = query(makeSquare(), 1e-4);
    const Machine machine = uranesxWith(row.lambda);
    const LargestRegion region = findLargestRegion(machine, wanted);
    expectProven(region, wanted);
    expectHolds(region, row.edge);
    EXPECT_GT(region.size, row.paper) << "the paper's square is smaller than one that exists";
    EXPECT_EQ(region.center.z(), machine.zero().z());
  }
}

TEST(LargestRegion, worksForEveryKindOfMachine)
{
  for (const Machine& machine : test::everyKind())
  {
    const ShapePtr shape = machine.hasParallelRails() ? makeSquare() : makeBox({ 1.0, 0.8, 1.3 });
    RegionQuery wanted = query(shape, 1e-3 * machine.scale());
    wanted.criterion.joint_limits = test::hasTelescopes(machine);
    const LargestRegion region = findLargestRegion(machine, wanted);
    expectProven(region, wanted);
    const test::Oracle oracle(machine, wanted.criterion);
    test::RandomBoxes random(SEED);
    const Box bounds = shape->boundingBox(region.center, region.size);
    for (int k = 0; k < test::cases(200); ++k)
    {
      const Eigen::Vector3d point = shape->nearest(random.pointIn(bounds), region.center, region.size);
      const bool in_region = shape->contains(point, Box{ region.center, region.center }, region.size);
      EXPECT_TRUE(!in_region || oracle.isGood(point))
          << machine.name() << ", seed " << SEED << ", " << point.transpose();
    }
  }
}

TEST(LargestRegion, noPlacementBeatsTheUpperBound)
{
  for (const Machine& machine : { orthoglide(), test::crooked(6) })
  {
    const RegionQuery wanted = query(makeCube(), 1e-3);
    const LargestRegion region = findLargestRegion(machine, wanted);
    const BoxTest test(machine, wanted.criterion);
    test::RandomBoxes random(SEED);
    const double reach = 0.05;
    for (int k = 0; k < test::cases(200); ++k)
    {
      const Eigen::Vector3d offset(random.between(-reach, reach), random.between(-reach, reach),
                                   random.between(-reach, reach));
      const double size = region.size_upper_bound * (1.0 + 1e-12);
      EXPECT_EQ(checkContainment(test, *wanted.shape, region.center + offset, size).verdict, Containment::OUTSIDE)
          << machine.name() << ", seed " << SEED << ", offset " << offset.transpose();
    }
  }
}

TEST(LargestRegion, isTheSameInAnotherUnitOfLength)
{
  const LargestRegion unit = findLargestRegion(orthoglide(), query(makeCube(), 1e-3));
  for (const double length : { 0.31058, 1000.0 })
  {
    const LargestRegion region = findLargestRegion(orthoglide(length), query(makeCube(), 1e-3 * length));
    EXPECT_NEAR(region.size / length, unit.size, 1e-3);
    EXPECT_LE(region.size, (Interval(length) * CUBE_EDGE).upper());
    EXPECT_GE(region.size_upper_bound, (Interval(length) * CUBE_EDGE).lower());
  }
}

TEST(LargestRegion, jointLimitsBind)
{
  Machine::Legs legs = orthoglide().legs();
  for (Leg& leg : legs)
    leg.limits = Interval(-0.2, 0.2);
  const Machine machine("limited", legs, Eigen::Vector3d::Zero());
  RegionQuery wanted = query(makeCube(), 1e-4);
  wanted.criterion.joint_limits = true;
  const LargestRegion region = findLargestRegion(machine, wanted);
  expectProven(region, wanted);
  for (const JointRange& range : region.joint_ranges)
  {
    EXPECT_GE(range.lower.upper(), -0.2);
    EXPECT_LE(range.upper.lower(), 0.2);
    EXPECT_LT(range.stroke.lower(), 0.4);
  }
  EXPECT_LT(region.size, 0.4);
  EXPECT_GT(region.size, 0.2);
}

TEST(LargestRegion, parallelRailsTakeTheirPlaneFromTheSearchBoxOrTheLimits)
{
  const Machine machine = uranesx();
  RegionQuery wanted = query(makeSquare(), 1e-3);
  wanted.search_box = Box{ { -0.2, -0.2, 3.0 }, { 0.2, 0.2, 5.0 } };
  EXPECT_EQ(findLargestRegion(machine, wanted).center.z(), 4.0);

  Machine::Legs legs = machine.legs();
  for (Leg& leg : legs)
    leg.limits = Interval(-0.4, 0.4);
  const Machine limited("limited", legs, machine.zero());
  RegionQuery cube = query(makeCube(), 1e-3);
  cube.criterion.joint_limits = true;
  const LargestRegion region = findLargestRegion(limited, cube);
  expectProven(region, cube);
  EXPECT_LT(region.size, 0.51949);
}

TEST(LargestRegion, theSearchBoxBoundsTheCenter)
{
  RegionQuery wanted = query(makeCube(), 1e-4);
  wanted.search_box = Box{ { 0.2, -1.0, -1.0 }, { 0.3, 1.0, 1.0 } };
  const LargestRegion region = findLargestRegion(orthoglide(), wanted);
  expectProven(region, wanted);
  EXPECT_GE(region.center.x(), 0.2);
  EXPECT_LT(region.size_upper_bound, CUBE_EDGE.lower());

  wanted.search_box = Box{ { 2.0, 2.0, 2.0 }, { 3.0, 3.0, 3.0 } };
  const LargestRegion none = findLargestRegion(orthoglide(), wanted);
  EXPECT_EQ(none.status, LargestRegion::Status::NONE);
  EXPECT_EQ(none.size, 0.0);
}

TEST(LargestRegion, atAGivenCenter)
{
  const RegionQuery wanted = query(makeCube(), 1e-6);
  const LargestRegion region = largestRegionAt(orthoglide(), wanted, Eigen::Vector3d::Zero());
  expectProven(region, wanted);
  EXPECT_EQ(region.center, Eigen::Vector3d::Zero());
  // its upper corner is the diagonal's point k = 1/2, or its lower one k = -1/4: t = k / sqrt(1 + 2 k^2)
  const double edge = 2.0 * 0.25 / std::sqrt(1.125);
  expectHolds(region, edge);
}

// What doubles report as beyond them, with the bracket as far as they got, multi-precision settles.
TEST(LargestRegion, multiPrecisionGoesOnWhereDoublesEnd)
{
  RegionQuery wanted = query(makeCube(), 1e-13);
  const LargestRegion doubles = findLargestRegion(orthoglide(), wanted);
  EXPECT_EQ(doubles.status, LargestRegion::Status::STOPPED);
  EXPECT_NE(doubles.message.find("multi-precision"), std::string::npos) << doubles.message;
  EXPECT_LE(doubles.size_upper_bound - doubles.size, 1e-11);
  wanted.precision = Precision::MULTIPLE;
  const LargestRegion multiple = findLargestRegion(orthoglide(), wanted);
  expectProven(multiple, wanted);
  EXPECT_LE(multiple.size, CUBE_EDGE.upper());
  EXPECT_GE(multiple.size_upper_bound, CUBE_EDGE.lower());
  EXPECT_GE(multiple.size, doubles.size);
  EXPECT_LE(multiple.size_upper_bound, doubles.size_upper_bound);
}

// Also where another library has set the thread to flush subnormal numbers to zero.
TEST(LargestRegion, isProvedOnThreadsOfEveryMode)
{
  const RegionQuery wanted = query(makeCube(), 1e-3);
  for (const test::RoundingMode& mode : test::MODES)
  {
    SCOPED_TRACE(mode.name);
    const LargestRegion region =
        test::under<LargestRegion>(mode, [&] { return findLargestRegion(orthoglide(), wanted); });
    expectProven(region, wanted);
    EXPECT_LE(region.size, CUBE_EDGE.upper());
    EXPECT_GE(region.size_upper_bound, CUBE_EDGE.lower());
  }
}
}  // namespace pkm_workspace
