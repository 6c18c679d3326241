// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/region/path_check.h"

#include <gtest/gtest.h>

#include <Eigen/LU>

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

/// Where the segment leaves the set, by bisection to 60 digits between samples; nothing when no sample is bad.
std::optional<Number> border(const Oracle& oracle, const ExactSegment& exact)
{
  constexpr int SAMPLES = 50;
  for (int k = 0; k <= SAMPLES; ++k)
  {
    if (oracle.isGood(exact.point(Number(k) / SAMPLES)))
      continue;
    Number good = Number(k - 1) / SAMPLES, bad = Number(k) / SAMPLES;
    for (int step = 0; step < 70 && k > 0; ++step)
    {
      const Number middle = (good + bad) / 2;
      (oracle.isGood(exact.point(middle)) ? good : bad) = middle;
    }
    return bad;
  }
  return std::nullopt;
}

void expectHolds(const PathMotion& motion, const Machine& machine, const Vector3d& p)
{
  const auto jacobian = jacobians(machine, p);
  ASSERT_TRUE(jacobian);
  const Vector3d psi = transmissionFactors(*jacobian);
  const Vector3d rho = *inverseKinematics(machine, p);
  for (std::size_t i = 0; i < 3; ++i)
  {
    const int k = static_cast<int>(i);
    EXPECT_GE(psi[k], motion.psi[i].lower() - 1e-9);
    EXPECT_LE(psi[k], motion.psi[i].upper() + 1e-9);
    EXPECT_GE(rho[k], motion.joint[i].lower() - 1e-11 * machine.scale());
    EXPECT_LE(rho[k], motion.joint[i].upper() + 1e-11 * machine.scale());
  }
}
}  // namespace

TEST(PathCheck, verdictsAgreeWithTheOracle)
{
  std::array<int, 3> found{};
  forEachSegment(
      SEED, 40,
      [&](const PointEvaluator& evaluator, const Oracle& oracle, const ExactSegment& exact, RandomBoxes& random) {
        const PathResult result = checkPath(evaluator, { exact.segment });
        ++found[static_cast<std::size_t>(result.verdict)];
        const SegmentCheck& check = result.segments.at(0);
        EXPECT_EQ(check.verdict, result.verdict);
        EXPECT_EQ(result.first.has_value(), result.verdict != Containment::INSIDE);
        EXPECT_EQ(check.good_until == 1.0, result.verdict == Containment::INSIDE);
        for (int k = 0; k < 20; ++k)
          EXPECT_TRUE(check.good_until == 0.0 ||
                      oracle.isGood(exact.point(check.good_until * random.between(0.0, 1.0))));
        ASSERT_EQ(check.bad_at.has_value(), result.verdict == Containment::OUTSIDE);
        EXPECT_FALSE(check.bad_at && oracle.isGood(exact.point(*check.bad_at))) << *check.bad_at;
      });
  EXPECT_GT(found[0], cases(20)) << "inside";
  EXPECT_GT(found[1], cases(20)) << "outside";
  EXPECT_LE(found[2], cases(20)) << "undecided";
}

TEST(PathCheck, theFirstOffenceIsWhereMultiplePrecisionHasIt)
{
  int crossings = 0;
  forEachSegment(SEED, 12,
                 [&](const PointEvaluator& evaluator, const Oracle& oracle, const ExactSegment& exact, auto&) {
                   const PathResult result = checkPath(evaluator, { exact.segment });
                   const auto expected = border(oracle, exact);
                   if (!expected || *expected == 0)
                     return;
                   ASSERT_TRUE(result.first);
                   EXPECT_LE(result.first->good_until, *expected);
                   ASSERT_TRUE(result.first->bad_at);
                   ++crossings;
                   EXPECT_LE(*result.first->bad_at - result.first->good_until, 1e-6);
                   // a sample may miss an earlier offence: then the one found before is proved, and tried by the other
                   // tests
                   EXPECT_LE(Number(*result.first->bad_at), *expected + Number(1e-6));
                 });
  EXPECT_GT(crossings, cases(30));
}

TEST(PathCheck, motionsHoldEveryPointAndSpeedsTheirDifferences)
{
  int inside = 0;
  PathQuery query;
  query.tool_speed = 0.25;
  forEachSegment(
      SEED, 40, [&](const PointEvaluator& evaluator, const Oracle&, const ExactSegment& exact, RandomBoxes& random) {
        const PathResult result = checkPath(evaluator, { exact.segment }, query);
        ASSERT_EQ(result.motion.has_value(), result.verdict == Containment::INSIDE);
        if (!result.motion)
          return;
        ++inside;
        const Machine& machine = evaluator.machine();
        for (int k = 0; k < 10; ++k)
        {
          const double t = random.between(0.0, 0.999);
          const Vector3d p = exact.segment.point(t), q = exact.segment.point(t + 0.001);
          expectHolds(*result.motion, machine, p);
          const double seconds = 0.001 * exact.segment.curve().length().mid() / query.tool_speed;
          const Vector3d speed = (*inverseKinematics(machine, q) - *inverseKinematics(machine, p)).cwiseAbs() / seconds;
          for (int i = 0; i < 3; ++i)
            EXPECT_LE(speed[i], result.motion->joint_speed[static_cast<std::size_t>(i)] + 1e-7);
        }
      });
  EXPECT_GT(inside, cases(20));
}

TEST(PathCheck, motionsAreTight)
{
  // along x from -0.2 to 0.2 the first rail moves with the tool
  const PathResult result =
      checkPath(orthoglide(), Criterion(), { PathSegment::line({ -0.2, 0.0, 0.0 }, { 0.2, 0.0, 0.0 }) });
  ASSERT_TRUE(result.motion);
  EXPECT_NEAR(result.motion->joint[0].lower(), -0.2, 1e-13);
  EXPECT_NEAR(result.motion->joint[0].width(), 0.4, 1e-13);
  EXPECT_NEAR(result.motion->joint_speed[0], 1.0, 1e-12);
  const double slope = 0.2 / std::sqrt(1.0 - 0.04);  // rho_2 = 1 - sqrt(1 - x^2), but for a constant
  EXPECT_NEAR(result.motion->joint_speed[1], slope, 2e-4);
  EXPECT_GE(result.motion->joint_speed[1], slope);
  const Vector3d end = transmissionFactors(*jacobians(orthoglide(), { 0.2, 0.0, 0.0 }));
  EXPECT_NEAR(result.motion->psi[2].upper(), end[2], 2e-4);
  EXPECT_NEAR(result.motion->psi[0].lower(), end[0], 2e-4);
}

// Legs reach as far as cylinders of radius 1: circles of radius 0.5 that pass through the middle touch them.
TEST(PathCheck, grazingIsNeverInside)
{
  const auto circleOf = [](double radius) {
    return PathSegment::circle({ 0.0, 0.0, 0.0 }, { radius, 0.0, 0.0 }, { 0.0, 0.0, 1.0 });
  };
  const auto check = [](const PathSegment& segment) { return checkPath(orthoglide(), reachable(), { segment }); };
  EXPECT_EQ(check(circleOf(0.5 - 1e-12)).verdict, Containment::INSIDE);
  const PathResult touching = check(circleOf(0.5));
  EXPECT_EQ(touching.verdict, Containment::UNDECIDED);
  ASSERT_TRUE(touching.first);
  EXPECT_NEAR(touching.first->good_until, 0.5, 1e-6);
  const PathResult beyond = check(circleOf(0.5 + 1e-10));
  ASSERT_EQ(beyond.verdict, Containment::OUTSIDE);
  EXPECT_NEAR(*beyond.first->bad_at, 0.5, 1e-4);
  EXPECT_EQ(name(beyond.first->limit.kind), "reach");
  EXPECT_EQ(beyond.first->limit.leg, 2) << "the leg of the rail along z";
  const PathSegment along = PathSegment::circle({ 1.0, 0.0, 0.0 }, { 0.0, 0.0, 0.0 }, { 0.0, 0.0, 1.0 });
  EXPECT_NE(check(along).verdict, Containment::INSIDE) << "on the border all the way";
}

TEST(PathCheck, pointsAreSegmentsToo)
{
  const PathSegment good = PathSegment::line({ 0.1, 0.1, 0.1 }, { 0.1, 0.1, 0.1 });
  const PathSegment bad = PathSegment::line({ 0.6, 0.6, 0.6 }, { 0.6, 0.6, 0.6 });
  const PathResult result = checkPath(orthoglide(), Criterion(), { good, bad, good });
  EXPECT_EQ(result.verdict, Containment::OUTSIDE);
  EXPECT_EQ(result.segments[0].verdict, Containment::INSIDE);
  EXPECT_LE(result.segments[0].motion->joint_speed[0], 1e-280) << "the tool rests";
  EXPECT_EQ(result.segments[2].verdict, Containment::INSIDE);
  EXPECT_EQ(result.first->segment, 1U);
  EXPECT_EQ(result.first->good_until, 0.0);
  EXPECT_EQ(result.first->bad_at, 0.0);
  EXPECT_EQ(checkPath(orthoglide(), Criterion(), {}).verdict, Containment::INSIDE);
}

TEST(PathCheck, tellsWhichLimitBinds)
{
  const auto first = [](const Machine& machine, const Criterion& criterion, const Vector3d& end) {
    return checkPath(machine, criterion, { PathSegment::line({ 0.0, 0.0, 0.0 }, end) }).first.value();
  };
  const auto diagonal = first(orthoglide(), Criterion(), { 0.6, 0.6, 0.6 });
  EXPECT_EQ(diagonal.limit.kind, Limit::Kind::PSI_MIN);
  EXPECT_NEAR(diagonal.point.x(), 1.0 / std::sqrt(6.0), 1e-9) << "docs/values.md: the upper corner of the cube";
  EXPECT_NEAR(diagonal.limit.value.mid(), 0.5, 1e-9);
  const auto other = first(orthoglide(), Criterion(), { -0.6, -0.6, 0.6 });
  EXPECT_EQ(other.limit.kind, Limit::Kind::PSI_MAX);
  EXPECT_NEAR(other.point.z(), 1.0 / std::sqrt(3.0), 1e-9);
  const auto lower = first(orthoglide(), Criterion(), { -0.6, -0.6, -0.6 });
  EXPECT_NEAR(lower.point.x(), -1.0 / (3.0 * std::sqrt(2.0)), 1e-9) << "the lower corner of the cube";
  const auto stopped = first(limited(orthoglide()), withLimits(), { 0.0, -0.5, 0.0 });
  EXPECT_EQ(stopped.limit.kind, Limit::Kind::JOINT_LOWER);
  EXPECT_EQ(stopped.limit.leg, 1);
  EXPECT_NEAR(stopped.point.y(), -0.2, 1e-12);
  EXPECT_EQ(first(limited(orthoglide()), withLimits(), { 0.0, 0.0, 0.5 }).limit.kind, Limit::Kind::JOINT_UPPER);
  EXPECT_EQ(first(orthoglide(), conditioned(), { 0.6, 0.6, 0.6 }).limit.kind, Limit::Kind::KAPPA_MAX);
  Criterion forces = reachable();
  forces.force_max = 2.0;
  EXPECT_EQ(first(orthoglide(), forces, { 0.6, 0.6, 0.6 }).limit.kind, Limit::Kind::FORCE_MAX);
  forces.force_min = 0.5;
  EXPECT_EQ(first(orthoglide(), forces, { -0.6, -0.6, 0.6 }).limit.kind, Limit::Kind::FORCE_MIN);
}

TEST(PathCheck, saysTheSameOfASegmentWhereverItStands)
{
  RandomBoxes random(SEED);
  const PointEvaluator evaluator(crooked(4), Criterion());
  std::vector<PathSegment> path;
  while (path.size() < 100)
    path.push_back(randomSegment(evaluator.machine(), random).segment);
  const PathResult result = checkPath(evaluator, path);
  const PathResult again = checkPath(evaluator, path);
  ASSERT_TRUE(result.first);
  EXPECT_EQ(result.first->good_until, again.first->good_until);
  EXPECT_EQ(result.first->bad_at, again.first->bad_at);
  for (std::size_t i = 0; i < path.size(); ++i)
  {
    const SegmentCheck alone = checkPath(evaluator, { path[i] }).segments.at(0);
    EXPECT_EQ(alone.verdict, result.segments[i].verdict);
    EXPECT_EQ(again.segments[i].verdict, result.segments[i].verdict);
    EXPECT_LE(result.segments[i].good_until, alone.good_until);
    if (!alone.motion)
      continue;
    EXPECT_EQ(alone.motion->psi, result.segments[i].motion->psi);
    EXPECT_EQ(alone.motion->joint, result.segments[i].motion->joint);
    EXPECT_EQ(alone.motion->joint_speed, result.segments[i].motion->joint_speed);
  }
}

TEST(PathCheck, endsUndecidedWhenToldTo)
{
  std::vector<PathSegment> path(300, PathSegment::line({ 0.0, 0.0, 0.0 }, { 0.001, 0.0, 0.0 }));
  PathQuery query;
  query.max_looks = 50;
  query.looks_per_piece = 0;
  const PathResult result = checkPath(orthoglide(), Criterion(), path, query);
  EXPECT_EQ(result.verdict, Containment::UNDECIDED);
  EXPECT_EQ(result.segments[0].verdict, Containment::INSIDE);
  EXPECT_EQ(result.segments[299].verdict, Containment::UNDECIDED);
  EXPECT_GT(result.first->segment, 0U);
  EXPECT_EQ(result.end, PathResult::End::LOOKS);
  query = PathQuery();
  const std::atomic<bool> stop(true);
  query.stop = &stop;
  const PathResult stopped = checkPath(orthoglide(), Criterion(), path, query);
  EXPECT_EQ(stopped.verdict, Containment::UNDECIDED);
  EXPECT_EQ(stopped.end, PathResult::End::STOPPED);
  EXPECT_EQ(stopped.looks, 0);
  query = PathQuery();
  query.tool_speed = -1.0;
  query.max_looks = 0;
  query.looks_per_piece = -1;
  expectThrow<std::invalid_argument>([&] { checkPath(orthoglide(), Criterion(), path, query); },
                                     "tool_speed = -1 m/s must be from 1e-9 to 1e9 m/s[^]*max_looks = 0 must be "
                                     "positive[^]*looks_per_piece = -1 must not be negative");
}
TEST(PathCheck, looksGrowWithThePath)
{
  const PathSegment harmless = PathSegment::line({ 0.0, 0.0, 0.0 }, { 0.1, 0.0, 0.0 });
  // all of it is on the border
  const PathSegment along = PathSegment::circle({ 1.0, 0.0, 0.0 }, { 0.0, 0.0, 0.0 }, { 0.0, 0.0, 1.0 });
  PathQuery query;
  query.max_looks = 1;
  std::vector<PathSegment> path(1000, harmless);
  const PathResult inside = checkPath(orthoglide(), reachable(), path, query);
  EXPECT_EQ(inside.verdict, Containment::INSIDE);
  EXPECT_EQ(inside.end, PathResult::End::COMPLETE);
  EXPECT_GT(inside.looks, 1000 * query.max_looks);
  path.assign(60, along);
  path.push_back(harmless);
  query.looks_per_piece = 4;
  const PathResult ended = checkPath(orthoglide(), reachable(), path, query);
  EXPECT_NE(ended.verdict, Containment::INSIDE);
  EXPECT_EQ(ended.end, PathResult::End::LOOKS);
  EXPECT_EQ(ended.segments.back().verdict, Containment::INSIDE) << "each segment brings the first looks at it";
  query.looks_per_piece = 0;
  EXPECT_EQ(checkPath(orthoglide(), reachable(), path, query).segments.back().verdict, Containment::UNDECIDED);
}

}  // namespace test
}  // namespace pkm_workspace
