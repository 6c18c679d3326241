// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "pkm_workspace/machine/catalogue.h"
#include "support/exact_vector.h"
#include "support/expect_throw.h"
#include "support/random.h"

namespace pkm_workspace
{
namespace test
{
namespace
{
using Eigen::Vector3d;

constexpr double SPREAD = 7.0 / 13.0 - 3.0 / 26.0;  // R - r

Vector3d reachablePoint(Random& random)
{
  return { random.uniform(-0.4, 0.4), random.uniform(-0.4, 0.4), random.uniform(-3.0, 3.0) };
}

TEST(UraneSX, standsOnItsAxisBelowTheSlidersAtZero)
{
  const Machine machine = uranesx();
  EXPECT_NEAR(machine.zero().z(), -std::sqrt(1.0 - SPREAD * SPREAD), 1e-15);
  EXPECT_EQ(machine.zero().head<2>(), Eigen::Vector2d::Zero());
  EXPECT_LE(inverseKinematics(machine, machine.zero())->cwiseAbs().maxCoeff(), 1e-15);
  for (int i = 0; i < 3; ++i)
    EXPECT_LT(jacobians(machine, machine.zero())->b[i], 0.0) << "the struts point down";
}

/// The cylinders of section 4.2 of the paper, with the sign of an equilateral triangle for legs 2 and 3.
TEST(UraneSX, reachesWhatLiesInItsThreeCylinders)
{
  const Machine machine = uranesx();
  for (int seed = 0; seed < cases(1000); ++seed)
  {
    Random random(static_cast<std::uint64_t>(seed));
    const Vector3d p(random.uniform(-1.2, 1.2), random.uniform(-1.2, 1.2), random.uniform(-1.0, 1.0));
    const double half = SPREAD / 2.0, height = SPREAD * std::sqrt(3.0) / 2.0;
    const Eigen::Vector2d axes[] = { { SPREAD, 0.0 }, { -half, height }, { -half, -height } };
    bool inside = true;
    for (const auto& axis : axes)
      inside = inside && (p.head<2>() - axis).norm() < 1.0;
    EXPECT_EQ(inverseKinematics(machine, p).has_value(), inside) << p.transpose() << " seed " << seed;
  }
}

TEST(UraneSX, doesNotChangeAlongItsRails)
{
  const Machine machine = uranesx();
  for (int seed = 0; seed < cases(); ++seed)
  {
    Random random(static_cast<std::uint64_t>(seed));
    const Vector3d p = reachablePoint(random);
    const double shift = random.uniform(-2.0, 2.0);
    const Vector3d moved = p + shift * Vector3d::UnitZ();
    const Vector3d change = *inverseKinematics(machine, moved) - *inverseKinematics(machine, p);
    EXPECT_LE((change - Vector3d::Constant(shift)).norm(), 1e-14) << "seed " << seed;
    EXPECT_LE((jacobians(machine, moved)->j_inverse - jacobians(machine, p)->j_inverse).norm(), 1e-13)
        << "seed " << seed;
  }
}

TEST(UraneSX, isTheSameAfterAThirdOfATurn)
{
  const Machine machine = uranesx();
  const Eigen::AngleAxisd turn(2.0 * std::acos(-1.0) / 3.0, Vector3d::UnitZ());
  for (int seed = 0; seed < cases(); ++seed)
  {
    Random random(static_cast<std::uint64_t>(seed));
    const Vector3d p = reachablePoint(random);
    const Vector3d rho = *inverseKinematics(machine, p);
    const Vector3d turned = *inverseKinematics(machine, turn * p);
    EXPECT_LE((turned - Vector3d(rho[2], rho[0], rho[1])).norm(), 1e-14) << "seed " << seed;
    const Vector3d psi = transmissionFactors(*jacobians(machine, p));
    EXPECT_LE((psi - transmissionFactors(*jacobians(machine, turn * p))).norm(), 1e-13) << "seed " << seed;
  }
}

/// On the axis |q_i| = R - r in three directions: two factors are sqrt(3/2) |q| / |eta|, along the rails it is sqrt 3.
TEST(UraneSX, hasTheClosedFormFactorsOnItsAxis)
{
  const auto matrices = jacobians(uranesx(), Vector3d(0.0, 0.0, 0.25));
  ASSERT_TRUE(matrices);
  const double across = std::sqrt(1.5) * SPREAD / std::sqrt(1.0 - SPREAD * SPREAD);
  EXPECT_LE((transmissionFactors(*matrices) - Vector3d(across, across, std::sqrt(3.0))).norm(), 1e-14);
}

TEST(UraneSX, dependsOnTheDifferenceOfItsRadiiOnly)
{
  const Machine machine = uranesx(Interval(0.75), Interval(0.25));
  const Machine other = uranesx(Interval(1.0), Interval(0.5));
  for (int seed = 0; seed < cases(); ++seed)
  {
    Random random(static_cast<std::uint64_t>(seed));
    const Vector3d p = reachablePoint(random);
    EXPECT_LE((*inverseKinematics(machine, p) - *inverseKinematics(other, p)).norm(), 1e-14) << "seed " << seed;
  }
}

TEST(UraneSX, enclosesItsFractionsAndRoots)
{
  const Machine machine = uranesx();
  const Exact radius = Exact(7.0) / 13.0;
  const Exact half_root = sqrt(Exact(3.0)) / 2.0;
  EXPECT_TRUE(radius.mayLieIn(slidingStrut(machine.leg(0)).origin[0]));
  EXPECT_TRUE((-radius * half_root).mayLieIn(slidingStrut(machine.leg(2)).origin[1]));
  EXPECT_TRUE((-(Exact(3.0) / 26.0) / 2.0).mayLieIn(slidingStrut(machine.leg(1)).platform[0]));
  EXPECT_LE(slidingStrut(machine.leg(1)).origin[1].width(), 4.0 * std::numeric_limits<double>::epsilon());
}

TEST(UraneSX, refusesRadiiWithoutAMachine)
{
  using Error = std::invalid_argument;
  const Interval half(0.5);
  expectThrow<Error>([&] { uranesx(half, half); },
                     R"(R - r = \[0, 0\] m must lie between 0 and the strut length L = 1 m)");
  expectThrow<Error>([&] { uranesx(half, Interval(0.75)); }, R"(R - r = \[-0\.25, -0\.25\] m)");
  expectThrow<Error>([&] { uranesx(Interval(1.5), half); }, R"(R - r = \[1, 1\] m)");
  expectThrow<Error>([&] { uranesx(Interval(0.4, 0.6), half); }, "R - r = ");
  expectThrow<Error>([&] { uranesx(half, Interval(0.25), 0.0); }, "strut length L = 0 m");
}
}  // namespace
}  // namespace test
}  // namespace pkm_workspace
