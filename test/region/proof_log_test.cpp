// SPDX-License-Identifier: BSD-3-Clause
// What the search for the largest region tells of the boxes of centers that it closes.
#include <gtest/gtest.h>

#include <map>
#include <random>
#include <vector>

#include "pkm_workspace/region/containment.h"
#include "pkm_workspace/region/largest_region.h"
#include "pkm_workspace/region/reason.h"
#include "support/machines.h"

namespace pkm_workspace
{
namespace
{
struct Closed
{
  Box centers;
  Closing reason;
};

struct Logged
{
  LargestRegion region;
  std::vector<Closed> closed;
};

Logged solve(const Machine& machine, const ShapePtr& shape, const Box& centers, int threads)
{
  Logged result;
  RegionQuery query;
  query.shape = shape;
  query.search_box = centers;
  query.budget.threads = threads;
  query.closed = [&](const Box& box, const Reason& reason) { result.closed.push_back({ box, reason.closing }); };
  result.region = findLargestRegion(machine, query);
  return result;
}

double volumeOf(const Box& box)
{
  return (box.upper - box.lower).prod();
}

const Box CENTERS{ Eigen::Vector3d::Constant(-0.5), Eigen::Vector3d::Constant(0.5) };
}  // namespace

TEST(ProofLog, closedBoxesFillTheSearchBox)
{
  std::map<Closing, int> counts;
  for (const ShapePtr& shape : { makeCube(), makeSphere() })
  {
    const Logged found = solve(orthoglide(), shape, CENTERS, 1);
    ASSERT_EQ(found.region.status, LargestRegion::Status::PROVEN);
    double volume = 0.0;
    for (const Closed& box : found.closed)
    {
      volume += volumeOf(box.centers);
      ++counts[box.reason];
    }
    EXPECT_NEAR(volume, volumeOf(CENTERS), 1e-12);
  }
  EXPECT_GT(counts[Closing::FORM], 0);
  EXPECT_GT(counts[Closing::COMBINATION], 0);
  EXPECT_GT(counts[Closing::BAD_POINT], 0);
  EXPECT_EQ(counts[Closing::UNSETTLED], 0);
}

/// The containment proof shares no forms of centers with the search.
TEST(ProofLog, noClosedBoxHoldsACenterOfALargerRegion)
{
  const unsigned seed = 12;
  RecordProperty("seed", static_cast<int>(seed));
  std::mt19937 random(seed);
  const Machine machine = orthoglide();
  const BoxTest test(machine, Criterion());
  const Logged found = solve(machine, makeCube(), CENTERS, 1);
  for (const Closed& box : found.closed)
    for (int k = 0; k < 4; ++k)
    {
      Eigen::Vector3d center;
      for (int axis = 0; axis < 3; ++axis)
        center[axis] = std::uniform_real_distribution<double>(box.centers.lower[axis], box.centers.upper[axis])(random);
      const auto proof = checkContainment(test, *makeCube(), center, found.region.size_upper_bound, 10000);
      EXPECT_NE(proof.verdict, Containment::INSIDE) << center.transpose();
    }
}

TEST(ProofLog, isTheSameForAnyNumberOfThreads)
{
  const Logged one = solve(orthoglide(), makeCube(), CENTERS, 1);
  const Logged four = solve(orthoglide(), makeCube(), CENTERS, 4);
  ASSERT_EQ(one.closed.size(), four.closed.size());
  for (std::size_t k = 0; k < one.closed.size(); ++k)
  {
    EXPECT_EQ(one.closed[k].centers.lower, four.closed[k].centers.lower);
    EXPECT_EQ(one.closed[k].centers.upper, four.closed[k].centers.upper);
    EXPECT_EQ(one.closed[k].reason, four.closed[k].reason);
  }
}
}  // namespace pkm_workspace
