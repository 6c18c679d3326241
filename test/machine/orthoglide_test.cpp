// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>

#include <Eigen/Dense>

#include "pkm_workspace/machine/catalogue.h"
#include "support/expect_throw.h"
#include "support/random.h"

namespace pkm_workspace
{
namespace test
{
namespace
{
using Eigen::Vector3d;

TEST(Orthoglide, isIsotropicAtTheOriginWithAllJointsAtZero)
{
  for (const double length : { 1.0, 0.31058, 1000.0 })
  {
    const Machine machine = orthoglide(length);
    const auto matrices = jacobians(machine, Vector3d::Zero());
    ASSERT_TRUE(matrices);
    EXPECT_EQ(*inverseKinematics(machine, Vector3d::Zero()), Vector3d::Zero());
    EXPECT_EQ(matrices->j_inverse, Eigen::Matrix3d::Identity());
    EXPECT_EQ(transmissionFactors(*matrices), Vector3d::Ones());
    EXPECT_EQ(machine.aspect(), 1);
  }
}

TEST(Orthoglide, hasEnclosuresWithoutWidthWhereNothingIsRounded)
{
  const auto certified = configurationAt(orthoglide(4.0), Vector3d(Vector3d::Zero()));
  ASSERT_TRUE(certified);
  EXPECT_EQ(certified->rho, (IntervalVector{ 0.0, 0.0, 0.0 }));
  EXPECT_EQ(certified->eta, (IntervalVector{ 4.0, 4.0, 4.0 }));
  EXPECT_EQ(certified->det_a, Interval(64.0));
}

/// On the diagonal p = (t, t, t), k = t / sqrt(1 - 2 t^2): J^-1 has the eigenvalues 1 + 2k once and 1 - k twice.
TEST(Orthoglide, hasTheClosedFormEigenvaluesOnItsDiagonal)
{
  const Machine machine = orthoglide();
  for (double t = -0.7; t < 0.7; t += 0.01)
  {
    const double k = t / std::sqrt(1.0 - 2.0 * t * t);
    const auto matrices = jacobians(machine, Vector3d::Constant(t));
    ASSERT_TRUE(matrices) << t;
    Vector3d expected(std::abs(1.0 + 2.0 * k), std::abs(1.0 - k), std::abs(1.0 - k));
    std::sort(expected.data(), expected.data() + 3);
    const Vector3d psi = transmissionFactors(*matrices);
    EXPECT_LE((psi - expected).norm(), 1e-13 * (1.0 + k * k) / (1.0 - 2.0 * t * t)) << "t = " << t;
    EXPECT_LE((matrices->j_inverse * Vector3d::Ones() - Vector3d::Constant(1.0 + 2.0 * k)).norm(),
              1e-12 * (1.0 + k * k));
  }
}

TEST(Orthoglide, treatsItsThreeAxesAlike)
{
  const Machine machine = orthoglide();
  for (int seed = 0; seed < cases(); ++seed)
  {
    Random random(static_cast<std::uint64_t>(seed));
    const Vector3d p(random.uniform(-0.5, 0.5), random.uniform(-0.5, 0.5), random.uniform(-0.5, 0.5));
    const Vector3d turned(p[2], p[0], p[1]);
    const Vector3d rho = *inverseKinematics(machine, p);
    const Vector3d rho_turned = *inverseKinematics(machine, turned);
    EXPECT_LE((rho_turned - Vector3d(rho[2], rho[0], rho[1])).norm(), 1e-15) << "seed " << seed;
    const Vector3d psi = transmissionFactors(*jacobians(machine, p));
    EXPECT_LE((psi - transmissionFactors(*jacobians(machine, turned))).norm(), 1e-13) << "seed " << seed;
  }
}

TEST(Orthoglide, hasTransmissionFactorsThatDoNotDependOnItsSize)
{
  for (int seed = 0; seed < cases(); ++seed)
  {
    Random random(static_cast<std::uint64_t>(seed));
    const Vector3d p(random.uniform(-0.4, 0.4), random.uniform(-0.4, 0.4), random.uniform(-0.4, 0.4));
    const Vector3d psi = transmissionFactors(*jacobians(orthoglide(), p));
    for (const double length : { 0.31058, 1000.0 })
      EXPECT_LE((transmissionFactors(*jacobians(orthoglide(length), length * p)) - psi).norm(), 1e-13)
          << "seed " << seed;
  }
}

TEST(Orthoglide, hasNoAssemblyWhereOnlyOtherWorkingModesFit)
{
  const Machine machine = orthoglide();
  // The paper counts rho from the origin, the machine from the zero configuration: (1, 1, 1) there is (2, 2, 2) here.
  EXPECT_FALSE(forwardKinematics(machine, Vector3d::Constant(2.0))) << "p = 0 and (2, 2, 2) / 3 have eta < 0";
  EXPECT_FALSE(forwardKinematics(machine, Vector3d::Constant(1.0))) << "the three slider points coincide";
  EXPECT_FALSE(forwardKinematics(machine, Vector3d(3.0, 0.0, 0.0))) << "too far apart";
  EXPECT_TRUE(forwardKinematics(machine, Vector3d::Constant(0.3)));
}

TEST(Orthoglide, keepsTheOtherAspectApart)
{
  const Machine own = orthoglide();
  const Vector3d zero = Vector3d::Constant(-0.546);
  const Machine other("orthoglide", own.legs(), zero);
  EXPECT_EQ(other.aspect(), -1);
  const Vector3d rho = *inverseKinematics(own, zero);
  EXPECT_LE((*forwardKinematics(other, rho) - zero).norm(), 1e-12);
  const auto found = forwardKinematics(own, rho);
  EXPECT_TRUE(!found || (*found - zero).norm() > 0.1);
}

TEST(OrthoglidePrototype, hasJustTheTravelThatItsCubeNeeds)
{
  const Machine machine = orthoglidePrototype();
  const double center = 0.31058 * 0.086273015;  // docs/values.md
  for (int i = 0; i < 3; ++i)
  {
    Interval needed = Interval::empty();
    for (const double x : { -0.1, 0.1 })
      for (const double y : { -center, 0.1 })  // the plane through the rail, and the face farthest from it
        for (const double z : { -center, 0.1 })
        {
          Vector3d p = Vector3d::Constant(center);
          p[i] += x;
          p[(i + 1) % 3] += y;
          p[(i + 2) % 3] += z;
          needed = hull(needed, Interval((*inverseKinematics(machine, p))[i]));
        }
    const Interval& limits = machine.leg(i).limits;
    EXPECT_TRUE(needed.isSubsetOf(limits)) << needed << " " << limits;
    EXPECT_LE(limits.width() - needed.width(), 2e-4) << "a tenth of a millimetre at each end";
    EXPECT_NEAR(needed.width(), 0.257, 5e-4) << "docs/values.md";
  }
}

TEST(OrthoglideSingularities, strutAcrossItsRailIsSerial)
{
  const Machine machine = orthoglide(5.0);
  const Vector3d singular(0.0, 3.0, 4.0);  // |q_1| = 5 = L: eta_1 = 0
  EXPECT_FALSE(jacobians(machine, singular));
  const auto certified = configurationAt(machine, singular);
  ASSERT_TRUE(certified);
  EXPECT_EQ(certified->eta[0], Interval(0.0));
  double before = 1.0;
  for (double distance = 0.1; distance > 1e-12; distance /= 4.0)
  {
    const Vector3d p = (1.0 - distance) * singular;
    const double serial = singularityMeasures(*jacobians(machine, p)).serial;
    EXPECT_NEAR(serial, std::sqrt(2.0 * distance - distance * distance), 1e-15 / std::sqrt(distance) + 1e-14);
    EXPECT_LT(serial, before);
    before = serial;
  }
}

TEST(OrthoglideSingularities, parallelStrutsAreParallel)
{
  const Machine machine = orthoglide(3.0);
  const Vector3d singular(1.0, 2.0, 2.0);  // |p| = L: all three struts are p itself
  const auto matrices = jacobians(machine, singular);
  ASSERT_TRUE(matrices);
  for (int i = 0; i < 3; ++i)
    EXPECT_LE((matrices->a.row(i).transpose() - singular).norm(), 1e-14);
  EXPECT_LE(singularityMeasures(*matrices).parallel, 1e-15);
  EXPECT_FALSE(matrices->j.norm() < 1e13) << "the joints do not bound the tool's velocity";
  EXPECT_LE(transmissionFactors(*matrices)[1], 1e-14) << "two factors vanish";
  EXPECT_TRUE(configurationAt(machine, singular)->det_a.contains(0.0));
  EXPECT_FALSE(forwardKinematics(machine, *inverseKinematics(machine, singular)));
}

/// p = -(1, 1, 1) / sqrt 6 with all joints equal (docs/values.md): struts in one plane, none parallel.
TEST(OrthoglideSingularities, strutsInParallelPlanesAreParallelToo)
{
  const Machine machine = orthoglide();
  const Vector3d singular = Vector3d::Constant(-1.0 / std::sqrt(6.0));
  const auto matrices = jacobians(machine, singular);
  const Vector3d rho = *inverseKinematics(machine, singular);
  EXPECT_NEAR(rho.maxCoeff(), rho.minCoeff(), 1e-15);
  EXPECT_LE(singularityMeasures(*matrices).parallel, 1e-15);
  EXPECT_LE(transmissionFactors(*matrices)[0], 1e-15);
  EXPECT_TRUE(configurationAt(machine, singular)->det_a.contains(0.0));
  EXPECT_GT(singularityMeasures(*jacobians(machine, 0.9 * singular)).parallel, 0.01);
  EXPECT_GT(jacobians(machine, 0.9 * singular)->a.determinant(), 0.0);
  EXPECT_LT(jacobians(machine, 1.1 * singular)->a.determinant(), 0.0);
}

TEST(Orthoglide, refusesLengthsThatAreNone)
{
  using Error = std::invalid_argument;
  for (const double length : { 0.0, 1e-300, 9e-10, 1.1e9, 1e200, 1e308 })
  {
    expectThrow<Error>([length] { orthoglide(length); }, "strut length L = .* m must be from 1e-9 m to 1e9 m");
    const Interval radius(0.5 * length);
    expectThrow<Error>([&] { uranesx(radius, Interval(0.0), length); }, "strut length L = .* from 1e-9 m to 1e9 m");
  }
  expectThrow<Error>([] { uranesx(Interval(1e10), Interval(1e10 - 0.5)); }, "platform point must be within 1e9 m");
  expectThrow<Error>([] { orthoglide(-1.0); }, "L = -1 m");
  expectThrow<Error>([] { orthoglide(std::numeric_limits<double>::infinity()); }, "L = inf m");
  expectThrow<Error>([] { orthoglide(std::numeric_limits<double>::quiet_NaN()); }, "L = -?nan m");
}
}  // namespace
}  // namespace test

/// Squares of L and q that are rounded apart told that a strut at its very end does not reach.
TEST(Orthoglide, reachesTheBorderAndKeepsDigitsThere)
{
  const Machine machine = orthoglide(0.31);
  const auto border = inverseKinematics(machine, { 0.0, 0.31, 0.0 });
  ASSERT_TRUE(border);
  EXPECT_EQ((*border)[0], 0.31);
  const double across = 0.31 * (1.0 - 1e-14);
  const auto near = jacobians(machine, { 0.0, across, 0.0 });
  ASSERT_TRUE(near);
  EXPECT_NEAR(near->b[0] / std::sqrt((0.31 - across) * (0.31 + across)), 1.0, 1e-12);
}
}  // namespace pkm_workspace
