// SPDX-License-Identifier: BSD-3-Clause
// What a region can be relied on for: closed forms, the definitions at random points, and what ends the proof.
#include "pkm_workspace/region/guarantee.h"

#include <gtest/gtest.h>

#include <cmath>

#include "support/driven_criteria.h"
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
const CriterionBound& boundNamed(const std::string& name)
{
  for (const CriterionBound& bound : CRITERION_BOUNDS)
    if (bound.name == name)
      return bound;
  throw std::invalid_argument("no bound " + name);
}

GuaranteeQuery queryFor(const Machine& machine, double accuracy = 1e-4)
{
  GuaranteeQuery query;
  query.criterion = withMotors(machine);
  query.accuracy = accuracy;
  return query;
}

Guarantee ofCube(const Machine& machine, const GuaranteeQuery& query, const std::string& name,
                 const Eigen::Vector3d& center, double edge)
{
  return guaranteed(machine, query, boundNamed(name), *makeCube(), center, edge);
}
}  // namespace

// The struts of the Orthoglide are farthest off their rails at a corner: q^2 = 2 (0.1 + 0.25)^2 there.
TEST(Guarantee, isTheClosedFormOfTheOrthoglide)
{
  GuaranteeQuery query = queryFor(orthoglide(), 1e-6);
  query.criterion.joint_speed_max = { 1.0, 1.0, 1.0 };
  const double across = std::sqrt(2.0) * 0.35, along = std::sqrt(1.0 - across * across);
  const Eigen::Vector3d center = Eigen::Vector3d::Constant(0.1);
  const std::pair<const char*, double> values[] = { { "tool_speed_min", along },
                                                    { "strut_angle_max", std::asin(across) },
                                                    { "ball_tilt_max", std::asin(across) } };
  for (const auto& [name, value] : values)
  {
    const Guarantee found = ofCube(orthoglide(), query, name, center, 0.5);
    EXPECT_TRUE(found.complete && found.is_reached) << name;
    EXPECT_LE(found.value.lower(), value * (1.0 + 1e-14)) << name;
    EXPECT_GE(found.value.upper(), value * (1.0 - 1e-14)) << name;
    EXPECT_LE(found.value.width(), 1e-6 * value) << name;
    ASSERT_TRUE(found.limit) << name;
    EXPECT_GE(found.limit->leg, 0) << name;
  }
}

TEST(Guarantee, isKeptByEveryPointAndByNoBetterValue)
{
  for (const Machine& machine : { orthoglide(), uranesx(), crooked(1) })
    for (const CriterionBound& bound : CRITERION_BOUNDS)
    {
      if (!bound.is_optional || bound.kind == Limit::Kind::STRUT_ANGLE_MIN)
        continue;
      SCOPED_TRACE(machine.name() + ", " + bound.name + ", seed " + std::to_string(SEED));
      const GuaranteeQuery query = queryFor(machine);
      const double edge = 0.25 * machine.scale();
      const Guarantee found = ofCube(machine, query, bound.name, machine.zero(), edge);
      ASSERT_TRUE(found.complete);
      const Oracle oracle(machine, query.criterion);
      Limit limit;
      limit.kind = bound.kind;
      const auto valueAt = [&](const Eigen::Vector3d& p) {
        return static_cast<double>(oracle.valueOf(limit, Oracle::Vector{ p.x(), p.y(), p.z() }));
      };
      Random random(SEED);
      for (int k = 0; k < cases(100); ++k)
      {
        Eigen::Vector3d p = machine.zero();
        for (int axis = 0; axis < 3; ++axis)
          p[axis] += 0.5 * edge * (k % 4 == 0 ? (random.once(2) ? 1.0 : -1.0) : random.uniform(-1.0, 1.0));
        const double value = valueAt(p);
        ASSERT_TRUE(bound.is_lower ? value >= found.proved() : value <= found.proved()) << value;
      }
      const double worst = valueAt(found.place);
      EXPECT_TRUE(bound.is_lower ? worst <= found.value.upper() : worst >= found.value.lower()) << worst;
      EXPECT_LE((found.place - machine.zero()).cwiseAbs().maxCoeff(), 0.5 * edge);
    }
}

TEST(Guarantee, isNothingWhereARegionIsNotReached)
{
  const Guarantee found = ofCube(orthoglide(), queryFor(orthoglide()), "tool_speed_min", { 0.5, 0.5, 0.5 }, 1.0);
  EXPECT_FALSE(found.is_reached);
  EXPECT_EQ(found.value, Interval(0.0));
  EXPECT_EQ(found.proved(), 0.0);
  const Guarantee error = ofCube(orthoglide(), queryFor(orthoglide()), "position_error_max", { 0.5, 0.5, 0.5 }, 1.0);
  EXPECT_EQ(error.proved(), INF);
}

// To an accuracy of 1, three halves of the largest angle there is are tried first: more than may be asked for.
TEST(Guarantee, endsWhereWhatMayBeAskedForDoes)
{
  const Guarantee found =
      ofCube(orthoglide(), queryFor(orthoglide(), 1.0), "strut_angle_max", { 0.55, 0.55, 0.0 }, 0.2);
  EXPECT_TRUE(found.is_reached);
  EXPECT_EQ(found.proved(), QUARTER_TURN);
  EXPECT_GT(found.value.lower(), 1.0);
}

TEST(Guarantee, endsWithWhatIsProved)
{
  GuaranteeQuery query = queryFor(crooked(1), 1e-9);
  const Guarantee whole = ofCube(crooked(1), query, "stiffness_min", { 0.0, 0.0, 0.0 }, 0.3);
  query.budget.max_boxes = 10;
  const Guarantee part = ofCube(crooked(1), query, "stiffness_min", { 0.0, 0.0, 0.0 }, 0.3);
  EXPECT_FALSE(part.complete);
  EXPECT_LE(part.value.lower(), whole.value.upper());
  EXPECT_GE(part.value.upper(), whole.value.lower());
}

TEST(Guarantee, needsWhatItCountsWith)
{
  GuaranteeQuery query;
  Problems missing;
  EXPECT_FALSE(canBeGuaranteed(orthoglide(), query.criterion, boundNamed("stiffness_min"), missing));
  ASSERT_EQ(missing.size(), 3U);
  EXPECT_TRUE(canBeGuaranteed(orthoglide(), query.criterion, boundNamed("kappa_max"), missing));
  const auto ask = [&query](const char* name) {
    return [&query, name] { ofCube(orthoglide(), query, name, { 0.0, 0.0, 0.0 }, 0.1); };
  };
  expectThrow<std::invalid_argument>(ask("stiffness_min"), "stiffness_min needs the stiffness of its drive .*'rail_x'");
  expectThrow<std::invalid_argument>(ask("psi_min"), "psi_min is not asked for by itself: .*force factors");
  query.accuracy = 2.0;
  expectThrow<std::invalid_argument>(ask("kappa_max"), "accuracy = 2 .*must be from 1e-12 to 1");
}
}  // namespace test
}  // namespace pkm_workspace
