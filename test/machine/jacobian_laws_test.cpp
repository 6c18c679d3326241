// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <Eigen/Dense>

#include "support/machine_laws.h"

namespace pkm_workspace
{
namespace test
{
using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr double EPSILON = std::numeric_limits<double>::epsilon();

TEST_P(MachineLaws, velocitiesAreThoseOfDifferencesOfTheInverse)
{
  forEachRegularPoint([this](const Vector3d& p, const ExactConfiguration& there, Random& random) {
    const Vector3d velocity = Vector3d(random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0));
    const Exact step = Exact(machine().scale()) * 1e-30;
    const auto moved = [&](double sign) {
      return exactConfiguration(exactLegs(), exact(p) + (Exact(sign) * step) * exact(velocity));
    };
    const ExactVector difference = (Exact(1.0) / (step + step)) * (moved(1.0).rho - moved(-1.0).rho);
    const Vector3d joints(difference[0].value(), difference[1].value(), difference[2].value());
    const auto matrices = jacobians(machine(), p);
    ASSERT_TRUE(matrices);
    const double serial = serialMeasure(there);
    const double tolerance = 40.0 * ulp(p) / (serial * serial);
    ASSERT_LE((matrices->a * velocity - matrices->b.cwiseProduct(joints)).norm(), tolerance) << "A pdot = B rhodot";
    ASSERT_LE((matrices->j_inverse * velocity - joints).norm(), tolerance / (serial * machine().scale()))
        << "J^-1 pdot";
  });
}

TEST_P(MachineLaws, matricesBelongTogether)
{
  forEachRegularPoint([this](const Vector3d& p, const ExactConfiguration&, Random&) {
    const auto matrices = jacobians(machine(), p);
    ASSERT_TRUE(matrices);
    const Matrix3d inverse = matrices->b.cwiseInverse().asDiagonal() * matrices->a;
    ASSERT_LE((matrices->j_inverse - inverse).norm(), 8.0 * EPSILON * inverse.norm());
    const double condition = matrices->j.norm() * matrices->j_inverse.norm();
    ASSERT_LE((matrices->j * matrices->j_inverse - Matrix3d::Identity()).norm(), 100.0 * EPSILON * condition);
  });
}

TEST_P(MachineLaws, transmissionFactorsAreRootsOfTheEigenvaluesOfThePaper)
{
  forEachRegularPoint([this](const Vector3d& p, const ExactConfiguration&, Random&) {
    const auto matrices = jacobians(machine(), p);
    const Vector3d psi = transmissionFactors(*matrices);
    ASSERT_TRUE(0.0 < psi[0] && psi[0] <= psi[1] && psi[1] <= psi[2]) << psi.transpose();
    const Matrix3d square = (matrices->j * matrices->j.transpose()).inverse();  // (J J^T)^-1, paper, section 2.1.1
    const Vector3d sigma = Eigen::SelfAdjointEigenSolver<Matrix3d>(square).eigenvalues();
    const double condition = (psi[2] / psi[0]) * (psi[2] / psi[0]);
    for (int k = 0; k < 3; ++k)
      ASSERT_NEAR(psi[k] * psi[k], sigma[k], 100.0 * EPSILON * condition * sigma[2]);
    ASSERT_NEAR(psi.prod(), std::abs(matrices->a.determinant() / matrices->b.prod()),
                20.0 * EPSILON * psi[2] * psi[2] * psi[2]);
  });
}

TEST_P(MachineLaws, transmissionFactorsBoundWhatAUnitVelocityAsksOfTheJoints)
{
  forEachRegularPoint([this](const Vector3d& p, const ExactConfiguration&, Random& random) {
    const auto matrices = jacobians(machine(), p);
    const Vector3d psi = transmissionFactors(*matrices);
    for (int i = 0; i < 20; ++i)
    {
      const Vector3d direction(random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0));
      const double rate = (matrices->j_inverse * direction.normalized()).norm();
      ASSERT_GE(rate, psi[0] - 20.0 * EPSILON * psi[2]);
      ASSERT_LE(rate, psi[2] + 20.0 * EPSILON * psi[2]);
    }
  });
}

TEST_P(MachineLaws, singularityMeasuresAreThoseOfTheExactConfiguration)
{
  forEachRegularPoint([this](const Vector3d& p, const ExactConfiguration& there, Random&) {
    const SingularityMeasures got = singularityMeasures(*jacobians(machine(), p));
    const double tolerance = 40.0 * ulp(p) / (machine().scale() * serialMeasure(there));
    ASSERT_NEAR(got.serial, serialMeasure(there), tolerance);
    ASSERT_NEAR(got.parallel, parallelMeasure(there), tolerance);
    ASSERT_LE(got.serial, 1.0 + tolerance);
    ASSERT_LE(got.parallel, 1.0 + tolerance);
  });
}
}  // namespace test
}  // namespace pkm_workspace
