// SPDX-License-Identifier: BSD-3-Clause
// Speeds and accelerations of the joints along paths, against their definition.
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "pkm_workspace/region/path_check.h"
#include "region/exact_rates.h"
#include "support/expect_throw.h"
#include "support/random.h"

namespace pkm_workspace
{
namespace test
{
namespace
{
using Kind = Limit::Kind;

JointRateLimits randomLimits(double scale, RandomBoxes& random)
{
  JointRateLimits limits;
  for (double& speed : limits.speed)
    speed = random.between(0.1, 1.0);
  if (random.between(0.0, 1.0) < 0.5)
    for (double& acceleration : limits.acceleration)
      acceleration = random.between(0.05, 2.0) / scale;
  return limits;
}

/// The largest tool speed that keeps the limits at this point.
Number feedAt(const ExactRates& rates, const JointRateLimits& limits)
{
  Number feed = 1e300;
  for (std::size_t i = 0; i < 3; ++i)
  {
    if (rates.speed[i] > 0)
      feed = std::min(feed, Number(limits.speed[i] / rates.speed[i]));
    if (rates.acceleration[i] > 0 && limits.acceleration[i] < INF)
      feed = std::min(feed, Number(sqrt(limits.acceleration[i] / rates.acceleration[i])));
  }
  return feed;
}

PathQuery rated(const JointRateLimits& limits, double tool_speed = 1.0)
{
  PathQuery query;
  query.tool_speed = tool_speed;
  query.limits = limits;
  query.holds_limits = true;
  query.wants_rates = true;
  return query;
}
}  // namespace

TEST(JointRates, kernelsHoldTheDifferencesOfEveryPoint)
{
  int points = 0;
  for (const Machine& machine : everyKind())
  {
    const auto kernels = boxKernels(MachineModel<double>(machine, Criterion()));
    const auto precise = preciseKernel(machine, Criterion());
    RandomBoxes random(SEED);
    for (int k = 0; k < cases(400) && !HasFailure(); ++k)
    {
      SCOPED_TRACE(machine.name() + ", seed " + std::to_string(SEED) + ", case " + std::to_string(k));
      const ExactSegment exact = randomSegment(machine, random);
      const double first = random.between(0.0, 0.9);
      const double last = first + 0.1 * std::pow(10.0, -random.between(0.0, 8.0));
      const CurvePiece piece = exact.segment.curve().piece(first, last);
      const SkewBox<double> curvature = exact.segment.curve().curvatures(first, last);
      PieceRates rates, precisely;
      kernels.back()->rates(&piece, &curvature, 1, &rates);
      precise->rates(&piece, &curvature, 1, &precisely);
      if (rates.speed[0].upper == INF)
        continue;
      for (const double t : { first, last, random.between(first, last), random.between(first, last) })
      {
        ++points;
        const ExactRates expected(machine, exact, t);
        for (std::size_t i = 0; i < 3; ++i)
          for (const PieceRates* found : { &rates, &precisely })
          {
            EXPECT_TRUE(isWithin(expected.speed[i], found->speed[i])) << "leg " << i << ", t = " << t;
            EXPECT_TRUE(isWithin(expected.acceleration[i], found->acceleration[i])) << "leg " << i << ", t = " << t;
          }
      }
    }
  }
  EXPECT_GT(points, cases(3000));
}

// rho_2 = 1 - sqrt(1 - x^2) along x, and the other way round on the circle about the end of its rail.
TEST(JointRates, areTightWhereTheyAreKnown)
{
  const auto accelerationsOf = [](const PathSegment& segment, double tool_speed) {
    const PathResult result = checkPath(orthoglide(), Criterion(), { segment }, rated({}, tool_speed));
    return result.rates.value().joint_acceleration;
  };
  const auto line = accelerationsOf(PathSegment::line({ -0.2, 0.0, 0.0 }, { 0.2, 0.0, 0.0 }), 1.0);
  const double expected = std::pow(1.0 - 0.04, -1.5);
  EXPECT_LE(line[0], 1e-12) << "this rail goes with the tool";
  EXPECT_GE(line[1], expected);
  EXPECT_LE(line[1], expected + 2e-3);
  const auto twice = accelerationsOf(PathSegment::line({ -0.2, 0.0, 0.0 }, { 0.2, 0.0, 0.0 }), 2.0);
  EXPECT_NEAR(twice[1], 4.0 * line[1], 1e-12);
  // from the middle of the circle about z the third rail stands still: rho_3 = 1 - sqrt(1 - r^2)
  const auto circle =
      accelerationsOf(PathSegment::circle({ 0.2, 0.0, 0.0 }, { 0.0, 0.0, 0.0 }, { 0.0, 0.0, 1.0 }), 1.0);
  EXPECT_LE(circle[2], 1e-3);
  EXPECT_GE(circle[0], 5.0) << "where it turns, 1 / r";
  const auto point = accelerationsOf(PathSegment::line({ 0.1, 0.1, 0.1 }, { 0.1, 0.1, 0.1 }), 1.0);
  EXPECT_LE(point[0], 1e-280) << "the tool rests";
}

TEST(JointRates, theLargestFeedIsBracketed)
{
  int brackets = 0, points = 0;
  forEachSegment(SEED, 12,
                 [&](const PointEvaluator& evaluator, const Oracle&, const ExactSegment& exact, RandomBoxes& random) {
                   const JointRateLimits limits = randomLimits(evaluator.machine().scale(), random);
                   const PathResult result = checkPath(evaluator, { exact.segment }, rated(limits));
                   const LargestFeed feed = result.rates.value().feed;
                   ASSERT_LE(feed.lower, feed.upper);
                   if (!result.motion && feed.lower == 0.0)
                     return;
                   ++brackets;
                   EXPECT_LE(feed.upper, feed.lower * 1.0011);
                   Number least = 1e300;
                   for (int k = 0; k <= 40; ++k, ++points)
                     least = std::min(least, feedAt(ExactRates(evaluator.machine(), exact, k / 40.0), limits));
                   EXPECT_GE(least, Number(feed.lower) * (1 - Number(1e-15)));
                   EXPECT_LE(least, Number(feed.upper) * 1.05) << "a sample is near the worst point";
                 });
  EXPECT_GT(brackets, cases(40));
  EXPECT_GT(points, cases(1600));
}

TEST(JointRates, verdictsAgreeWithTheFeed)
{
  std::array<int, 2> found{};
  forEachSegment(SEED + 1, 12,
                 [&](const PointEvaluator& evaluator, const Oracle&, const ExactSegment& exact, RandomBoxes& random) {
                   if (checkPath(evaluator, { exact.segment }).verdict != Containment::INSIDE)
                     return;
                   const JointRateLimits limits = randomLimits(evaluator.machine().scale(), random);
                   const LargestFeed feed = checkPath(evaluator, { exact.segment }, rated(limits)).rates.value().feed;
                   const PathResult slow = checkPath(evaluator, { exact.segment }, rated(limits, 0.9999 * feed.lower));
                   EXPECT_EQ(slow.verdict, Containment::INSIDE);
                   const PathResult fast = checkPath(evaluator, { exact.segment }, rated(limits, 1.0001 * feed.upper));
                   ASSERT_EQ(fast.verdict, Containment::OUTSIDE);
                   ASSERT_TRUE(fast.proved);
                   const Limit& limit = fast.proved->limit;
                   ASSERT_TRUE(limit.kind == Kind::JOINT_SPEED || limit.kind == Kind::JOINT_ACCELERATION)
                       << name(limit.kind);
                   const bool is_speed = limit.kind == Kind::JOINT_SPEED;
                   ++found[is_speed ? 0 : 1];
                   const ExactRates rates(evaluator.machine(), exact, *fast.proved->bad_at);
                   const std::size_t leg = static_cast<std::size_t>(limit.leg);
                   const Number speed = 1.0001 * feed.upper;
                   const Number value =
                       is_speed ? Number(speed * rates.speed[leg]) : Number(speed * speed * rates.acceleration[leg]);
                   EXPECT_EQ(limit.bound, (is_speed ? limits.speed : limits.acceleration)[leg]);
                   EXPECT_TRUE(isWithin(value, { limit.value.lower(), limit.value.upper() }));
                   EXPECT_GE(value, Number(limit.bound) * (1 - Number(1e-12)));
                   const double good = fast.proved->good_until * random.between(0.0, 1.0);
                   EXPECT_TRUE(good == 0.0 || feedAt(ExactRates(evaluator.machine(), exact, good), limits) >=
                                                  speed * (1 - Number(1e-12)));
                 });
  EXPECT_GT(found[0], cases(10)) << "by speed";
  EXPECT_GT(found[1], cases(4)) << "by acceleration";
}

// A feed that the motors cannot follow: each carriage makes at least as much as the tool on its way down.
TEST(JointRates, areHeldOnlyWhereThereAreLimitsAndASpeed)
{
  const PathSegment along = PathSegment::line({ -0.1, 0.0, 0.0 }, { 0.1, 0.0, 0.0 });
  JointRateLimits limits;
  limits.speed = { 0.2, 0.2, 0.2 };
  PathQuery query = rated(limits, 0.3);
  const PathResult fast = checkPath(orthoglide(), Criterion(), { along }, query);
  ASSERT_EQ(fast.verdict, Containment::OUTSIDE);
  EXPECT_EQ(fast.first->bad_at, 0.0);
  EXPECT_EQ(fast.first->limit.kind, Kind::JOINT_SPEED);
  EXPECT_EQ(fast.first->limit.leg, 0);
  EXPECT_NEAR(fast.first->limit.value.mid(), 0.3, 1e-14);
  EXPECT_EQ(fast.first->limit.bound, 0.2);
  EXPECT_NEAR(fast.rates->feed.lower, 0.2, 1e-12);
  EXPECT_NEAR(fast.rates->feed.upper, 0.2, 1e-12);
  EXPECT_EQ(fast.rates->feed.leg, 0);
  query.limits.speed = { INF, 0.2, 0.2 };
  EXPECT_EQ(checkPath(orthoglide(), Criterion(), { along }, query).verdict, Containment::INSIDE);
  query.limits.acceleration[2] = 0.05;
  const PathResult bent = checkPath(orthoglide(), Criterion(), { along }, query);
  ASSERT_EQ(bent.verdict, Containment::OUTSIDE);
  EXPECT_EQ(bent.first->limit.kind, Kind::JOINT_ACCELERATION);
  EXPECT_EQ(bent.first->limit.leg, 2);
  query.holds_limits = false;
  EXPECT_EQ(checkPath(orthoglide(), Criterion(), { along }, query).verdict, Containment::INSIDE);
  query.limits.speed[1] = -1.0;
  query.limits.acceleration[0] = 0.0;
  expectThrow<std::invalid_argument>(
      [&] { checkPath(orthoglide(), Criterion(), { along }, query); },
      "joint_speed_max = -1 m/s must be > 0[^]*joint_acceleration_max = 0 m/s\\^2 must be");
}

// Nothing changes for who asks for no limits: neither bits nor looks.
TEST(JointRates, leaveTheRestOfTheAnswerAsItIs)
{
  forEachSegment(SEED, 10, [&](const PointEvaluator& evaluator, const Oracle&, const ExactSegment& exact, auto&) {
    PathQuery query;
    const PathResult plain = checkPath(evaluator, { exact.segment }, query);
    EXPECT_FALSE(plain.rates);
    EXPECT_FALSE(plain.segments[0].rates);
    query.limits.speed = { 0.1, 0.1, 0.1 };
    query.wants_rates = true;
    const PathResult rates = checkPath(evaluator, { exact.segment }, query);
    EXPECT_EQ(rates.verdict, plain.verdict);
    EXPECT_EQ(rates.segments[0].good_until, plain.segments[0].good_until);
    EXPECT_EQ(rates.segments[0].bad_at, plain.segments[0].bad_at);
    EXPECT_TRUE(!plain.motion || rates.motion->joint_speed == plain.motion->joint_speed);
    EXPECT_GT(rates.looks, plain.looks);
  });
}

TEST(JointRates, theFeedOfAPathIsThatOfItsSlowestSegment)
{
  RandomBoxes random(SEED);
  const PointEvaluator evaluator(crooked(4), reachable());
  std::vector<PathSegment> path;
  while (path.size() < 300)
    path.push_back(randomSegment(evaluator.machine(), random).segment);
  JointRateLimits limits;
  limits.speed = { 0.5, 0.6, 0.7 };
  const PathResult result = checkPath(evaluator, path, rated(limits));
  ASSERT_TRUE(result.rates);
  double lower = INF, upper = INF;
  for (std::size_t i = 0; i < path.size(); ++i)
  {
    const LargestFeed feed = result.segments[i].rates.value().feed;
    const LargestFeed alone = checkPath(evaluator, { path[i] }, rated(limits)).rates.value().feed;
    EXPECT_EQ(alone.lower, feed.lower);
    EXPECT_EQ(alone.upper, feed.upper);
    lower = std::min(lower, feed.lower);
    upper = std::min(upper, feed.upper);
  }
  EXPECT_EQ(result.rates->feed.lower, lower);
  EXPECT_EQ(result.rates->feed.upper, upper);
  EXPECT_EQ(result.segments[result.slowest].rates->feed.lower, lower);
}

TEST(JointRates, ofTinyCirclesAreLarge)
{
  for (const double radius : { 1e-150, 1e-140, 1e-120, 1e-100, 1e-60 })
  {
    const PathSegment circle = PathSegment::arc({ radius, 0.0, 0.0 }, { 0.0, 0.0, 0.0 }, { 0.0, 0.0, 1.0 }, 1.0);
    JointRateLimits limits;
    limits.acceleration = { 1.0, 1.0, 1.0 };
    const PathResult result = checkPath(orthoglide(), Criterion(), { circle }, rated(limits));
    EXPECT_NE(result.verdict, Containment::INSIDE) << radius;
    EXPECT_GE(result.rates->joint_acceleration[0], 0.5 / radius) << radius;
    EXPECT_LE(result.rates->feed.lower, 2.0 * std::sqrt(radius)) << radius;
  }
}

TEST(JointRates, aStopLeavesABracketThatHolds)
{
  const std::vector<PathSegment> path(300, PathSegment::line({ 0.0, 0.0, 0.0 }, { 0.001, 0.0, 0.0 }));
  JointRateLimits limits;
  limits.speed = { 0.5, 0.5, 0.5 };
  PathQuery query = rated(limits);
  query.max_looks = 50;
  query.looks_per_piece = 0;
  const PathResult ended = checkPath(orthoglide(), Criterion(), path, query);
  EXPECT_EQ(ended.rates->feed.lower, 0.0) << "nothing is known of the last segments";
  EXPECT_NEAR(ended.rates->feed.upper, 0.5, 1e-9);
  EXPECT_EQ(ended.end, PathResult::End::LOOKS);
  const std::atomic<bool> stop(true);
  query.stop = &stop;
  EXPECT_EQ(checkPath(orthoglide(), Criterion(), path, query).rates->feed.upper, INF);
}
}  // namespace test
}  // namespace pkm_workspace
