// SPDX-License-Identifier: BSD-3-Clause
#include "support/octahedron.h"
#include "support/body_points.h"

#include <gtest/gtest.h>

#include "pkm_workspace/machine/catalogue.h"
#include "pkm_workspace/region/containment.h"
#include "pkm_workspace/region/joint_ranges.h"
#include "pkm_workspace/region/largest_region.h"
#include "pkm_workspace/region/region_parts.h"
#include "support/cases.h"
#include "support/machines.h"
#include "support/oracle.h"
#include "support/random.h"

namespace pkm_workspace
{
namespace
{
using test::SEED;

}  // namespace

TEST(Octahedron, isNotTakenForItsBoundingBox)
{
  RegionQuery query;
  query.shape = std::make_shared<test::Octahedron>();
  query.accuracy = 1e-3;
  const LargestRegion region = findLargestRegion(orthoglide(), query);
  ASSERT_EQ(region.status, LargestRegion::Status::PROVEN);
  query.shape = makeCube();
  EXPECT_GT(region.size, findLargestRegion(orthoglide(), query).size_upper_bound) << "a cube of its width is not good";
  EXPECT_LE(region.volume, region.size * region.size * region.size / 6.0);
  EXPECT_GE(region.volume, (1.0 - 1e-12) * region.size * region.size * region.size / 6.0);

  const test::Oracle oracle(orthoglide(), Criterion());
  test::RandomBoxes random(SEED);
  const test::Octahedron shape;
  for (int k = 0; k < test::cases(300); ++k)
    EXPECT_TRUE(oracle.isGood(test::pointOf(shape, region.center, region.size, random)))
        << "seed " << SEED << ", case " << k;
  const BoxTest test(orthoglide(), Criterion());
  const Box around{ region.center.array() - 0.05, region.center.array() + 0.05 };
  for (int k = 0; k < test::cases(30); ++k)
    EXPECT_EQ(checkContainment(test, shape, random.pointIn(around), region.size_upper_bound).verdict,
              Containment::OUTSIDE)
        << "seed " << SEED << ", case " << k;
}

TEST(Octahedron, containmentAndJointRangesAgreeWithTheOracle)
{
  const test::Octahedron shape;
  for (const Machine& machine : { orthoglide(), uranesx(), test::crooked(4) })
  {
    const BoxTest test(machine, Criterion());
    const test::Oracle oracle(machine, Criterion());
    test::RandomBoxes random(SEED);
    int inside = 0;
    for (int k = 0; k < test::cases(30); ++k)
    {
      const Eigen::Vector3d center = random.pointIn(test::spaceOf(machine));
      const double size = machine.scale() * random.between(0.01, 0.5);
      const ContainmentResult result = checkContainment(test, shape, center, size);
      EXPECT_FALSE(result.bad_point && oracle.isGood(*result.bad_point)) << "seed " << SEED << ", case " << k;
      if (result.verdict != Containment::INSIDE)
        continue;
      ++inside;
      const auto ranges = jointRanges(machine, shape, center, size);
      for (int sample = 0; sample < 10; ++sample)
      {
        const Eigen::Vector3d p = test::pointOf(shape, center, size, random);
        EXPECT_TRUE(oracle.isGood(p)) << machine.name() << ", seed " << SEED << ", case " << k;
        for (int leg = 0; leg < 3; ++leg)
        {
          const test::Oracle::Number rho = oracle.joint(leg, { p.x(), p.y(), p.z() });
          EXPECT_TRUE(rho >= ranges[static_cast<std::size_t>(leg)].lower.lower() &&
                      rho <= ranges[static_cast<std::size_t>(leg)].upper.upper())
              << machine.name() << ", leg " << leg << ", seed " << SEED << ", case " << k;
        }
      }
    }
    EXPECT_GT(inside, 0) << machine.name();
  }
}

TEST(Octahedron, hasItsOwnConditioning)
{
  constexpr int SAMPLES = 20000;
  const Eigen::Vector3d center(0.1, 0.05, 0.0625);
  const test::Octahedron shape;
  ConditioningQuery query;
  query.accuracy = 0.04;
  const GlobalConditioning result = globalConditioning(orthoglide(), shape, center, 0.5, query);
  EXPECT_TRUE(result.complete);
  EXPECT_LE(result.measure.lower(), 0.125 / 6.0);
  EXPECT_GE(result.measure.upper(), 0.125 / 6.0);
  EXPECT_LT(result.measure.upper(), 0.125 / 2.0);
  test::RandomBoxes random(SEED);
  double sum = 0.0;
  int found = 0;
  while (found < SAMPLES)
  {
    const Eigen::Vector3d p = random.pointIn(shape.boundingBox(center, 0.5));
    if (!shape.contains(p, { center, center }, 0.5))
      continue;
    const Eigen::Vector3d psi = transmissionFactors(*jacobians(orthoglide(), p));
    sum += psi[0] / psi[2];
    ++found;
  }
  EXPECT_LE(result.index.lower(), sum / SAMPLES + 0.005);
  EXPECT_GE(result.index.upper(), sum / SAMPLES - 0.005);
}
}  // namespace pkm_workspace
