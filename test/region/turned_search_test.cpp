// SPDX-License-Identifier: BSD-3-Clause
// How regions that may be turned are looked for.
#include <gtest/gtest.h>

#include "pkm_workspace/region/center_test.h"
#include "pkm_workspace/region/turned_region.h"
#include "region/turned_wishes.h"
#include "support/cases.h"
#include "support/expect_throw.h"

namespace pkm_workspace
{
namespace test
{
using Eigen::Vector3d;

// However the search divides centers and angles, those of a good region are never excluded.
TEST(TurnedSearch, goodRegionsAreNotExcluded)
{
  for (const Machine& machine : { orthoglide(), crooked(4) })
    for (const TurnedWish& turned : turnedWishes())
    {
      SCOPED_TRACE(machine.name() + ", " + turned.wish.name + ", seed " + std::to_string(SEED));
      const RegionQuery query = turnedQuery(turned.wish, 2e-3 * machine.scale());
      const LargestRegion region = findLargestRegion(machine, query);
      const BoxTest test(machine, query.criterion, Precision::DOUBLE);
      const WitnessPoints witnesses(*region.shape, test.zonesToKeepOut());
      CenterTest center_test(test, *region.shape, witnesses);
      RandomBoxes random(SEED);
      for (int k = 0; region.size > 0.0 && k < cases(500); ++k)
      {
        const double width = machine.scale() * std::pow(10.0, random.between(-5.0, -1.0));
        const double turn = std::pow(10.0, random.between(-5.0, -0.5));
        const Vector3d side(width, width, width);
        const Vector3d corner = region.center - random.between(0.0, 1.0) * side;
        const double first = *region.angle - turn * random.between(0.0, 1.0);
        EXPECT_FALSE(center_test.excludes({ corner, corner + side }, region.size, Interval(first, first + turn)))
            << "case " << k;
      }
    }
}

TEST(TurnedSearch, budgetsLeaveBracketsThatHold)
{
  RegionQuery query = turnedQuery({ "box", Vector3d(2.0, 1.0, 1.0) }, 1e-9);
  const LargestRegion whole = findLargestRegion(orthoglide(), query);
  for (const std::int64_t boxes : { 1, 30, 300 })
    for (const int threads : { 1, 3 })
    {
      query.budget.max_boxes = boxes;
      query.budget.threads = threads;
      double upper = INF;
      double lower = 0.0;
      query.progress_period = 0.0;
      query.progress = [&](const RegionProgress& progress) {
        EXPECT_LE(lower, progress.size);
        EXPECT_GE(upper, progress.size_upper_bound);
        lower = progress.size;
        upper = progress.size_upper_bound;
      };
      const LargestRegion part = findLargestRegion(orthoglide(), query);
      EXPECT_EQ(part.status, LargestRegion::Status::STOPPED);
      EXPECT_LE(part.boxes, boxes);
      EXPECT_LE(part.size, whole.size_upper_bound);
      EXPECT_GE(part.size_upper_bound, whole.size);
      EXPECT_LE(lower, part.size);
      EXPECT_GE(upper, part.size_upper_bound);
    }
}

TEST(TurnedSearch, nothingThatTurnsLeavesTheSetsBounds)
{
  for (const TurnedWish& turned : turnedWishes())
  {
    RegionQuery query = turnedQuery(turned.wish, 1e-3);
    const Growing<double> width = leastWidth(*query.shape);
    double least = INF;
    for (int k = 0; k < 1000; ++k)
    {
      const Vector3d n(std::cos(M_PI * k / 1000.0), std::sin(M_PI * k / 1000.0), 0.0);
      const double there = query.shape->support(n).at(0.25) + query.shape->support(Vector3d(-n)).at(0.25);
      EXPECT_LE(width.at(0.25), there * (1.0 + 1e-12)) << turned.wish.name;
      least = std::min(least, there);
    }
    EXPECT_NEAR(width.at(0.25), least, 0.04) << turned.wish.name;
  }
}

TEST(TurnedSearch, shapesThatNoTurnChangesAreRefused)
{
  using Bad = std::invalid_argument;
  for (const char* shape : { "sphere", "disc" })
    expectThrow<Bad>([&] { turnedQuery({ shape }, 1e-3); },
                     "turned is for a square, cube, box or polytope: a " + std::string(shape) + " turned");
  const ShapeWish cylinder{ "cylinder", {}, RatioRange{ 0.5, 1.0 } };
  expectThrow<Bad>([&] { turnedQuery(cylinder, 1e-3); }, "a cylinder turned about the vertical is the same");
  RegionQuery query = turnedQuery({ "square" }, 1e-3);
  query.shape = makeDisc();
  expectThrow<Bad>([&] { findLargestRegion(orthoglide(), query); }, "cannot be turned");
}
}  // namespace test
}  // namespace pkm_workspace
