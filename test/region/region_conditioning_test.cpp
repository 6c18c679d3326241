// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "pkm_workspace/machine/catalogue.h"
#include "pkm_workspace/region/region_parts.h"
#include "support/cases.h"
#include "support/expect_throw.h"
#include "support/random.h"

namespace pkm_workspace
{
namespace
{
using test::SEED;
constexpr int SAMPLES = 20000;

/// The mean over random points of the region; its error is a few thousandths.
double sampledIndex(const Machine& machine, const Shape& shape, const Eigen::Vector3d& center, double size)
{
  test::RandomBoxes random(SEED);
  const Box bounds = shape.boundingBox(center, size);
  double sum = 0.0;
  int found = 0;
  while (found < SAMPLES)
  {
    const Eigen::Vector3d p = random.pointIn(bounds);
    if (!shape.contains(p, { center, center }, size))
      continue;
    const Eigen::Vector3d psi = transmissionFactors(*jacobians(machine, p));
    sum += psi[0] / psi[2];
    ++found;
  }
  return sum / SAMPLES;
}
}  // namespace

TEST(RegionConditioning, holdsTheMeanOverRandomPointsOfEveryShape)
{
  const Machine machine = orthoglide();
  const Eigen::Vector3d center(0.1, 0.05, 0.0625);
  ConditioningQuery query;
  query.accuracy = 0.04;
  for (const ShapePtr& shape :
       { makeCube(), makeSquare(), makeBox({ 1.0, 2.0, 0.5 }), makeSphere(), makeDisc(), makeCylinder(0.5) })
  {
    const GlobalConditioning result = globalConditioning(machine, *shape, center, 0.25, query);
    const double mean = sampledIndex(machine, *shape, center, 0.25 * (shape->isBox() ? 1.0 - 1e-9 : 1.0));
    EXPECT_TRUE(result.complete) << shape->name();
    EXPECT_LE(result.index.lower(), mean + 0.005) << shape->name();
    EXPECT_GE(result.index.upper(), mean - 0.005) << shape->name();
  }
}

TEST(RegionConditioning, refusesAnEmptyRegion)
{
  const auto compute = [] { globalConditioning(orthoglide(), *makeCube(), Eigen::Vector3d::Zero(), 0.0, {}); };
  test::expectThrow<std::invalid_argument>(compute, "size = 0 m must be positive");
}

TEST(RegionConditioning, measureIsThatOfTheRegionNotOfItsBoundingBox)
{
  test::RandomBoxes random(SEED);
  ConditioningQuery query;
  query.accuracy = 1.0;
  for (int k = 0; k < 50; ++k)
  {
    const double size = random.between(1e-6, 1e-3);
    const Eigen::Vector3d center(random.between(-0.1, 0.1), random.between(-0.1, 0.1), random.between(-0.1, 0.1));
    const Interval volume = makeCube()->volume(size);
    const GlobalConditioning cube = globalConditioning(orthoglide(), *makeCube(), center, size, query);
    EXPECT_LE(cube.measure.lower(), volume.lower()) << "case " << k << ", seed " << SEED;
    EXPECT_GE(cube.measure.upper(), volume.upper()) << "case " << k << ", seed " << SEED;
  }
}
}  // namespace pkm_workspace
