// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/region/containment.h"

#include <gtest/gtest.h>

#include "pkm_workspace/report/containment_sentence.h"
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
const Eigen::Vector3d CUBE_CENTER = Eigen::Vector3d::Constant(0.086273015);
}  // namespace

TEST(Containment, theCubesOfTheIssue)
{
  const BoxTest test(orthoglide(), Criterion());
  const ShapePtr cube = makeCube();
  EXPECT_EQ(checkContainment(test, *cube, CUBE_CENTER, 0.6439).verdict, Containment::INSIDE);
  const ContainmentResult outside = checkContainment(test, *cube, CUBE_CENTER, 0.644);
  EXPECT_EQ(outside.verdict, Containment::OUTSIDE);
  ASSERT_TRUE(outside.bad_point);
  EXPECT_FALSE(test::Oracle(orthoglide(), Criterion()).isGood(*outside.bad_point));
  EXPECT_LE((*outside.bad_point - CUBE_CENTER).cwiseAbs().maxCoeff(), 0.322);
}

// docs/values.md: 0.643950551 is the limit; the verdict has no tolerance on either side.
TEST(Containment, theBorderIsExact)
{
  const BoxTest test(orthoglide(), Criterion());
  const Eigen::Vector3d center = Eigen::Vector3d::Constant((1.0 / std::sqrt(6.0) - 1.0 / (3.0 * std::sqrt(2.0))) / 2.0);
  const double edge = 1.0 / std::sqrt(6.0) + 1.0 / (3.0 * std::sqrt(2.0));
  EXPECT_EQ(checkContainment(test, *makeCube(), center, edge - 1e-12).verdict, Containment::INSIDE);
  EXPECT_EQ(checkContainment(test, *makeCube(), center, edge + 1e-12).verdict, Containment::OUTSIDE);
}

TEST(Containment, agreesWithTheOracleOnRandomBoxes)
{
  for (const Machine& machine : test::everyKind())
  {
    const BoxTest test(machine, Criterion());
    const test::Oracle oracle(machine, Criterion());
    test::RandomBoxes random(SEED);
    const Eigen::Vector3d reach = Eigen::Vector3d::Constant(0.5 * machine.scale());
    const Box space{ machine.zero() - reach, machine.zero() + reach };
    for (int k = 0; k < test::cases(40); ++k)
    {
      const Eigen::Vector3d center = random.pointIn(space);
      const Eigen::Vector3d sides = machine.scale() * random.between(0.01, 0.6) * Eigen::Vector3d(1.0, 0.5, 0.2);
      const ShapePtr shape = makeBox(sides);
      const ContainmentResult result = checkContainment(test, *shape, center, 1.0);
      ASSERT_NE(result.verdict, Containment::UNDECIDED) << machine.name() << ", seed " << SEED << ", case " << k;
      EXPECT_EQ(result.bad_point.has_value(), result.verdict == Containment::OUTSIDE);
      if (result.bad_point)
      {
        EXPECT_FALSE(oracle.isGood(*result.bad_point)) << machine.name() << ", seed " << SEED << ", case " << k;
        EXPECT_TRUE(shape->contains(*result.bad_point, Box{ center, center }, 1.0));
        continue;
      }
      for (int sample = 0; sample < 10; ++sample)
        EXPECT_TRUE(oracle.isGood(random.pointIn(shape->boundingBox(center, 1.0))))
            << machine.name() << ", seed " << SEED << ", case " << k;
    }
  }
}

// The region touches a bound from inside, in a tiny spot: least psi 0.49985 within the square (UraneSX, R - r =
// 0.3848).
TEST(Containment, findsATinySpotInside)
{
  const Machine machine = uranesx(Interval(0.4848), Interval(0.1));
  const BoxTest test(machine, Criterion());
  const Eigen::Vector3d center(-0.0112, 0.0, machine.zero().z());
  const ContainmentResult result = checkContainment(test, *makeSquare(), center, 0.55);
  EXPECT_EQ(result.verdict, Containment::OUTSIDE);
  const Machine wider = uranesx(Interval(0.4850), Interval(0.1));
  const BoxTest good(wider, Criterion());
  EXPECT_EQ(checkContainment(good, *makeSquare(), { -0.0112, 0.0, wider.zero().z() }, 0.55).verdict,
            Containment::INSIDE);
}

TEST(Containment, endsWithItsBudget)
{
  const BoxTest test(orthoglide(), Criterion());
  const auto expectUndecided = [&test](const Budget& budget, double size, const std::string& why) {
    const ContainmentResult result = checkContainment(test, *makeCube(), CUBE_CENTER, size, budget);
    EXPECT_EQ(result.verdict, Containment::UNDECIDED);
    EXPECT_EQ(describe(result, PointEvaluator(orthoglide(), Criterion()), *makeCube(), CUBE_CENTER, size, budget),
              "Neither is proved: " + why + ".");
  };
  Budget budget;
  budget.max_boxes = 5;
  expectUndecided(budget, 0.6439, "the limit of 5 boxes ended the proof");
  budget = Budget();
  budget.time_limit = 1e-9;
  expectUndecided(budget, 0.6439, "the time limit of 1e-09 s ended the proof");
  const std::atomic<bool> stop(true);
  budget.stop = &stop;
  expectUndecided(budget, 0.6439, "a request to stop ended the proof");
}

// A line from the middle to where two struts only just reach.
TEST(Containment, saysWhereTheBorderIsWithinRounding)
{
  Criterion reachable;
  reachable.set = Criterion::Set::REACHABLE;
  const BoxTest test(orthoglide(), reachable);
  const Budget budget;
  const ShapePtr line = makeBox({ 1.0, 0.0, 0.0 });
  const Eigen::Vector3d center(0.5, 0.0, 0.0);
  const ContainmentResult result = checkContainment(test, *line, center, 1.0, budget);
  EXPECT_EQ(result.verdict, Containment::UNDECIDED);
  EXPECT_TRUE(result.is_within_rounding);
  EXPECT_EQ(describe(result, PointEvaluator(orthoglide(), reachable), *line, center, 1.0, budget),
            "Neither is proved: the border of the set is within rounding of the region.");
}

TEST(Shape, refusesProportionsThatMakeNoBox)
{
  for (const Eigen::Vector3d& proportions :
       { Eigen::Vector3d(0.0, 0.0, 0.0), Eigen::Vector3d(-1.0, 1.0, 1.0), Eigen::Vector3d(std::nan(""), 1.0, 1.0),
         Eigen::Vector3d(1e300, 1.0, 1.0) })
    test::expectThrow<std::invalid_argument>([&] { makeBox(proportions); }, "proportions .*must be finite");
}

TEST(Shape, boundsEncloseAndContentsAreExact)
{
  test::RandomBoxes random(SEED);
  const Box space{ Eigen::Vector3d::Constant(-3.0), Eigen::Vector3d::Constant(3.0) };
  for (int k = 0; k < test::cases(500); ++k)
  {
    const Eigen::Vector3d proportions = random.pointIn(space).cwiseAbs();
    const ShapePtr shape = makeBox(proportions);
    const Eigen::Vector3d center = random.pointIn(space);
    const double size = random.between(0.1, 2.0);
    const Box bounds = shape->boundingBox(center, size);
    for (const GrowingVector& corner : shape->extremePoints())
      for (int axis = 0; axis < 3; ++axis)
      {
        using boost::multiprecision::cpp_bin_float_100;
        const cpp_bin_float_100 exact = cpp_bin_float_100(size) * corner.per_size[axis] + center[axis];
        EXPECT_TRUE(bounds.lower[axis] <= exact && exact <= bounds.upper[axis]) << "seed " << SEED << ", case " << k;
      }
    EXPECT_TRUE(shape->contains(center, Box{ center, center }, size));
    EXPECT_FALSE(shape->contains(bounds.upper + Eigen::Vector3d(1e-9, 0, 0), Box{ center, center }, size));
    EXPECT_TRUE(shape->misses(Box{ bounds.upper.array() + 1e-9, bounds.upper.array() + 1.0 }, center, size));
    EXPECT_FALSE(shape->misses(Box{ center, bounds.upper.array() + 1.0 }, center, size));
  }
}
}  // namespace pkm_workspace
