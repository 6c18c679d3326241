// SPDX-License-Identifier: BSD-3-Clause
// The planes that cut a box: beyond the inner ones all points are good, beyond an outer one none is.
#include <gtest/gtest.h>

#include "pkm_workspace/dexterity/verdict.h"
#include "support/cases.h"
#include "support/every_criterion.h"
#include "support/oracle.h"
#include "support/random.h"
#include "support/same_bits.h"

namespace pkm_workspace
{
namespace
{
using Eigen::Vector3d;
using test::Oracle;
using test::SEED;

/// A box with the border of the set in it, where there is one between two random points.
Box boxAtBorder(const BoxTest& test, const Machine& machine, test::RandomBoxes& random)
{
  const Box space = test::spaceOf(machine);
  Vector3d good = random.pointIn(space);
  for (int k = 0; k < 500 && test.margin(good) < 0.0; ++k)
    good = random.pointIn(space);
  Vector3d bad = random.pointIn(space);
  for (int k = 0; k < 40; ++k)
  {
    const Vector3d middle = 0.5 * (good + bad);
    (test.margin(middle) < 0.0 ? bad : good) = middle;
  }
  const double size = machine.scale() * std::pow(10.0, random.between(-4.0, -0.7));
  const Box unit{ Vector3d::Constant(0.1), Vector3d::Ones() };
  return { bad - size * random.pointIn(unit), bad + size * random.pointIn(unit) };
}

/// constant + gradient . delta at a point of the box, exactly but for the digits.
Oracle::Number heightAt(double constant, const CubeCut& cut, const Box& box, const Vector3d& point)
{
  Oracle::Number height = constant;
  for (int j = 0; j < 3; ++j)
  {
    const Oracle::Number low = box.lower[j], high = box.upper[j];
    height += cut.gradient[static_cast<std::size_t>(j)] * (2 * Oracle::Number(point[j]) - low - high) / (high - low);
  }
  return height;
}

bool isWithin(const BoxCuts& cuts, const Box& box, const Vector3d& point, double CubeCut::*plane)
{
  for (std::size_t k = 0; k < cuts.count; ++k)
  {
    const double constant = cuts.cut[k].*plane;
    if (constant == -INF || (constant != INF && heightAt(constant, cuts.cut[k], box, point) < 0))
      return false;
  }
  return true;
}

struct Tally
{
  int inner = 0, outer = 0, open = 0;
};

void tryBox(const BoxTest& test, const Oracle& oracle, const Box& box, test::RandomBoxes& random, Tally& tally)
{
  BoxCuts cuts;
  test.kernel().cuts(&box, 1, &cuts);
  for (int sample = 0; sample < 20; ++sample)
  {
    const Vector3d point = random.pointIn(box);
    const bool is_good = oracle.isGood(point);
    const bool is_inner = !cuts.violated && isWithin(cuts, box, point, &CubeCut::inner);
    const bool may_be = !cuts.violated && isWithin(cuts, box, point, &CubeCut::outer);
    ++(is_inner ? tally.inner : may_be ? tally.open : tally.outer);
    EXPECT_TRUE(is_good || !is_inner) << "point " << point.transpose() << ", " << box.maxWidth();
    EXPECT_TRUE(!is_good || may_be) << "point " << point.transpose() << ", " << box.maxWidth();
  }
}
}  // namespace

TEST(BoxCuts, pointsBeyondThePlanesAreWhatTheySay)
{
  for (const Machine& machine :
       { orthoglide(), test::crooked(6), uranesx(), test::crooked(2, 1000.0), test::crookedMix(7) })
    for (const test::MachineCase& each : test::everyCondition(machine))
    {
      SCOPED_TRACE(machine.name() + ", " + each.name + ", seed " + std::to_string(SEED));
      const BoxTest test(each.machine, each.criterion);
      const Oracle oracle(each.machine, each.criterion);
      test::RandomBoxes random(SEED);
      Tally tally;
      for (int k = 0; k < test::cases(25); ++k)
        tryBox(test, oracle, boxAtBorder(test, each.machine, random), random, tally);
      EXPECT_GT(tally.outer, 50);
      EXPECT_LT(tally.open, tally.inner + tally.outer);
    }
}

// At the ends of the diagonal an eigenvalue is double (docs/values.md): what holds for one vector does not for another.
TEST(BoxCuts, pointsNextToDoubleEigenvalues)
{
  const BoxTest test(orthoglide(), Criterion());
  const Oracle oracle(orthoglide(), Criterion());
  test::RandomBoxes random(SEED);
  Tally tally;
  for (int k = 0; k < test::cases(300); ++k)
  {
    const double end = random.between(0.0, 1.0) < 0.5 ? -0.25 : 0.5;
    const double size = std::pow(10.0, random.between(-4.0, -1.0));
    const Vector3d place = Vector3d::Constant(end / std::sqrt(1.0 + 2.0 * end * end)) +
                           size * random.pointIn({ Vector3d::Constant(-2.0), Vector3d::Constant(2.0) });
    const Vector3d half = size * random.pointIn({ Vector3d::Constant(0.3), Vector3d::Ones() });
    tryBox(test, oracle, { place - half, place + half }, random, tally);
  }
  EXPECT_GT(tally.inner, 200) << "seed " << SEED;
  EXPECT_GT(tally.outer, 200);
}

// What one box is told depends neither on the others nor on the processor.
TEST(BoxCuts, areTheSameInEveryKernelAndBatch)
{
  for (const test::MachineCase& each : test::everyCondition(test::crooked(3)))
  {
    SCOPED_TRACE(each.name);
    const BoxTest test(each.machine, each.criterion);
    test::RandomBoxes random(SEED);
    std::vector<Box> boxes;
    while (boxes.size() < 9)
      boxes.push_back(boxAtBorder(test, each.machine, random));
    const auto kernels = boxKernels(test.model());
    for (const auto& kernel : kernels)
    {
      std::vector<BoxCuts> together(boxes.size());
      kernel->cuts(boxes.data(), boxes.size(), together.data());
      for (std::size_t k = 0; k < boxes.size(); ++k)
      {
        BoxCuts alone;
        kernels.back()->cuts(&boxes[k], 1, &alone);
        ASSERT_EQ(alone.violated, together[k].violated);
        for (std::size_t n = 0; !alone.violated && n < alone.count; ++n)
        {
          EXPECT_EQ(alone.count, together[k].count);
          EXPECT_TRUE(test::sameBits(alone.cut[n].inner, together[k].cut[n].inner));
          EXPECT_TRUE(test::sameBits(alone.cut[n].outer, together[k].cut[n].outer));
          for (std::size_t j = 0; j < 3; ++j)
            EXPECT_TRUE(test::sameBits(alone.cut[n].gradient[j], together[k].cut[n].gradient[j]));
        }
      }
    }
  }
}
}  // namespace pkm_workspace
