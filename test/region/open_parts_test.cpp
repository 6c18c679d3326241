// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "pkm_workspace/region/path_check.h"
#include "region/paths.h"
#include "support/random.h"

namespace pkm_workspace
{
namespace test
{
namespace
{
void expectOpenPartsHold(const PathResult& result, const Oracle& oracle, const ExactSegment& exact, RandomBoxes& random)
{
  const PathOffence& first = *result.first;
  ASSERT_FALSE(first.open.empty());
  EXPECT_EQ(first.open.front().first, first.good_until);
  EXPECT_EQ(first.open.back().last, first.bad_at.value_or(first.open.back().last));
  double end_of_last = 0.0;
  for (const PathPart& part : first.open)
  {
    ASSERT_LE(end_of_last, part.first);
    ASSERT_LE(part.first, part.last);
    for (int k = 0; k < 10 && end_of_last < part.first; ++k)
      EXPECT_TRUE(oracle.isGood(exact.point(random.between(end_of_last, part.first))));
    end_of_last = part.last;
  }
  for (int k = 0; k < 10 && !first.bad_at && end_of_last < 1.0; ++k)
    EXPECT_TRUE(oracle.isGood(exact.point(random.between(end_of_last, 1.0))));
}

/// A bound on the least factor that the segment touches within, before it goes below it; where it does.
std::optional<std::pair<double, double>> touch(const Machine& machine, const PathSegment& segment)
{
  constexpr int STEPS = 200;
  const auto least = [&](double t) {
    const auto jacobian = jacobians(machine, segment.point(t));
    return jacobian ? transmissionFactors(*jacobian)[0] : 0.0;
  };
  double lowest = least(0.0);
  for (int k = 1; k < STEPS; ++k)
  {
    const auto at = [&](int step) { return least(static_cast<double>(k + step) / STEPS); };
    if (at(0) < lowest && at(0) < at(-1) && at(0) < at(1) && at(0) > 0.05 && least(1.0) < 0.9 * at(0))
    {
      double a = static_cast<double>(k - 1) / STEPS, b = static_cast<double>(k + 1) / STEPS;
      for (int step = 0; step < 100; ++step)
      {
        const double left = a + (b - a) / 3.0, right = b - (b - a) / 3.0;
        if (least(left) < least(right))
          b = right;
        else
          a = left;
      }
      return std::make_pair(least(0.5 * (a + b)), 0.5 * (a + b));
    }
    lowest = std::min(lowest, at(0));
  }
  return std::nullopt;
}
}  // namespace

TEST(OpenParts, areAllThatIsNotProved)
{
  forEachSegment(
      SEED, 12,
      [&](const PointEvaluator& evaluator, const Oracle& oracle, const ExactSegment& exact, RandomBoxes& random) {
        const PathResult result = checkPath(evaluator, { exact.segment });
        if (result.first)
          expectOpenPartsHold(result, oracle, exact, random);
      });
}

TEST(OpenParts, goOnBehindATouchToWhereThePathLeaves)
{
  int touches = 0, apart = 0;
  RandomBoxes random(SEED);
  for (int k = 0; k < cases(1000) && !HasFailure(); ++k)
  {
    const Machine machine = crooked(static_cast<unsigned>(k % 5));
    const ExactSegment exact = randomSegment(machine, random);
    const auto [bound, place] = touch(machine, exact.segment).value_or(std::make_pair(0.0, 0.0));
    if (bound == 0.0)
      continue;
    SCOPED_TRACE("seed " + std::to_string(SEED) + ", case " + std::to_string(k) + ", bound " + std::to_string(bound));
    Criterion criterion;
    criterion.psi_min = bound * (1.0 - 4e-16);
    criterion.psi_max = 1000.0;
    const PathResult result = checkPath(machine, criterion, { exact.segment });
    ASSERT_EQ(result.verdict, Containment::OUTSIDE);
    expectOpenPartsHold(result, Oracle(machine, criterion), exact, random);
    ++touches;
    const PathPart& last = result.first->open.back();
    if (last.first < place)  // rounding has the path cross the border there
      continue;
    ++apart;
    EXPECT_LE(last.last - last.first, 1e-9);
    EXPECT_LE(result.first->open.front().last - result.first->open.front().first, 1e-3);
    EXPECT_LE(result.looks, 6000);
  }
  EXPECT_GE(touches, cases(8));
  EXPECT_GT(2 * apart, touches);
}
}  // namespace test
}  // namespace pkm_workspace
