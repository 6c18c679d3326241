// SPDX-License-Identifier: BSD-3-Clause
// Verdicts on convex hulls: no point of a hull that is INSIDE is bad, none of one that is OUTSIDE is good.
#include <gtest/gtest.h>

#include "pkm_workspace/dexterity/verdict.h"
#include "support/cases.h"
#include "support/every_criterion.h"
#include "support/oracle.h"
#include "support/random.h"

namespace pkm_workspace
{
namespace
{
using Eigen::Vector3d;
using test::SEED;

/// Around a point of the border, of any size.
SmallHull hullAtBorder(const BoxTest& test, const Machine& machine, test::RandomBoxes& random)
{
  const Box space = test::spaceOf(machine);
  Vector3d good = random.pointIn(space), bad = random.pointIn(space);
  for (int k = 0; k < 300 && test.margin(good) < 0.0; ++k)
    good = random.pointIn(space);
  for (int k = 0; k < 40; ++k)
  {
    const Vector3d middle = 0.5 * (good + bad);
    (test.margin(middle) < 0.0 ? bad : good) = middle;
  }
  const double size = machine.scale() * std::pow(10.0, random.between(-4.0, -1.0));
  const Box around{ Vector3d::Constant(-size), Vector3d::Constant(size) };
  const Vector3d place = bad + 0.7 * random.pointIn(around);
  SmallHull hull;
  for (Vector3d& corner : hull)
    corner = place + random.pointIn(around);
  if (random.between(0.0, 1.0) < 0.5)
    hull[4] = hull[5] = hull[3];
  return hull;
}

/// A corner, or a point between all of them.
Vector3d pointOf(const SmallHull& hull, int sample, test::RandomBoxes& random)
{
  if (sample < 6)
    return hull[static_cast<std::size_t>(sample)];
  Vector3d sum = Vector3d::Zero();
  double weights = 0.0;
  for (const Vector3d& corner : hull)
  {
    const double weight = std::pow(random.between(0.0, 1.0), 3.0);
    sum += weight * corner;
    weights += weight;
  }
  return sum / weights;
}
}  // namespace

TEST(Hull, verdictsHoldAtItsPoints)
{
  for (const Machine& machine : { orthoglide(), test::crooked(6), uranesx(), delta(), test::crookedMix(7) })
  {
    int inside = 0, outside = 0;
    for (const test::MachineCase& each : test::everyCondition(machine))
    {
      SCOPED_TRACE(machine.name() + ", " + each.name + ", seed " + std::to_string(SEED));
      const BoxTest test(each.machine, each.criterion);
      const test::Oracle oracle(each.machine, each.criterion);
      test::RandomBoxes random(SEED);
      for (int k = 0; k < test::cases(60); ++k)
      {
        const SmallHull hull = hullAtBorder(test, each.machine, random);
        BoxVerdict verdict;
        test.kernel().classify(&hull, 1, &verdict);
        inside += verdict == BoxVerdict::INSIDE ? 1 : 0;
        outside += verdict == BoxVerdict::OUTSIDE ? 1 : 0;
        for (int sample = 0; verdict != BoxVerdict::UNDECIDED && sample < 12; ++sample)
          EXPECT_EQ(oracle.isGood(pointOf(hull, sample, random)), verdict == BoxVerdict::INSIDE) << k;
      }
    }
    EXPECT_GT(inside, 100) << machine.name();
    EXPECT_GT(outside, 100) << machine.name();
  }
}

TEST(Hull, verdictsAreTheSameInEveryKernelAndBatch)
{
  for (const test::MachineCase& each : test::everyCondition(test::crooked(3)))
  {
    const BoxTest test(each.machine, each.criterion);
    test::RandomBoxes random(SEED);
    std::vector<SmallHull> hulls;
    while (hulls.size() < 19)
      hulls.push_back(hullAtBorder(test, each.machine, random));
    const auto kernels = boxKernels(test.model());
    std::vector<BoxVerdict> first;
    for (const auto& kernel : kernels)
    {
      std::vector<BoxVerdict> together(hulls.size());
      kernel->classify(hulls.data(), hulls.size(), together.data());
      for (std::size_t k = 0; k < hulls.size(); ++k)
      {
        BoxVerdict alone;
        kernel->classify(&hulls[k], 1, &alone);
        EXPECT_EQ(alone, together[k]) << each.name;
      }
      first = first.empty() ? together : first;
      EXPECT_TRUE(together == first) << each.name;
    }
  }
}
}  // namespace pkm_workspace
