// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/dexterity/region_check.h"

#include <gtest/gtest.h>

#include "support/cases.h"
#include "support/every_criterion.h"
#include "support/expect_throw.h"
#include "support/machines.h"
#include "support/oracle.h"
#include "support/random.h"

namespace pkm_workspace
{
namespace
{
using test::SEED;

/// Tries one machine and criterion: no verdict on a random box is contradicted by a point of the box.
/// @return how many boxes were INSIDE and OUTSIDE
std::pair<int, int> expectVerdictsHold(const Machine& machine, const Criterion& criterion, unsigned seed)
{
  const BoxTest test(machine, criterion);
  const test::Oracle oracle(machine, criterion);
  test::RandomBoxes random(seed);
  std::pair<int, int> counts(0, 0);
  for (int k = 0; k < test::cases(300); ++k)
  {
    const Box box = random.boxIn(test::spaceOf(machine), machine.scale());
    const BoxVerdict verdict = test.classify(box);
    counts.first += verdict == BoxVerdict::INSIDE;
    counts.second += verdict == BoxVerdict::OUTSIDE;
    for (int sample = 0; verdict != BoxVerdict::UNDECIDED && sample < 3; ++sample)
    {
      const Eigen::Vector3d point = sample == 0 ? box.upper : random.pointIn(box);
      EXPECT_EQ(oracle.isGood(point), verdict == BoxVerdict::INSIDE)
          << machine.name() << ", seed " << seed << ", box " << k << ", point " << point.transpose();
    }
  }
  return counts;
}
}  // namespace

TEST(BoxTest, verdictsHoldAtEveryPointOfTheBox)
{
  for (const Machine& machine : test::everyKind())
  {
    std::pair<int, int> total(0, 0);
    for (const Criterion& criterion : test::everyCriterion())
    {
      const auto counts = expectVerdictsHold(machine, criterion, SEED);
      total.first += counts.first;
      total.second += counts.second;
    }
    EXPECT_GT(total.first, 50) << machine.name() << ": the law was hardly tried";
    EXPECT_GT(total.second, 50) << machine.name();
  }
}

TEST(BoxTest, verdictsHoldWithJointLimits)
{
  for (const Machine& machine : { test::limited(orthoglide()), test::limited(test::crooked(4)) })
    for (Criterion criterion : test::everyCriterion())
    {
      criterion.joint_limits = true;
      const auto counts = expectVerdictsHold(machine, criterion, SEED + 1);
      EXPECT_GT(counts.second, 10) << machine.name();
    }
}

TEST(BoxTest, verdictsHoldForMotorsAndTolerances)
{
  for (const Machine& machine : test::everyKind())
  {
    int inside = 0;
    for (const auto& [name, criterion] : test::drivenCriteria(machine))
    {
      SCOPED_TRACE(name);
      const auto counts = expectVerdictsHold(machine, criterion, SEED + 2);
      inside += counts.first;
      EXPECT_GT(counts.second, 10) << machine.name();
    }
    EXPECT_GT(inside, 20) << machine.name() << ": the law was hardly tried";
  }
}

TEST(BoxTest, verdictsHoldWithHingeLimits)
{
  for (const Machine& machine : { orthoglide(), test::crooked(4) })
  {
    Criterion criterion = test::withMotors(machine);
    criterion.hinge_limits = true;
    const auto counts = expectVerdictsHold(test::hinged(machine), criterion, SEED + 3);
    EXPECT_GT(counts.first, 2);
    EXPECT_GT(counts.second, 10);
  }
}

TEST(BoxTest, pointsAreDecided)
{
  const Machine machine = test::crooked(5);
  const BoxTest test(machine, Criterion());
  const test::Oracle oracle(machine, Criterion());
  test::RandomBoxes random(SEED);
  for (int k = 0; k < test::cases(2000); ++k)
  {
    const Eigen::Vector3d point = random.pointIn(test::spaceOf(machine));
    EXPECT_EQ(test.classify(point), oracle.isGood(point) ? BoxVerdict::INSIDE : BoxVerdict::OUTSIDE)
        << "seed " << SEED << ", point " << point.transpose();
  }
}

TEST(BoxTest, partsOfADecidedBoxKeepItsVerdict)
{
  const Machine machine = orthoglide();
  const BoxTest test(machine, Criterion());
  test::RandomBoxes random(SEED);
  for (int k = 0; k < test::cases(3000); ++k)
  {
    const Box box = random.boxIn(test::spaceOf(machine), 1.0);
    const BoxVerdict verdict = test.classify(box);
    if (verdict == BoxVerdict::UNDECIDED)
      continue;
    const BoxVerdict opposite = verdict == BoxVerdict::INSIDE ? BoxVerdict::OUTSIDE : BoxVerdict::INSIDE;
    const auto halves = box.bisect(box.widestAxis());
    EXPECT_NE(test.classify(halves.first), opposite) << "seed " << SEED << ", box " << k;
    EXPECT_NE(test.classify(halves.second), opposite) << "seed " << SEED << ", box " << k;
  }
}

// docs/values.md: the diagonal of the Orthoglide is dextrous from k = -1/4 to k = 1/2, t = k / sqrt(1 + 2 k^2).
TEST(BoxTest, diagonalOfTheOrthoglideEndsWhereItIsKnownTo)
{
  const BoxTest test(orthoglide(), Criterion());
  const auto at = [&test](double k, double shift) {
    return test.classify(Eigen::Vector3d::Constant(k / std::sqrt(1.0 + 2.0 * k * k) + shift));
  };
  for (const double k : { -0.25, 0.5 })
  {
    const double outward = k > 0.0 ? 1e-12 : -1e-12;
    EXPECT_EQ(at(k, -outward), BoxVerdict::INSIDE) << k;
    EXPECT_EQ(at(k, outward), BoxVerdict::OUTSIDE) << k;
  }
}

TEST(BoxTest, verifiesABoxByItsParts)
{
  const BoxTest test(orthoglide(), Criterion());
  const auto share = [&test](double center, double edge, double part_width) {
    const Box cube{ Eigen::Vector3d::Constant(center - edge / 2), Eigen::Vector3d::Constant(center + edge / 2) };
    return verifyBox(test, cube, part_width, 1000000);
  };
  EXPECT_EQ(share(0.086273015, 0.6439, 1e-6), Share::ALL);
  EXPECT_EQ(share(0.086273015, 0.644, 1e-6), Share::SOME);
  EXPECT_EQ(share(0.6, 0.2, 1e-6), Share::NONE);
  EXPECT_EQ(share(0.086273015, 0.6439, 0.5), Share::UNDECIDED) << "too coarse";
}

TEST(BoxTest, marginHasTheSignOfTheCriterion)
{
  for (const Machine& machine : test::everyKind())
  {
    const BoxTest test(machine, Criterion());
    const test::Oracle oracle(machine, Criterion());
    test::RandomBoxes random(SEED);
    for (int k = 0; k < test::cases(300); ++k)
    {
      const Eigen::Vector3d point = random.pointIn(test::spaceOf(machine));
      const double margin = test.margin(point);
      EXPECT_TRUE(std::abs(margin) < 1e-9 || (margin > 0.0) == oracle.isGood(point))
          << machine.name() << ", seed " << SEED << ", point " << point.transpose() << ", margin " << margin;
    }
  }
}

TEST(Criterion, refusesEverythingThatIsOutOfRangeAtOnce)
{
  Criterion criterion;
  criterion.psi_min = 0.0;
  criterion.psi_max = -1.0;
  const auto construct = [&criterion] { BoxTest(orthoglide(), criterion); };
  test::expectThrow<std::invalid_argument>(construct, "psi_min = 0 .*must be positive");
  test::expectThrow<std::invalid_argument>(construct, "psi_max = -1 .*must be positive");
  criterion.psi_min = 2.5;
  criterion.psi_max = 2.0;
  test::expectThrow<std::invalid_argument>(construct, "psi_max = 2 must be at least psi_min = ");
  criterion.psi_max = std::numeric_limits<double>::quiet_NaN();
  test::expectThrow<std::invalid_argument>(construct, "psi_max = nan");
  criterion.force_min = -1.0;
  criterion.kappa_max = 0.5;
  test::expectThrow<std::invalid_argument>(construct, "force_min = -1 .*must be positive");
  test::expectThrow<std::invalid_argument>(construct, "kappa_max = 0.5 .*at least 1");
  criterion.force_min = 2.0;
  criterion.force_max = 1.0;
  test::expectThrow<std::invalid_argument>(construct, "force_max = 1 must be at least force_min = ");
}

TEST(Criterion, forceFactorsBoundTheVelocityFactorsFromTheOtherSide)
{
  Criterion criterion;
  criterion.force_min = 0.3;
  criterion.force_max = 1.5;
  EXPECT_EQ(criterion.largestFactor(), Interval(2.0)) << "1 / 0.3 is larger than psi_max";
  EXPECT_LE((criterion.leastFactor() * Interval(1.5)).lower(), 1.0);
  EXPECT_GE((criterion.leastFactor() * Interval(1.5)).upper(), 1.0);
  criterion.set = Criterion::Set::REACHABLE;
  EXPECT_GT(criterion.largestFactor().lower(), 3.3);
  criterion.force_max = 0.0;
  EXPECT_FALSE(criterion.boundsBelow());
  EXPECT_TRUE(criterion.boundsAbove());
}

// docs/values.md: on the diagonal psi_1 = psi_2 = 1 - k and psi_3 = 1 + 2 k for k > 0 of the unit Orthoglide.
TEST(BoxTest, conditionNumberOnTheDiagonalOfTheOrthoglideEndsWhereItIsKnownTo)
{
  Criterion criterion;
  criterion.set = Criterion::Set::REACHABLE;
  criterion.kappa_max = 2.0;
  const BoxTest test(orthoglide(), criterion);
  const double k = 0.25;  // (1 + 2 k) / (1 - k) = 2
  const double border = k / std::sqrt(1.0 + 2.0 * k * k);
  EXPECT_EQ(test.classify(Eigen::Vector3d::Constant(border - 1e-12)), BoxVerdict::INSIDE);
  EXPECT_EQ(test.classify(Eigen::Vector3d::Constant(border + 1e-12)), BoxVerdict::OUTSIDE);
}
}  // namespace pkm_workspace
