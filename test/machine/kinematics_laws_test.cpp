// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "support/machine_laws.h"

namespace pkm_workspace
{
namespace test
{
using Eigen::Vector3d;

TEST_P(MachineLaws, inverseIsTheExactOneButForRounding)
{
  forEachRegularPoint([this](const Vector3d& p, const ExactConfiguration& there, Random&) {
    const auto rho = inverseKinematics(machine(), p);
    ASSERT_TRUE(rho);
    for (int i = 0; i < 3; ++i)
      ASSERT_NEAR((*rho)[i], there.rho[static_cast<std::size_t>(i)].value(), 20.0 * ulp(p) / serialMeasure(there));
  });
}

TEST_P(MachineLaws, strutsKeepTheirLengthAndTheirWorkingMode)
{
  forEachRegularPoint([this](const Vector3d& p, const ExactConfiguration& there, Random&) {
    const auto matrices = jacobians(machine(), p);
    ASSERT_TRUE(matrices);
    for (int i = 0; i < 3; ++i)
    {
      const double tolerance = 40.0 * ulp(p) / serialMeasure(there);
      ASSERT_NEAR(matrices->a.row(i).norm(), slidingStrut(machine().leg(i)).length.mid(), tolerance);
      ASSERT_GT(matrices->b[i] * slidingStrut(machine().leg(i)).working_mode, 0.0);
    }
  });
}

TEST_P(MachineLaws, forwardUndoesInverseInTheAspectOfTheMachine)
{
  int tried = 0;
  forEachRegularPoint([&](const Vector3d& p, const ExactConfiguration& there, Random&) {
    if (!isInAspect(there))
      return;
    ++tried;
    const auto back = forwardKinematics(machine(), *inverseKinematics(machine(), p));
    ASSERT_TRUE(back);
    ASSERT_LE((*back - p).norm(), 100.0 * ulp(p) / (serialMeasure(there) * parallelMeasure(there))) << toText(*back);
  });
  EXPECT_GT(tried, 0);
}

TEST_P(MachineLaws, forwardNeverLeavesTheAspectAndTheWorkingModes)
{
  forEachRegularPoint([&](const Vector3d& p, const ExactConfiguration& start, Random&) {
    const Vector3d rho = *inverseKinematics(machine(), p);
    const auto found = forwardKinematics(machine(), rho);
    if (!found)
    {
      ASSERT_FALSE(isInAspect(start));
      return;
    }
    const ExactConfiguration there = exactAt(*found);
    if (!there.isReached() || serialMeasure(there) < REGULAR || parallelMeasure(there) < REGULAR)
      return;
    ASSERT_TRUE(isInAspect(there)) << toText(*found);
    const double tolerance = 1000.0 * ulp(p) / (serialMeasure(there) * parallelMeasure(there));
    ASSERT_LE((*inverseKinematics(machine(), *found) - rho).norm(), tolerance) << toText(*found);
  });
}

TEST_P(MachineLaws, jointsOfTheZeroConfigurationLeadBackToIt)
{
  const Vector3d zero = machine().zero();
  const auto back = forwardKinematics(machine(), *inverseKinematics(machine(), zero));
  ASSERT_TRUE(back);
  EXPECT_LE((*back - zero).norm(), 1e4 * ulp(zero));
}

TEST_P(MachineLaws, jointsFarApartHaveNoAssembly)
{
  for (int i = 0; i < 3; ++i)
    for (const double sign : { -1.0, 1.0 })
    {
      Vector3d rho = *inverseKinematics(machine(), machine().zero());
      rho[i] += sign * 10.0 * machine().scale();
      EXPECT_FALSE(forwardKinematics(machine(), rho)) << toText(rho);
    }
}

INSTANTIATE_TEST_SUITE_P(All, MachineLaws, testing::ValuesIn(exactMachines()),
                         [](const auto& info) { return info.param.name; });
}  // namespace test
}  // namespace pkm_workspace
