// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "pkm_workspace/region/path_check.h"
#include "region/paths.h"
#include "support/expect_throw.h"
#include "support/random.h"

namespace pkm_workspace
{
namespace test
{
namespace
{
using Eigen::Vector3d;

struct Told
{
  std::vector<SegmentCheck> checks;
  PathResult result;
};

Told check(const PointEvaluator& evaluator, const PathQuery& query, const std::vector<PathStep>& steps)
{
  Told told;
  PathChecker checker(evaluator, query, [&told](const SegmentCheck& found) { told.checks.push_back(found); });
  for (const PathStep& step : steps)
    checker.add(step);
  told.result = checker.finish();
  return told;
}

PathStep at(const PathSegment& segment, const Interval& speed, std::size_t id)
{
  PathStep step(segment);
  step.tool_speed = speed;
  step.id = id;
  return step;
}

const PathSegment ALONG_X = PathSegment::line({ 0.0, 0.0, 0.0 }, { 0.01, 0.0, 0.0 });
}  // namespace

// In the Orthoglide's middle a joint goes as fast as the tool.
TEST(PathSteps, eachIsHeldAtItsOwnSpeed)
{
  const PointEvaluator evaluator(orthoglide(), Criterion());
  PathQuery query;
  query.holds_limits = true;
  query.limits.speed = { 0.2, 0.2, 0.2 };
  const Told told =
      check(evaluator, query,
            { at(ALONG_X, Interval(0.1), 7), at(ALONG_X, Interval(0.3), 9), at(ALONG_X, Interval(0.0), 11),
              at(ALONG_X, Interval(0.19, 0.21), 13), at(ALONG_X, Interval(0.21, 0.22), 15), ALONG_X });
  const std::array<Containment, 6> expected = { Containment::INSIDE,    Containment::OUTSIDE, Containment::INSIDE,
                                                Containment::UNDECIDED, Containment::OUTSIDE, Containment::OUTSIDE };
  ASSERT_EQ(told.checks.size(), expected.size());
  for (std::size_t k = 0; k < expected.size(); ++k)
    EXPECT_EQ(told.checks[k].verdict, expected[k]) << k;
  EXPECT_EQ(told.result.first->segment, 9U);
  EXPECT_EQ(told.result.first->tool_speed, Interval(0.3));
  EXPECT_NEAR(told.checks[0].motion->joint_speed[0], 0.1, 1e-3);
  EXPECT_EQ(told.checks[2].motion->joint_speed[0], 0.0);
}

TEST(PathSteps, accelerationsGrowWithTheSquareOfTheSpeed)
{
  const PointEvaluator evaluator(orthoglide(), Criterion());
  PathQuery query;
  query.holds_limits = true;
  query.wants_rates = true;
  const PathRates slow = *check(evaluator, query, { at(ALONG_X, Interval(0.1), 1) }).result.rates;
  const PathRates fast = *check(evaluator, query, { at(ALONG_X, Interval(0.3), 1) }).result.rates;
  for (std::size_t i = 0; i < 3; ++i)
    EXPECT_NEAR(fast.joint_acceleration[i], 9.0 * slow.joint_acceleration[i], 1e-12);
  query.limits.acceleration = { INF, 4.0 * slow.joint_acceleration[1], INF };
  EXPECT_EQ(check(evaluator, query, { at(ALONG_X, Interval(0.15), 1) }).result.verdict, Containment::INSIDE);
  EXPECT_EQ(check(evaluator, query, { at(ALONG_X, Interval(0.3), 1) }).result.verdict, Containment::OUTSIDE);
}

/// One speed for all is the speed of the query: no bit differs, wherever a path is good or bad.
TEST(PathSteps, oneSpeedForAllIsTheQuerys)
{
  forEachSegment(SEED, 10, [&](const PointEvaluator& evaluator, const Oracle&, const ExactSegment& exact, auto&) {
    PathQuery query;
    query.holds_limits = true;
    query.limits.speed = { 0.3, 0.3, 0.3 };
    query.tool_speed = 0.37;
    const PathResult all = checkPath(evaluator, { exact.segment }, query);
    query.tool_speed = 1.0;
    const PathResult each = check(evaluator, query, { at(exact.segment, Interval(0.37), 0) }).result;
    EXPECT_EQ(each.verdict, all.verdict);
    EXPECT_EQ(each.looks, all.looks);
    EXPECT_EQ(each.motion.has_value(), all.motion.has_value());
    EXPECT_TRUE(!all.motion || each.motion->joint_speed == all.motion->joint_speed);
    EXPECT_TRUE(!all.first || each.first->bad_at == all.first->bad_at);
  });
}

TEST(PathSteps, asManyOffencesAreToldAsAreAskedFor)
{
  const PointEvaluator evaluator(orthoglide(), Criterion());
  const PathSegment leaves = PathSegment::line({ 0.0, 0.0, 0.0 }, { 0.6, 0.6, 0.6 });
  PathQuery query;
  query.most_offences = 2;
  const Told told = check(evaluator, query, { leaves, ALONG_X, leaves, leaves });
  EXPECT_TRUE(told.checks[0].offence);
  EXPECT_FALSE(told.checks[1].offence) << "inside";
  ASSERT_TRUE(told.checks[2].offence);
  EXPECT_FALSE(told.checks[3].offence);
  EXPECT_EQ(told.checks[2].offence->segment, 2U);
  EXPECT_EQ(told.checks[2].offence->bad_at, told.checks[2].bad_at);
  EXPECT_EQ(told.checks[2].offence->limit.kind, Limit::Kind::PSI_MIN);
}

TEST(PathSegment, helicesEndWhereTheyAreTold)
{
  const Box space{ Vector3d::Constant(-2.0), Vector3d::Constant(2.0) };
  RandomBoxes random(SEED);
  for (int k = 0; k < cases(200); ++k)
  {
    const Vector3d start = random.pointIn(space), center = random.pointIn(space);
    const Vector3d axis = Vector3d::Unit(k % 3) * (k % 2 == 0 ? 1.0 : -1.0);
    const double angle = random.between(0.1, 6.2), lift = random.between(-1.0, 1.0);
    const int turns = 1 + k % 4;
    SCOPED_TRACE("seed " + std::to_string(SEED) + ", case " + std::to_string(k));
    const PathSegment helix = PathSegment::arc(start, center, axis, angle + 2.0 * M_PI * (turns - 1), lift);
    const PathSegment to = PathSegment::helixTo(start, center, axis, helix.point(1.0), turns);
    const PathSegment around = PathSegment::helixTo(start, center, axis, start + 0.5 * axis, turns);
    for (const double t : { 0.1, 0.5, 1.0 })
    {
      EXPECT_LE((to.point(t) - helix.point(t)).norm(), 1e-12);
      const Eigen::AngleAxisd turn(t * 2.0 * M_PI * turns, axis);
      EXPECT_LE((around.point(t) - (center + turn * (start - center) + 0.5 * t * axis)).norm(), 1e-12);
    }
  }
  const Vector3d o(0.0, 0.0, 0.0), x(1.0, 0.0, 0.0), z(0.0, 0.0, 1.0);
  expectThrow<std::invalid_argument>(
      [&] {
        PathSegment::helixTo(x, o, z, { 0.0, 1.0002, 5.0 });
      },
      "is 0.000200001 m beside the circle .* radius 1 m; allowed are 1e-05 m");
  expectThrow<std::invalid_argument>([&] { PathSegment::helixTo(x, o, z, x, 9999); }, "turns = 9999");
}
}  // namespace test
}  // namespace pkm_workspace
