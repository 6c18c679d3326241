// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/dexterity/point_evaluation.h"

#include <gtest/gtest.h>

#include "support/cases.h"
#include "support/expect_throw.h"
#include "support/machines.h"
#include "support/oracle.h"
#include "support/random.h"

namespace pkm_workspace
{
namespace test
{
namespace
{
using Eigen::Vector3d;

Criterion everything()
{
  Criterion criterion;
  criterion.joint_limits = true;
  criterion.force_min = 0.55;
  criterion.force_max = 1.9;
  criterion.kappa_max = 2.5;
  return criterion;
}

/// Whether all factors of the point lie in [lower, upper], to 100 digits.
bool factorsLieIn(const Machine& machine, const Vector3d& point, double lower, double upper)
{
  Criterion criterion;
  criterion.aspect = Criterion::Aspect::BOTH;
  criterion.psi_min = lower;
  criterion.psi_max = upper;
  return Oracle(machine, criterion).isGood(point);
}
}  // namespace

TEST(PointEvaluation, enclosesWhatMultiplePrecisionSays)
{
  for (const Machine& machine : everyKind())
  {
    const PointEvaluator evaluate(machine, Criterion());
    const Oracle oracle(machine, Criterion());
    RandomBoxes random(SEED);
    int found = 0;
    for (int k = 0; k < cases(100) && !HasFailure(); ++k)
    {
      SCOPED_TRACE(machine.name() + ", seed " + std::to_string(SEED) + ", case " + std::to_string(k));
      const Vector3d point = random.pointIn(spaceOf(machine));
      const PointEvaluation there = evaluate(point);
      EXPECT_EQ(there.verdict, evaluate.test().classify(point));
      if (!there.has_values || there.psi[0].lower() < 1e-6)
        continue;
      ++found;
      const double lower = there.psi[0].lower(), upper = there.psi[2].upper();
      EXPECT_TRUE(factorsLieIn(machine, point, lower, upper));
      EXPECT_FALSE(factorsLieIn(machine, point, std::nextafter(there.psi[0].upper(), upper), upper));
      EXPECT_FALSE(factorsLieIn(machine, point, lower, std::nextafter(there.psi[2].lower(), 0.0)));
      EXPECT_LE(there.psi[2].width(), 1e-9 * upper * upper * upper);
      for (int i = 0; i < 3; ++i)
      {
        const Oracle::Number rho = oracle.joint(i, { point.x(), point.y(), point.z() });
        EXPECT_TRUE(there.rho[static_cast<std::size_t>(i)].lower() <= rho);
        EXPECT_TRUE(there.rho[static_cast<std::size_t>(i)].upper() >= rho);
      }
      EXPECT_TRUE(there.condition.contains(there.psi[2].mid() / there.psi[0].mid()));
    }
    EXPECT_GT(found, cases(5)) << machine.name();
  }
}

// The margins tell what the verdict tells, wherever they are certain.
TEST(PointEvaluation, limitsAndVerdictAgree)
{
  for (const Machine& machine : everyKind())
    for (const Criterion& criterion : { Criterion(), everything() })
    {
      const PointEvaluator evaluate(limited(machine), criterion);
      RandomBoxes random(SEED);
      for (int k = 0; k < cases(200); ++k)
      {
        const PointEvaluation there = evaluate(random.pointIn(spaceOf(machine)));
        const auto violated = [](const Limit& limit) { return limit.isViolated(); };
        const auto kept = [](const Limit& limit) { return limit.margin.lower() >= 0.0; };
        const bool is_bad = std::any_of(there.limits.begin(), there.limits.end(), violated);
        const bool is_good = there.has_values && std::all_of(there.limits.begin(), there.limits.end(), kept);
        ASSERT_FALSE(is_bad && there.verdict == BoxVerdict::INSIDE) << machine.name() << ", case " << k;
        ASSERT_FALSE(is_good && there.verdict == BoxVerdict::OUTSIDE) << machine.name() << ", case " << k;
        ASSERT_EQ(there.binding().isViolated(), is_bad) << machine.name() << ", case " << k;
      }
    }
}

TEST(PointEvaluation, knowsTheIsotropicPoint)
{
  const PointEvaluation there = evaluatePoint(orthoglide(), everything(), Vector3d::Zero());
  EXPECT_EQ(there.verdict, BoxVerdict::INSIDE);
  EXPECT_EQ(there.within_reach, BoxVerdict::INSIDE);
  ASSERT_TRUE(there.has_values);
  EXPECT_TRUE(there.condition.contains(1.0));
  EXPECT_LE(there.condition.width(), 1e-11);
  EXPECT_TRUE(there.det_a.contains(1.0));
  EXPECT_EQ(there.limits.size(), 3U + 1U + 5U) << "the reach of each leg, the aspect, the factors; no joint has limits";
  EXPECT_EQ(name(there.binding().kind), "force_min");
  EXPECT_NEAR(there.binding().margin.mid(), 0.45, 1e-12);
}

TEST(PointEvaluation, hasOnlyTheReachWhereAStrutIsTooShort)
{
  const PointEvaluation there = evaluatePoint(orthoglide(), Criterion(), { 0.9, 0.9, 0.0 });
  EXPECT_EQ(there.verdict, BoxVerdict::OUTSIDE);
  EXPECT_EQ(there.within_reach, BoxVerdict::OUTSIDE);
  EXPECT_FALSE(there.has_values);
  EXPECT_EQ(there.limits.size(), 3U);
  EXPECT_EQ(there.binding().kind, Limit::Kind::REACH);
  EXPECT_EQ(there.binding().leg, 2);
  EXPECT_NEAR(there.binding().margin.mid(), 1.0 - 0.9 * std::sqrt(2.0), 1e-15);
  EXPECT_TRUE(there.binding().isViolated());
  expectThrow<std::invalid_argument>(
      [] {
        evaluatePoint(orthoglide(), Criterion(), { 0.0, std::nan(""), 0.0 });
      },
      "the point .0, nan, 0. m must be finite");
}
}  // namespace test
}  // namespace pkm_workspace
