// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "pkm_workspace/dexterity/region_check.h"
#include "support/cases.h"
#include "support/machines.h"
#include "support/oracle.h"
#include "support/random.h"

namespace pkm_workspace
{
namespace
{
using test::SEED;

/// The last point towards @p outside, to the resolution of doubles, that the oracle calls good.
Eigen::Vector3d borderBetween(const test::Oracle& oracle, const Eigen::Vector3d& inside, const Eigen::Vector3d& outside)
{
  double good = 0.0;
  double bad = 1.0;
  for (int step = 0; step < 60; ++step)
  {
    const double middle = 0.5 * (good + bad);
    (oracle.isGood(Eigen::Vector3d(inside + middle * (outside - inside))) ? good : bad) = middle;
  }
  return inside + good * (outside - inside);
}
}  // namespace

// Paper, section 2.2: what no double settles has no width left to bisect; multi-precision goes on.
TEST(Precision, settlesPointsAtTheBorderThatDoublesLeaveOpen)
{
  const Machine machine = orthoglide();
  for (const double kappa_max : { 0.0, 2.5 })
  {
    Criterion criterion;
    criterion.kappa_max = kappa_max;
    const test::Oracle oracle(machine, criterion);
    const BoxTest doubles(machine, criterion);
    const BoxTest multiple(machine, criterion, Precision::MULTIPLE);
    test::RandomBoxes random(SEED);
    int open = 0;
    for (int k = 0; k < test::cases(50); ++k)
    {
      const Eigen::Vector3d direction = random.pointIn(test::spaceOf(machine));
      const Eigen::Vector3d border = borderBetween(oracle, Eigen::Vector3d::Zero(), direction.normalized());
      const BoxVerdict verdict = multiple.classify(border);
      open += doubles.classify(border) == BoxVerdict::UNDECIDED ? 1 : 0;
      EXPECT_NE(verdict, BoxVerdict::UNDECIDED) << border.transpose() << ", seed " << SEED;
      EXPECT_EQ(verdict == BoxVerdict::INSIDE, oracle.isGood(border)) << border.transpose() << ", seed " << SEED;
    }
    EXPECT_GT(open, 25) << "doubles would have been enough";
  }
}

TEST(Precision, aBoxWithoutWidthIsBeyondPrecisionOfEither)
{
  const BoxTest doubles(orthoglide(), Criterion());
  const BoxTest multiple(orthoglide(), Criterion(), Precision::MULTIPLE);
  const Eigen::Vector3d point(0.25, 0.25, 0.25);
  const Eigen::Vector3d near = point + Eigen::Vector3d::Constant(5e-14);
  EXPECT_TRUE(doubles.isBeyondPrecision({ point, point }));
  EXPECT_TRUE(multiple.isBeyondPrecision({ point, point }));
  EXPECT_TRUE(doubles.isBeyondPrecision({ point, near }));
  EXPECT_FALSE(multiple.isBeyondPrecision({ point, near }));
  EXPECT_EQ(doubles.finerKernel({ point, near }), nullptr);
  EXPECT_NE(multiple.finerKernel({ point, near }), nullptr);
}

/// No verdict of the precise kernel on a small box is contradicted by a point of it, whatever the bounds.
TEST(Precision, verdictsHoldAtEveryPointOfTheBox)
{
  Criterion condition;
  condition.set = Criterion::Set::REACHABLE;
  condition.kappa_max = 4.0;
  for (const Machine& machine : { orthoglide(), test::limited(test::crooked(1)) })
    for (Criterion criterion : { Criterion(), condition })
    {
      criterion.joint_limits = true;
      const auto kernel = preciseKernel(machine, criterion);
      const test::Oracle oracle(machine, criterion);
      test::RandomBoxes random(SEED);
      int decided = 0;
      for (int k = 0; k < test::cases(100); ++k)
      {
        const Box box = random.boxIn(test::spaceOf(machine), 0.3 * machine.scale());
        BoxVerdict verdict = BoxVerdict::UNDECIDED;
        kernel->classify(&box, 1, &verdict);
        decided += verdict == BoxVerdict::UNDECIDED ? 0 : 1;
        for (int sample = 0; verdict != BoxVerdict::UNDECIDED && sample < 3; ++sample)
          EXPECT_EQ(oracle.isGood(random.pointIn(box)), verdict == BoxVerdict::INSIDE)
              << machine.name() << ", box " << k;
      }
      EXPECT_GT(decided, 50);
    }
}
}  // namespace pkm_workspace
