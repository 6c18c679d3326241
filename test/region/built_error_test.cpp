// SPDX-License-Identifier: BSD-3-Clause
// How far off the tool of any machine within tolerances is from where its controller believes it to be: by the
// definition, in long doubles, for machines at vertices, on edges and inside of the tolerances.
#include <gtest/gtest.h>

#include "pkm_workspace/machine/catalogue.h"
#include "pkm_workspace/region/guarantee.h"
#include "pkm_workspace/region/tolerable_factor.h"
#include "support/built_errors.h"
#include "support/machines.h"

namespace pkm_workspace
{
namespace test
{
namespace
{
using Eigen::Vector3d;

const CriterionBound& errorBound()
{
  return *boundOf(ConditionKind::POSITION_ERROR_MAX);
}

/// Of several kinds, some of them none.
Tolerances someTolerances(Random& random, double size)
{
  Tolerances tolerances;
  const auto some = [&] { return random.once(3) ? 0.0 : size * random.uniform(0.2, 1.0); };
  for (StrutTolerance& by : tolerances)
  {
    by.slider = { some(), some(), some() };
    by.platform = { some(), 0.0, some() };
    by.slider_ball = some();
    by.platform_ball = some();
    by.direction = some();
    by.length = some();
    by.zero = some();
  }
  return tolerances;
}

struct ErrorCase
{
  Machine machine;
  Criterion criterion;
  Vector3d center;
  double edge;
};

std::vector<ErrorCase> errorCases(Random& random)
{
  std::vector<ErrorCase> result;
  for (const Machine& exact : { orthoglide(), uranesx(), crooked(1), crooked(4) })
    for (const double size : { 1e-5, 3e-4 })
    {
      ErrorCase each{
        withTolerances(exact, someTolerances(random, size * exact.scale())), {}, exact.zero(), 0.2 * exact.scale()
      };
      each.criterion.set = Criterion::Set::REACHABLE;
      for (double& error : each.criterion.joint_error_max)
        error = random.once(2) ? size * exact.scale() * random.uniform(0.1, 1.0) : 0.0;
      result.push_back(each);
    }
  return result;
}
}  // namespace

TEST(BuiltError, isBracketedAtPoints)
{
  Random random(SEED);
  for (const ErrorCase& each : errorCases(random))
  {
    SCOPED_TRACE(each.machine.name() + " " + inWords(tolerancesOf(each.machine)));
    Criterion criterion = each.criterion;
    criterion.position_error_max = 1.0;
    const PointEvaluator values(each.machine, criterion);
    for (int k = 0; k < cases(4); ++k)
    {
      const Vector3d point = each.center + each.edge * Vector3d(random.uniform(-0.5, 0.5), random.uniform(-0.5, 0.5),
                                                                random.uniform(-0.5, 0.5));
      Interval told = Interval::empty();
      for (const Limit& limit : values(point).limits)
        if (limit.kind == ConditionKind::POSITION_ERROR_MAX)
          told = limit.value;
      ASSERT_TRUE(told.isBounded() && !told.isEmpty());
      const double worst = worstToolError(each.machine, criterion.joint_error_max, point, random, 3);
      EXPECT_LE(worst, told.upper());
      EXPECT_GE(worst, told.lower() * (1.0 - 1e-6));
      EXPECT_LE(told.width(), 100.0 * told.upper() * told.upper() / each.machine.scale());  // of second order
      for (int n = 0; n < 20; ++n)
        EXPECT_LE(largestToolError(each.machine, randomDeviation(random), criterion.joint_error_max, point),
                  told.upper());
    }
  }
}

TEST(BuiltError, isGuaranteedOverARegion)
{
  Random random(SEED + 1);
  for (const ErrorCase& each : errorCases(random))
  {
    SCOPED_TRACE(each.machine.name() + " " + inWords(tolerancesOf(each.machine)));
    GuaranteeQuery query;
    query.criterion = each.criterion;
    const Guarantee found = guaranteed(each.machine, query, errorBound(), *makeCube(), each.center, each.edge);
    EXPECT_TRUE(found.is_reached);
    ASSERT_TRUE(found.value.isBounded());
    EXPECT_LE(found.value.width(), 0.02 * found.value.upper());
    const double there = worstToolError(each.machine, each.criterion.joint_error_max, found.place, random, 3);
    EXPECT_GE(there, found.value.lower() * (1.0 - 1e-6));
    EXPECT_LE(there, found.value.upper());
    for (int k = 0; k < cases(60); ++k)
    {
      const auto share = [&] { return random.once(2) ? 0.5 * random.sign() : random.uniform(-0.5, 0.5); };
      const Vector3d point = each.center + each.edge * Vector3d(share(), share(), share());
      EXPECT_LE(largestToolError(each.machine, randomDeviation(random), each.criterion.joint_error_max, point),
                found.value.upper());
      if (k % 20 == 0)
      {
        EXPECT_LE(worstToolError(each.machine, each.criterion.joint_error_max, point, random, 1), found.value.upper());
      }
    }
  }
}

/// One strut's length alone: its tool moves along the line across the others, by what the law of cosines says.
TEST(BuiltError, isTheClosedFormOfOneLength)
{
  constexpr double OFF = 1e-3;
  Tolerances tolerances;
  tolerances[0].length = OFF;
  GuaranteeQuery query;
  query.criterion.set = Criterion::Set::REACHABLE;
  const Machine machine = withTolerances(orthoglide(), tolerances);
  const Guarantee found = guaranteed(machine, query, errorBound(), *makeCube(), Vector3d::Zero(), 1e-9);
  // at the isotropic point the other two spheres leave a circle whose tangent is the first strut
  EXPECT_GE(found.value.upper(), OFF);
  EXPECT_LE(found.value.upper(), OFF * (1.0 + 3e-3));
  EXPECT_GE(found.value.lower(), OFF * (1.0 - 2e-3));
}

/// How exactly a machine has to be built for a tool that is no farther off: the machine that is named is.
TEST(BuiltError, namesTheMachineThatErrs)
{
  Random random(SEED + 2);
  for (const Machine& exact : { orthoglide(), crooked(1) })
  {
    const Machine machine = withTolerances(exact, someTolerances(random, 1e-4 * exact.scale()));
    FactorQuery query;
    query.solid = makeSolid(makeCube(), 0.1 * exact.scale());
    query.center = exact.zero();
    query.criterion.position_error_max = 1e-3 * exact.scale();
    const TolerableFactor found = tolerableFactor(machine, query);
    ASSERT_TRUE(found.bad_machine);
    EXPECT_EQ(found.bad_limit->kind, ConditionKind::POSITION_ERROR_MAX);
    EXPECT_LT(found.fails, 1.05 * found.holds);
    double sum = 0.0;
    for (const ToleranceShare& share : found.shares)
      sum += share.share;
    EXPECT_NEAR(sum, 1.0, 0.05);
    Deviation zeros;  // which way joints are off is not told
    double error = 0.0;
    for (int corner = 0; corner < 8; ++corner)
    {
      for (std::size_t leg = 0; leg < 3; ++leg)
        zeros.share[leg][15] = corner & (1 << leg) ? 1.0 : -1.0;
      const Machine all = withTolerances(exact, scaled(tolerancesOf(machine), found.fails));
      error = std::max(error, toolError(all, *found.bad_machine, zeros, {}, {}, *found.bad_point));
    }
    EXPECT_GT(error, query.criterion.position_error_max);
    EXPECT_LT(error, 1.02 * query.criterion.position_error_max);
  }
}

/// Without tolerances all is as before, to first order in the errors of the joints.
TEST(BuiltError, ofTheNominalMachineIsThatOfItsJoints)
{
  GuaranteeQuery query;
  query.criterion.set = Criterion::Set::REACHABLE;
  query.criterion.joint_error_max = { 1e-4, 1e-4, 1e-4 };
  const Machine exact = orthoglide();
  const Guarantee joints = guaranteed(exact, query, errorBound(), *makeCube(), exact.zero(), 0.2);
  Tolerances next_to_none;
  setTolerance(*toleranceKind("tolerance_length"), { 1e-12 }, next_to_none);
  const Guarantee all =
      guaranteed(withTolerances(exact, next_to_none), query, errorBound(), *makeCube(), exact.zero(), 0.2);
  EXPECT_NEAR(joints.value.mid(), all.value.mid(), 2e-3 * joints.value.mid());
  query.criterion.joint_error_max = {};
  EXPECT_THROW(guaranteed(exact, query, errorBound(), *makeCube(), exact.zero(), 0.2), std::invalid_argument);
}
}  // namespace test
}  // namespace pkm_workspace
