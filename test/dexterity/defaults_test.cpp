// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/dexterity/defaults.h"

#include <gtest/gtest.h>

#include "pkm_workspace/machine/catalogue.h"

namespace pkm_workspace
{
TEST(Defaults, scaleWithTheMachine)
{
  EXPECT_EQ(defaultAccuracy(orthoglide()), 0.001);
  EXPECT_EQ(defaultAccuracy(orthoglide(1000.0)), 1.0);
  EXPECT_EQ(defaultAccuracy(orthoglide(0.31058)), 0.0003);
  EXPECT_EQ(defaultAccuracy(orthoglide(0.07)), 0.00007);
  EXPECT_EQ(defaultAccuracy(orthoglide(0.098)), 0.0001);
  EXPECT_EQ(defaultAccuracy(orthoglide(2.4e6)), 2000.0);
  const Box box{ { 0.0, 0.0, 0.0 }, { 1.0, 1.0, 1.0 } };
  const Box flat{ { 0.0, 0.0, 0.0 }, { 1.0, 1.0, 0.0 } };
  EXPECT_EQ(defaultResolution(orthoglide(), box), 0.05);
  EXPECT_EQ(defaultResolution(orthoglide(), flat), 0.025);
  EXPECT_DOUBLE_EQ(defaultResolution(orthoglide(0.1), box), 0.005);
}

TEST(Defaults, areWithinJointLimits)
{
  Criterion wanted;
  wanted.joint_limits = true;
  EXPECT_EQ(defaultCriterion(), wanted);
}
}  // namespace pkm_workspace
