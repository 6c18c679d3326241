// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/interval/dyadic_partition.h"

#include <gtest/gtest.h>

#include "support/exact.h"
#include "support/random.h"

namespace pkm_workspace
{
namespace test
{
namespace
{
struct Case
{
  double lower;
  double upper;
  int depth;
};

/// Far from the origin more often than not, where faces are rounded most.
Case randomCase(Random& random)
{
  const double lower = random.uniform(-1.0, 1.0) * (random.once(2) ? 1000.0 : 1.0);
  return { lower, lower + random.uniform(0.1, 3.0), random.integer(0, 20) };
}
}  // namespace

TEST(DyadicPartitionContainment, lengthsEncloseTheDistanceOfNeighbouringFaces)
{
  Random random(SEED);
  for (int k = 0; k < cases(2000); ++k)
  {
    const Case some = randomCase(random);
    const DyadicPartition parts(some.lower, some.upper);
    const Interval length = parts.length(some.depth);
    const auto index = static_cast<std::uint32_t>(random.integer(0, (1 << some.depth) - 1));
    const Exact exact = Exact(parts.face(some.depth, index + 1)) - Exact(parts.face(some.depth, index));
    EXPECT_TRUE(exact.mayLieIn(length)) << "seed " << SEED << ", case " << k << ": " << length << " and " << exact;
    EXPECT_LE(length.width(), 1e-11 * std::max(1.0, std::abs(some.lower)));
  }
}

TEST(DyadicPartition, facesAreSharedByNeighboursAndDepths)
{
  Random random(SEED);
  for (int k = 0; k < cases(2000); ++k)
  {
    const Case some = randomCase(random);
    const DyadicPartition parts(some.lower, some.upper);
    EXPECT_EQ(some.lower, parts.face(some.depth, 0));
    EXPECT_EQ(some.upper, parts.face(some.depth, std::uint32_t(1) << some.depth));
    const auto index = static_cast<std::uint32_t>(random.integer(0, (1 << some.depth) - 1));
    EXPECT_EQ(parts.face(some.depth, index), parts.face(some.depth + 1, 2 * index)) << "seed " << SEED << ", " << k;
    EXPECT_LE(parts.face(some.depth, index), parts.face(some.depth, index + 1));
  }
}

TEST(DyadicPartition, isNotDividedWhereFacesWouldMeet)
{
  EXPECT_TRUE(DyadicPartition(0.0, 1.0).canDivide(20));
  EXPECT_FALSE(DyadicPartition(0.0, 1.0).canDivide(50));
  EXPECT_FALSE(DyadicPartition(1e6, 1e6 + 1e-6).canDivide(20));
}
}  // namespace test
}  // namespace pkm_workspace
