// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/region/beyond_limits.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "pkm_workspace/dexterity/defaults.h"
#include "pkm_workspace/region/largest_region.h"
#include "support/machines.h"

namespace pkm_workspace
{
namespace
{
/// Limits -0.2 to 0.15 [m].
const Machine MACHINE = test::limited(orthoglide());

JointReaches allAt(const Interval& least, const Interval& largest)
{
  return { JointReach{ least, largest }, JointReach{ 0.0, 0.0 }, JointReach{ 0.0, 0.0 } };
}
}  // namespace

TEST(BeyondLimits, saysOnlyWhatIsProved)
{
  EXPECT_TRUE(beyondLimits(MACHINE, allAt(-0.2, 0.15)).empty());
  // it may leave both, and may leave none
  const JointReaches vague = allAt({ -0.3, -0.2 }, { 0.1, 0.3 });
  EXPECT_TRUE(beyondLimits(MACHINE, vague).empty());
  EXPECT_EQ(remarkOnLimits(MACHINE, Criterion(), vague),
            "Joint limits are off: whether all rails stay within their limits is not proved.");
  EXPECT_EQ(remarkOnLimits(MACHINE, Criterion(), allAt(-0.2, 0.15)),
            "Joint limits are off: all rails stay within their limits.");
}

TEST(BeyondLimits, namesRailLimitAndHowFar)
{
  const JointReaches reaches = allAt({ -0.75, -0.7 }, { 0.4, 0.6 });
  const auto found = beyondLimits(MACHINE, reaches);
  ASSERT_EQ(found.size(), 2U);
  EXPECT_FALSE(found[0].is_upper);
  EXPECT_NEAR(found[0].by.lower(), 0.5, 1e-12);
  EXPECT_NEAR(found[0].by.upper(), 0.55, 1e-12);
  EXPECT_TRUE(found[1].is_upper);
  EXPECT_NEAR(found[1].by.lower(), 0.25, 1e-12);
  EXPECT_NEAR(found[1].by.upper(), 0.45, 1e-12);
  const std::string remark = remarkOnLimits(MACHINE, Criterion(), reaches);
  EXPECT_NE(remark.find("'rail_x' would leave its lower limit, -0.2 m, by at least 0.4"), std::string::npos) << remark;
  EXPECT_NE(remark.find("'rail_x' would leave its upper limit, 0.15 m, by at least 0.2"), std::string::npos) << remark;
}

TEST(BeyondLimits, hasNothingToSayWithinLimitsOrWithoutAny)
{
  const JointReaches reaches = allAt(-2.0, 2.0);
  EXPECT_EQ(remarkOnLimits(MACHINE, defaultCriterion(), reaches), "");
  EXPECT_EQ(remarkOnLimits(orthoglide(), Criterion(), reaches), "");
  EXPECT_TRUE(beyondLimits(orthoglide(), reaches).empty());
}

TEST(BeyondLimits, ofTheLargestRegionAreRightAtItsPoints)
{
  const LargestRegion region = findLargestRegion(MACHINE, RegionQuery());
  const auto found = beyondLimits(MACHINE, reachOver(region.joint_ranges));
  ASSERT_FALSE(found.empty());
  for (const BeyondLimit& beyond : found)
  {
    const Interval& limits = MACHINE.leg(beyond.leg).limits;
    double most = 0.0;
    for (int corner = 0; corner < 27; ++corner)
    {
      const Eigen::Vector3d place(corner % 3 - 1, corner / 3 % 3 - 1, corner / 9 - 1);
      const auto rho = inverseKinematics(MACHINE, region.center + 0.5 * region.size * place);
      ASSERT_TRUE(rho);
      const double value = (*rho)[beyond.leg];
      most = std::max(most, beyond.is_upper ? value - limits.upper() : limits.lower() - value);
    }
    EXPECT_LE(most, beyond.by.upper() + 1e-12);              // its points are in floating point
    EXPECT_GE(most, beyond.by.lower() - 0.1 * region.size);  // its extreme point lies between these
  }
}

TEST(BeyondLimits, alongAPathAreKnownFromItsPoints)
{
  const std::vector<PathSegment> segments = { PathSegment::line({ 0.0, 0.0, 0.0 }, { 0.25, 0.0, 0.0 }) };
  const PathResult path = checkPath(MACHINE, Criterion(), segments);
  ASSERT_TRUE(path.motion);
  PathReach reach(MACHINE);
  for (const PathSegment& segment : segments)
    reach.add(segment);
  const auto found = beyondLimits(MACHINE, reach.over(*path.motion));
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].leg, 0);
  EXPECT_TRUE(found[0].by.contains(0.25 - 0.15)) << found[0].by;
  EXPECT_GT(found[0].by.lower(), 0.0999);
}
}  // namespace pkm_workspace
