// SPDX-License-Identifier: BSD-3-Clause
// The mechanism of a machine with one leg of each kind in tf, closed live.
#include "mechanism.h"
#include "pkm_workspace/machine/catalogue.h"

namespace pkm_workspace
{
namespace test
{
TEST_F(Mechanism, ofMixedLegsFollowsPosesAndStaysClosed)
{
  for (const Eigen::Vector3d& p : { Eigen::Vector3d(0.1, -0.2, 0.05), Eigen::Vector3d(-0.3, 0.15, 0.2) })
  {
    publishPose(p);
    EXPECT_LE(gapOnceAt(p), 1e-9);
  }
}

TEST_F(Mechanism, ofMixedLegsFollowsItsJoints)
{
  const Eigen::Vector3d p(0.2, 0.1, -0.15);
  const auto joints = inverseKinematics(mixedLegs(), p);
  ASSERT_TRUE(joints);
  publishRails(mixedLegs(), *joints);
  EXPECT_LE(gapOnceAt(p), 1e-9);
}

TEST_F(Mechanism, ofMixedLegsFollowsTheHandle)
{
  const Eigen::Vector3d p(0.1, 0.05, -0.1);
  drag("tool", p);
  EXPECT_LE(gapOnceAt(p), 1e-9);
}
}  // namespace test
}  // namespace pkm_workspace
