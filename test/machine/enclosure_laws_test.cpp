// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "support/machine_laws.h"
#include "support/rounding_mode.h"

namespace pkm_workspace
{
namespace test
{
using Eigen::Vector3d;

/// Whether the enclosures may hold what the oracle has; the text says what they lack.
testing::AssertionResult holds(const Configuration& got, const ExactConfiguration& there)
{
  for (std::size_t i = 0; i < 3; ++i)
  {
    if (!there.rho[i].mayLieIn(got.rho[i]))
      return testing::AssertionFailure() << "rho " << i << " " << got.rho[i] << " lacks " << there.rho[i];
    if (!there.eta[i].mayLieIn(got.eta[i]))
      return testing::AssertionFailure() << "eta " << i << " " << got.eta[i] << " lacks " << there.eta[i];
    for (std::size_t k = 0; k < 3; ++k)
      if (!there.strut[i][k].mayLieIn(got.strut[i][k]))
        return testing::AssertionFailure() << "strut " << i << " " << got.strut[i][k] << " lacks " << there.strut[i][k];
  }
  if (!there.det_a.mayLieIn(got.det_a))
    return testing::AssertionFailure() << "det A " << got.det_a << " lacks " << there.det_a;
  return testing::AssertionSuccess();
}

TEST_P(MachineLaws, enclosuresOfTheGeometryHoldTheExactNumbers)
{
  for (int i = 0; i < 3; ++i)
  {
    const auto& leg = exactLegs()[static_cast<std::size_t>(i)];
    EXPECT_TRUE(leg.length.mayLieIn(slidingStrut(machine().leg(i)).length));
    for (std::size_t k = 0; k < 3; ++k)
    {
      EXPECT_TRUE(leg.axis[k].mayLieIn(slidingStrut(machine().leg(i)).axis[k]));
      EXPECT_TRUE((leg.origin[k] - leg.platform[k]).mayLieIn(machine().center(i)[k]));
      for (std::size_t m = 0; m < 3; ++m)
        EXPECT_TRUE((Exact(k == m ? 1.0 : 0.0) - leg.axis[k] * leg.axis[m])
                        .mayLieIn(std::get<EnclosedStrut>(machine().enclosed(i)).projector[k][m]));
    }
  }
}

TEST_P(MachineLaws, configurationHoldsTheExactOneInEveryRoundingMode)
{
  forEachRegularPoint([this](const Vector3d& p, const ExactConfiguration& there, Random&) {
    for (const auto& mode : MODES)
    {
      const auto got = under<std::optional<Configuration>>(mode, [&] { return configurationAt(machine(), p); });
      ASSERT_TRUE(got) << mode;
      ASSERT_TRUE(holds(*got, there)) << mode;
    }
  });
}

TEST_P(MachineLaws, configurationOverABoxHoldsThatOfEveryPoint)
{
  forEachRegularPoint([this](const Vector3d& p, const ExactConfiguration&, Random& random) {
    const double half = machine().scale() * std::ldexp(1.0, -random.integer(3, 40));
    const Box box{ p - Vector3d::Constant(half), p + Vector3d(half, 0.0, half) };
    const auto got = configurationAt(machine(), enclose(box));
    for (int i = 0; i < 8; ++i)
    {
      Vector3d inside;
      for (int k = 0; k < 3; ++k)
        inside[k] = random.once(3) ? random.uniform(box.lower[k], box.upper[k])
                                   : (random.once(2) ? box.lower[k] : box.upper[k]);
      const ExactConfiguration there = exactAt(inside);
      ASSERT_TRUE(there.isReached() || !got) << toText(inside) << " is out of reach, the box is not";
      ASSERT_TRUE(!got || holds(*got, there)) << toText(inside);
    }
  });
}

TEST_P(MachineLaws, pointsOutOfReachHaveNoConfiguration)
{
  int reached = 0;
  int lost = 0;
  for (int seed = 0; seed < cases(1000); ++seed)
  {
    Random random(static_cast<std::uint64_t>(seed));
    const Vector3d p = anyPoint(random);
    const ExactConfiguration there = exactAt(p);
    const bool certified = configurationAt(machine(), p).has_value();
    ASSERT_LE(certified, there.isReached()) << toText(p) << " seed " << seed;
    ASSERT_EQ(inverseKinematics(machine(), p).has_value(), there.isReached()) << toText(p) << " seed " << seed;
    reached += there.isReached();
    lost += there.isReached() && !certified;
  }
  EXPECT_GT(reached, cases(10));
  EXPECT_LT(reached, cases(1000));
  EXPECT_EQ(lost, 0) << "points within an ulp of the limit are this rare";
}

TEST_P(MachineLaws, configurationIsSharp)
{
  forEachRegularPoint([this](const Vector3d& p, const ExactConfiguration& there, Random&) {
    const auto got = configurationAt(machine(), p);
    ASSERT_TRUE(got);
    for (std::size_t i = 0; i < 3; ++i)
      ASSERT_LE(got->rho[i].width(), 40.0 * ulp(p) / serialMeasure(there));
  });
}

TEST_P(MachineLaws, theZeroConfigurationStandsInTheAspectOfTheMachine)
{
  const ExactConfiguration there = exactAt(machine().zero());
  ASSERT_TRUE(there.isReached());
  EXPECT_TRUE(machine().aspect() > 0 ? there.det_a.certainlyPositive() : there.det_a.certainlyNegative());
}
}  // namespace test
}  // namespace pkm_workspace
