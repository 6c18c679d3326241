// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/interval/half_space.h"

#include <gtest/gtest.h>

#include "pkm_workspace/dexterity/verdict.h"
#include "support/cases.h"
#include "support/machines.h"
#include "support/oracle.h"
#include "support/random.h"

namespace pkm_workspace
{
namespace
{
using test::SEED;

/// One whose plane goes through the box, more often than not.
HalfSpace through(const Box& box, test::RandomBoxes& random)
{
  const Box directions{ Eigen::Vector3d::Constant(-1.0), Eigen::Vector3d::Constant(1.0) };
  HalfSpace half;
  half.normal = random.pointIn(directions);
  half.offset = half.normal.dot(random.pointIn(box));
  return half;
}
/// One whose plane is nearly where the criterion begins to fail, if that is in the box.
HalfSpace along(const BoxTest& test, const Box& box, test::RandomBoxes& random)
{
  const double step = 1e-6 * box.maxWidth();
  Eigen::Vector3d slope;
  for (int axis = 0; axis < 3; ++axis)
    slope[axis] = (test.margin(box.center() + step * Eigen::Vector3d::Unit(axis)) - test.margin(box.center())) / step;
  HalfSpace half;
  half.normal = -slope.normalized();
  const double distance = test.margin(box.center()) / slope.norm();
  half.offset = half.normal.dot(box.center()) + distance - random.between(-0.1, 0.5) * box.maxWidth();
  return half;
}
}  // namespace

// Both aspects together: the verdict within a half-space leaves the aspect open.
TEST(HalfSpace, insideHoldsAtEveryPointOfBoth)
{
  int found = 0;
  for (const Machine& machine : test::everyKind())
    for (const double kappa_max : { 0.0, 3.5, -1.0 })
    {
      Criterion criterion;
      criterion.set = kappa_max < 0.0 ? Criterion::Set::DEXTROUS : Criterion::Set::REACHABLE;
      criterion.kappa_max = std::max(0.0, kappa_max);
      criterion.aspect = Criterion::Aspect::BOTH;
      const BoxTest test(machine, criterion);
      const test::Oracle oracle(machine, criterion);
      test::RandomBoxes random(SEED);
      for (int k = 0; k < test::cases(300); ++k)
      {
        const Box box = random.boxIn(test::spaceOf(machine), 0.5 * machine.scale());
        const HalfSpace half = k % 2 == 0 ? through(box, random) : along(test, box, random);
        BoxVerdict verdict = BoxVerdict::UNDECIDED;
        test.kernel().classify(&box, 1, &verdict, nullptr, &half);
        const BoxVerdict plain = test.classify(box);
        EXPECT_TRUE(plain == BoxVerdict::UNDECIDED || verdict == plain) << machine.name() << ", case " << k;
        found += verdict == BoxVerdict::INSIDE && plain == BoxVerdict::UNDECIDED ? 1 : 0;
        for (int sample = 0; verdict == BoxVerdict::INSIDE && sample < 20; ++sample)
        {
          const Eigen::Vector3d point = random.pointIn(box);
          EXPECT_TRUE(half.normal.dot(point) > half.offset || oracle.isGood(point))
              << machine.name() << ", seed " << SEED << ", case " << k << ", point " << point.transpose();
        }
      }
    }
  EXPECT_GT(found, 20) << "no case in which the half-space made the difference";
}

TEST(HalfSpace, slackEnclosesTheDistanceTimesTheNormal)
{
  test::RandomBoxes random(SEED);
  const Box space{ Eigen::Vector3d::Constant(-2.0), Eigen::Vector3d::Constant(2.0) };
  for (int k = 0; k < test::cases(300); ++k)
  {
    const Box box = random.boxIn(space, 1.0);
    const HalfSpace half = through(box, random);
    const AffineForm<double> slack = slackOf(half, CenteredBox<double>(box));
    const Interval exact = Interval(half.offset) - dot(enclose(half.normal), enclose(random.pointIn(box)));
    EXPECT_LE(slack.lower(), exact.lower()) << "seed " << SEED << ", case " << k;
    EXPECT_GE(slack.upper(), exact.upper()) << "seed " << SEED << ", case " << k;
  }
}

TEST(HalfSpace, noneAtAllChangesNothing)
{
  Criterion criterion;
  criterion.aspect = Criterion::Aspect::BOTH;  // which one point settles where there are no half-spaces
  const BoxTest test(orthoglide(), criterion);
  test::RandomBoxes random(SEED);
  const HalfSpace all;
  for (int k = 0; k < test::cases(200); ++k)
  {
    const Box box = random.boxIn(test::spaceOf(orthoglide()), 0.3);
    BoxVerdict verdict = BoxVerdict::UNDECIDED;
    test.kernel().classify(&box, 1, &verdict, nullptr, &all);
    EXPECT_TRUE(verdict == test.classify(box) || test.classify(box) == BoxVerdict::UNDECIDED) << "case " << k;
  }
}
}  // namespace pkm_workspace
