// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/dexterity/region_check.h"

#include <gtest/gtest.h>

#include <map>

#include "paper/unit_ball.h"
#include "pkm_workspace/dexterity/characteristic_polynomial.h"
#include "pkm_workspace/region/containment.h"
#include "support/cases.h"
#include "support/machines.h"
#include "support/random.h"

namespace pkm_workspace
{
namespace
{
using test::SEED;
const Eigen::Vector3d ALL_ONES = Eigen::Vector3d::Ones();

BisectionLimits fine()
{
  BisectionLimits limits;
  limits.center_width = 1e-3;
  limits.part_width = 1e-6;
  limits.max_centers = 20000;
  limits.max_parts = 20000;
  return limits;
}

/// The whole space but for a small ball: regions go bad at any of their points, not at corners first.
BoxVerdict allButASmallBall(const Box& box)
{
  constexpr double RADIUS = 0.02;
  if (test::nearest(box) > RADIUS * RADIUS)
    return BoxVerdict::INSIDE;
  return test::farthest(box) < RADIUS * RADIUS ? BoxVerdict::OUTSIDE : BoxVerdict::UNDECIDED;
}

/// @param least how far the farthest point of a region is from the center of the unit ball, for the best of the centers
/// @param largest the same for the worst of the centers
Share shareInUnitBall(double least, double largest)
{
  return largest <= 1.0 ? Share::ALL : least > 1.0 ? Share::NONE : Share::SOME;
}
}  // namespace

TEST(RegionCheck, agreesWithWhatIsKnownOfTheBall)
{
  test::RandomBoxes random(SEED);
  const Box space{ -1.2 * ALL_ONES, 1.2 * ALL_ONES };
  int decided = 0;
  for (int k = 0; k < test::cases(5000); ++k)
  {
    const Box centers = random.boxIn(space, 1.0);
    Eigen::Vector3d edges = Eigen::Vector3d::Constant(random.between(0.05, 1.3));
    edges.z() *= k % 3 == 0 ? 0.0 : 1.0;
    const Eigen::Vector3d near = centers.lower.cwiseMax(-centers.upper).cwiseMax(0.0) + 0.5 * edges;
    const Eigen::Vector3d far = centers.lower.cwiseAbs().cwiseMax(centers.upper.cwiseAbs()) + 0.5 * edges;
    const Share share = checkCenters(test::unitBall, centers, edges, fine());
    EXPECT_TRUE(share == Share::UNDECIDED || share == shareInUnitBall(near.norm(), far.norm()))
        << "seed " << SEED << ", case " << k;
    decided += share != Share::UNDECIDED;
  }
  EXPECT_GT(decided, test::cases(5000) * 9 / 10);
}

TEST(RegionCheck, findsTheBadPointInTheMiddleOfARegion)
{
  test::RandomBoxes random(SEED);
  const Eigen::Vector3d edges = Eigen::Vector3d::Constant(0.5);
  const auto check = [&edges](const Eigen::Vector3d& center) {
    return checkCenters(allButASmallBall, { center, center }, edges, fine());
  };
  for (int k = 0; k < test::cases(100); ++k)
  {
    const Eigen::Vector3d center = random.pointIn({ -0.23 * ALL_ONES, 0.23 * ALL_ONES });
    EXPECT_EQ(check(center), Share::NONE) << "seed " << SEED << ", case " << k;
    EXPECT_EQ(check(center + Eigen::Vector3d(0.51, 0.0, 0.0)), Share::ALL) << "seed " << SEED << ", case " << k;
  }
  EXPECT_EQ(checkCenters(allButASmallBall, { -0.2 * ALL_ONES, 0.2 * ALL_ONES }, edges, fine()), Share::NONE);
  EXPECT_EQ(checkCenters(allButASmallBall, { 0.1 * ALL_ONES, 0.4 * ALL_ONES }, edges, fine()), Share::SOME);
}

namespace
{
/// Draws centers from the box and asks the other way to verdicts about the region of each.
void expectHolds(Share share, const BoxTest& other_way, const Box& centers, double edge, test::RandomBoxes& random)
{
  const Containment contradiction = share == Share::ALL ? Containment::OUTSIDE : Containment::INSIDE;
  for (int sample = 0; sample < 5 && (share == Share::ALL || share == Share::NONE); ++sample)
  {
    const Eigen::Vector3d center = random.pointIn(centers);
    EXPECT_NE(checkContainment(other_way, *makeCube(), center, edge).verdict, contradiction)
        << "seed " << SEED << ", center " << center.transpose() << ", edge " << edge;
  }
}
}  // namespace

TEST(RegionCheck, answersHoldForEveryCenterWithEitherTest)
{
  for (const Machine& machine : { orthoglide(), test::crooked(4), test::cone() })
  {
    const BoxTest box_test(machine, Criterion());
    const BoxClassifier classifiers[] = { CharacteristicTest(machine, Criterion()),
                                          [&box_test](const Box& box) { return box_test.classify(box); } };
    const Box space{ machine.zero() - 0.5 * ALL_ONES, machine.zero() + 0.5 * ALL_ONES };
    BisectionLimits limits = fine();
    limits.max_centers = 10;
    test::RandomBoxes random(SEED);
    std::map<Share, int> count;
    for (int k = 0; k < test::cases(40); ++k)
    {
      SCOPED_TRACE(machine.name() + ", case " + std::to_string(k));
      const Box centers = random.boxIn(space, 0.4);
      const double edge = random.between(0.05, 0.5);
      const Share share = checkCenters(classifiers[k % 2], centers, edge * ALL_ONES, limits);
      expectHolds(share, box_test, centers, edge, random);
      ++count[share];
    }
    EXPECT_GT(count[Share::ALL], 0) << machine.name();
    EXPECT_GT(count[Share::NONE], 0) << machine.name();
  }
}

TEST(RegionCheck, separatesTheLargestCubeFromTheNextOne)
{
  const CharacteristicTest test(orthoglide(), Criterion());
  const Box optimum{ 0.086273015 * ALL_ONES, 0.086273015 * ALL_ONES };
  EXPECT_EQ(checkCenters(test, optimum, 0.6439 * ALL_ONES, fine()), Share::ALL);
  EXPECT_EQ(checkCenters(test, optimum, 0.644 * ALL_ONES, fine()), Share::NONE);
  const Box around{ 0.08 * ALL_ONES, 0.09 * ALL_ONES };
  EXPECT_EQ(checkCenters(test, around, 0.65 * ALL_ONES, fine()), Share::NONE);
  EXPECT_EQ(checkCenters(test, around, 0.62 * ALL_ONES, fine()), Share::ALL);
}
}  // namespace pkm_workspace
