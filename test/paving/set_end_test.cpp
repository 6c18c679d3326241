// SPDX-License-Identifier: BSD-3-Clause
// What ends a set on a line, held against the definitions on both sides of the end.
#include "pkm_workspace/paving/set_end.h"

#include <gtest/gtest.h>

#include <map>

#include "support/definition.h"
#include "support/machines.h"
#include "support/random.h"

namespace pkm_workspace
{
namespace test
{
namespace
{
constexpr double SLACK = 1e-5;

/// In the cube from -1 to 1.
Eigen::Vector3d vectorOf(Random& random)
{
  const double x = random.uniform(-1.0, 1.0);
  const double y = random.uniform(-1.0, 1.0);
  return { x, y, random.uniform(-1.0, 1.0) };
}

Criterion withSpeedAndAngle()
{
  Criterion criterion;
  criterion.joint_limits = true;
  criterion.tool_speed_min = 0.85;
  criterion.joint_speed_max = { 1.0, 1.1, 1.2 };
  criterion.strut_angle_max = 0.7;
  return criterion;
}

Criterion reachable()
{
  Criterion criterion;
  criterion.set = Criterion::Set::REACHABLE;
  criterion.joint_limits = true;
  return criterion;
}

/// Walks from good points in all directions. @return by how many ends each condition was met
std::map<ConditionKind, int> walk(const Machine& machine, const Criterion& criterion, Random& random)
{
  const PointEvaluator evaluate(machine, criterion);
  std::map<ConditionKind, int> met;
  for (int k = 0; k < 2000; ++k)
  {
    const Eigen::Vector3d p = machine.zero() + machine.scale() * vectorOf(random);
    const Eigen::Vector3d step = 0.2 * machine.scale() * vectorOf(random);
    const auto end = endOfSet(evaluate, p, step);
    if (!end)
      continue;
    ++met[end->kind];
    EXPECT_LE((end->bad - end->good).norm(), 1.1e-6 * step.norm());
    EXPECT_TRUE(violatedAt(machine, criterion, end->good, SLACK).empty()) << end->good.transpose();
    const std::set<ConditionKind> closely = violatedAt(machine, criterion, end->bad, -SLACK);
    EXPECT_EQ(1U, closely.count(end->kind)) << name(end->kind) << " is kept at " << end->bad.transpose();
    for (const ConditionKind other : violatedAt(machine, criterion, end->bad, SLACK))
      EXPECT_EQ(end->kind, other) << name(other) << " is violated far at " << end->bad.transpose();
    const Eigen::Vector3d beyond = end->bad + 1e-3 * (end->bad - p);
    const bool starts_good = violatedAt(machine, criterion, p).empty();
    EXPECT_FALSE(starts_good && violatedAt(machine, criterion, beyond).empty()) << "goes on at " << beyond.transpose();
  }
  return met;
}
}  // namespace

TEST(SetEnd, isWhereTheFirstConditionFailsByTheDefinitions)
{
  Random random(SEED);
  using Kind = ConditionKind;
  const auto kinds = [&](const Machine& machine, const Criterion& criterion) {
    std::set<Kind> found;
    for (const auto& [kind, count] : walk(machine, criterion, random))
      if (count >= 5)
        found.insert(kind);
    return found;
  };
  EXPECT_EQ((std::set<Kind>{ Kind::PSI_MIN, Kind::PSI_MAX }), kinds(orthoglide(), Criterion()));
  EXPECT_EQ((std::set<Kind>{ Kind::PSI_MIN, Kind::TOOL_SPEED_MIN, Kind::STRUT_ANGLE_MAX }),
            kinds(orthoglide(), withSpeedAndAngle()));
  EXPECT_EQ((std::set<Kind>{ Kind::JOINT_LOWER, Kind::JOINT_UPPER, Kind::PSI_MIN }), kinds(orthoglidePrototype(), [] {
              Criterion criterion;
              criterion.joint_limits = true;
              return criterion;
            }()));
  EXPECT_EQ((std::set<Kind>{ Kind::REACH, Kind::ASPECT }), kinds(crooked(1), reachable()));
}

TEST(SetEnd, isBehindABadPointAndNowhereWhereAllAreAlike)
{
  const PointEvaluator evaluate(orthoglide(), Criterion());
  const Eigen::Vector3d x = Eigen::Vector3d::UnitX();
  EXPECT_FALSE(endOfSet(evaluate, Eigen::Vector3d::Zero(), 0.01 * x));
  EXPECT_FALSE(endOfSet(evaluate, 0.95 * x, 0.01 * x));
  const auto ahead = endOfSet(evaluate, Eigen::Vector3d::Zero(), 0.25 * x);
  const auto behind = endOfSet(evaluate, x * (ahead->bad.x() + 0.1), 0.05 * x);
  ASSERT_TRUE(behind);
  EXPECT_EQ(ahead->kind, behind->kind);
  EXPECT_NEAR(ahead->bad.x(), behind->bad.x(), 1e-5);
}
}  // namespace test
}  // namespace pkm_workspace
