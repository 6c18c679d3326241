// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/urdf_io/urdf_reader.h"
#include "expect_refused.h"

#include <gtest/gtest.h>

#include "pkm_workspace/machine/catalogue.h"
#include "pkm_workspace/urdf_io/urdf_writer.h"
#include "urdf_io/expect_machine.h"
#include "urdf_io/expect_refused.h"
#include "urdf_io/urdf_edit.h"

namespace pkm_workspace
{
namespace test
{
namespace
{
const Machine& unit()
{
  static const Machine machine = orthoglide();
  return machine;
}

IntervalVector vector(double x, double y, double z)
{
  return { x, y, z };
}
}  // namespace

TEST(UrdfReader, tellsNamesAndLinks)
{
  const UrdfMachine urdf = readUrdf(good());
  EXPECT_EQ(urdf.machine.name(), "orthoglide");
  EXPECT_EQ(urdf.root_link, "base_link");
  EXPECT_EQ(urdf.machine.leg(1).joint, "rail_y");
  EXPECT_EQ(urdf.slider_links[1], "slider_2");
  EXPECT_EQ(urdf.tcp_links[1], "tcp_2");
  EXPECT_EQ(urdf.machine.leg(1).limits, Interval(-1.3, 2.3));
}

TEST(UrdfReader, takesWhatTheMotorsCanDo)
{
  const Leg& whole = unit().leg(0);
  EXPECT_EQ(whole.speed, INF);
  const auto urdf = withJoint(good(), "rail_y", "effort=\"0\" velocity=\"0\"", "effort=\"250\" velocity=\"0.75\"");
  EXPECT_EQ(readUrdf(urdf).machine.leg(0).speed, INF);
  EXPECT_EQ(readUrdf(urdf).machine.leg(0).effort, INF);
  EXPECT_EQ(readUrdf(urdf).machine.leg(1).speed, 0.75);
  EXPECT_EQ(readUrdf(urdf).machine.leg(1).effort, 250.0);
  EXPECT_EQ(readUrdf(good()).machine.geometryHash(), readUrdf(urdf).machine.geometryHash());
}

TEST(UrdfReader, takesAxesOfAnyLength)
{
  for (const char* const axis : { "5 0 0", "0.1 0 0", "1e-300 0 0", "1e300 0 0", "4e-324 0 0" })
  {
    const auto urdf = withJoint(good(), "rail_x", "axis xyz=\"1 0 0\"", "axis xyz=\"" + std::string(axis) + "\"");
    expectSameGeometry(readUrdf(urdf).machine, unit());
  }
}

TEST(UrdfReader, enclosesAxesThatAreNoDoubles)
{
  const auto urdf = withJoint(good(), "rail_x", "axis xyz=\"1 0 0\"", "axis xyz=\"3e200 4e200 0\"");
  const IntervalVector axis = slidingStrut(readUrdf(urdf).machine.leg(0)).axis;
  // 3/5 and 4/5 lie between these neighbours.
  EXPECT_TRUE(Interval(0.6, 0.6000000000000001).intersects(axis[0]));
  EXPECT_TRUE(Interval(0.8, 0.8000000000000002).intersects(axis[1]));
  EXPECT_EQ(axis[2], Interval(0.0));
  EXPECT_LE(axis[0].width(), 1e-15);
}

TEST(UrdfReader, readsRailsThatExcludeZero)
{
  const auto urdf = withJoint(good(), "rail_x", "lower=\"-1.3\"", "lower=\"0.5\"");
  const Machine machine = readUrdf(urdf).machine;
  EXPECT_EQ(machine.leg(0).limits, Interval(0.5, 2.3));
  EXPECT_EQ(machine.zero(), Eigen::Vector3d::Zero());
}

TEST(UrdfReader, readsFlippedWrists)
{
  auto urdf = withJoint(good(), "revolute_back_1", "xyz=\"0 1 0\"", "xyz=\"0 -7 0\"");
  urdf = withJoint(urdf, "revolute_back_1", "multiplier=\"-1\"", "multiplier=\"1\"");
  urdf = withJoint(urdf, "parallelogram_back_3", "xyz=\"0 1 0\"", "xyz=\"0 -1 0\"");
  urdf = withJoint(urdf, "parallelogram_back_3", " multiplier=\"-1\"", "");
  expectSameGeometry(readUrdf(urdf).machine, unit());
}

TEST(UrdfReader, readsStrutsThatFollowTheirWristsOrBars)
{
  // The wrist leads: revolute_back_1 is free, revolute_1 follows it.
  auto urdf = withJoint(good(), "revolute_back_1", "<mimic joint=\"revolute_1\" multiplier=\"-1\"/>", "");
  urdf = withJoint(urdf, "revolute_1", "<axis", "<mimic joint=\"revolute_back_1\" multiplier=\"-1\"/><axis");
  expectSameGeometry(readUrdf(urdf).machine, unit());
  // A bar leads, by a gear of 1 : 2, and the wrist follows the strut.
  urdf = withJoint(good(), "bar_joint_a_1", "<mimic joint=\"parallelogram_1\" multiplier=\"1\"/>", "");
  urdf = withJoint(urdf, "parallelogram_1", "<axis", "<mimic joint=\"bar_joint_a_1\" multiplier=\"2\"/><axis");
  expectSameGeometry(readUrdf(urdf).machine, unit());
}

TEST(UrdfReader, ignoresSideBranches)
{
  auto urdf = withElements(good(), branch("camera", "fixed", "base_link", "<origin xyz=\"1 2 3\" rpy=\"1 2 3\"/>"));
  urdf =
      withElements(urdf, branch("pan", "revolute", "tip_1",
                                "<axis xyz=\"0 0 1\"/><limit lower=\"-1\" upper=\"1\" effort=\"1\" velocity=\"1\"/>"));
  urdf = withElements(urdf, branch("lens", "fixed", "pan"));
  urdf = withElements(urdf, branch("cable", "floating", "slider_2"));
  urdf = withElements(urdf, branch("spindle", "continuous", "tcp_1", "<axis xyz=\"1 1 1\"/>"));
  const UrdfMachine read = readUrdf(urdf);
  expectSameGeometry(read.machine, unit());
  EXPECT_EQ(read.tcp_links[0], "tcp_1");
  EXPECT_TRUE(read.warnings.empty()) << read.warnings.front();
}

TEST(UrdfReader, findsWhereAxesMeetThatAreHingedApart)
{
  // The second axis, along z, meets the first, along y, 0.25 above the slider; the wrist mirrors it.
  auto urdf = withJoint(good(), "parallelogram_1", "xyz=\"0 0 0\"", "xyz=\"0 0.25 0.5\"");
  urdf = withJoint(urdf, "parallelogram_back_1", "xyz=\"1 0 0\"", "xyz=\"1 0 -0.5\"");
  urdf = withJoint(urdf, "revolute_back_1", "xyz=\"0 0 0\"", "xyz=\"0 -0.25 0\"");
  const UrdfMachine read = readUrdf(urdf);
  EXPECT_EQ(slidingStrut(read.machine.leg(0)).origin, vector(-1.0, 0.25, 0.0));
  EXPECT_EQ(slidingStrut(read.machine.leg(0)).platform, vector(0.0, 0.25, 0.0));
  EXPECT_EQ(slidingStrut(read.machine.leg(0)).length, Interval(1.0));
  EXPECT_EQ(read.machine.center(0), unit().center(0));
  EXPECT_TRUE(read.warnings.empty());
}

TEST(UrdfReader, readsSphericalJoints)
{
  // A third axis, along the strut, at both of its ends.
  auto urdf = withJoint(good(), "parallelogram_back_1", "<parent link=\"strut_1\"/>", "<parent link=\"spun\"/>");
  urdf = withJoint(urdf, "parallelogram_back_1", "xyz=\"1 0 0\"", "xyz=\"0 0 0\"");
  urdf = withElements(urdf, branch("spin", "continuous", "strut_1", "<axis xyz=\"1 0 0\"/>"));
  urdf = withElements(urdf, branch("spun", "continuous", "spin",
                                   "<origin xyz=\"1 0 0\"/><axis xyz=\"1 0 0\"/>"
                                   "<mimic joint=\"spin\" multiplier=\"-1\"/>"));
  const UrdfMachine read = readUrdf(urdf);
  expectSameGeometry(read.machine, unit());
  EXPECT_EQ(read.hinges[0].joints[0], "revolute_1");
  EXPECT_EQ(read.hinges[0].joints[1], "parallelogram_1");
  EXPECT_TRUE(read.warnings.empty());
}

TEST(UrdfReader, growsTheMachineWhereAxesMeetOnlyNearly)
{
  auto urdf = withJoint(good(), "parallelogram_1", "xyz=\"0 0 0\"", "xyz=\"1e-6 0 0\"");
  urdf = withJoint(urdf, "parallelogram_back_1", "xyz=\"1 0 0\"", "xyz=\"0.999999 0 0\"");
  const UrdfMachine read = readUrdf(urdf);
  const Leg& leg = read.machine.leg(0);
  for (const double x : { -1.0, -0.999999 })
    EXPECT_TRUE(slidingStrut(leg).origin[0].contains(x));
  for (const double length : { 1.0, 0.999999 })
    EXPECT_TRUE(slidingStrut(leg).length.contains(length));
  EXPECT_LE(slidingStrut(leg).length.width(), 1e-5);
  ASSERT_EQ(read.warnings.size(), 1u);
  EXPECT_NE(read.warnings[0].find("leg of rail 'rail_x': the axes of passive joints meet only to 1e-06 m"),
            std::string::npos)
      << read.warnings[0];
}

TEST(UrdfReader, growsTheMachineWhereAWristUndoesOnlyNearly)
{
  auto urdf = withJoint(good(), "tcp_joint_1", "xyz=\"0 0 0\"", "xyz=\"0 0 -0.5\"");
  urdf = withJoint(urdf, "parallelogram_back_1", "xyz=\"1 0 0\"", "xyz=\"1 0 0\" rpy=\"0 0 0\"");
  urdf = withJoint(urdf, "rail_x", "xyz=\"-1 0 0\"", "xyz=\"-1 0 0.5\"");
  EXPECT_EQ(slidingStrut(readUrdf(urdf).machine.leg(0)).platform, vector(0.0, 0.0, 0.5));
  urdf = withJoint(urdf, "revolute_back_1", "axis xyz=\"0 1 0\"", "axis xyz=\"0 1 1e-6\"");
  const UrdfMachine read = readUrdf(urdf);
  // The platform may turn by 2e-6 rad at most: b moves by 1e-6 m.
  const IntervalVector& b = slidingStrut(read.machine.leg(0)).platform;
  EXPECT_TRUE(Interval(-1e-6, 1e-6).isSubsetOf(b[0]));
  EXPECT_TRUE(b[0].isSubsetOf(Interval(-1.1e-6, 1.1e-6)));
  ASSERT_EQ(read.warnings.size(), 1u);
  EXPECT_NE(read.warnings[0].find("the wrist may turn the platform by up to 2e-06 rad"), std::string::npos)
      << read.warnings[0];
}

TEST(UrdfReader, readsPlatformLinksThatAreTurned)
{
  const auto urdf = withJoint(good(), "tcp_joint_2", "xyz=\"0 0 0\"", "xyz=\"0 0 0\" rpy=\"0.1 0.2 0.3\"");
  expectSameGeometry(readUrdf(urdf).machine, unit());
}

TEST(UrdfReader, readsQuarterTurnsOfFourDecimals)
{
  // Leg 2 as a copy of leg 1, turned by 1.5708 rad: all within the tolerances, its exact numbers taken as they are.
  auto urdf = withJoint(good(), "rail_y", "xyz=\"0 -1 0\"", "xyz=\"0 -1 0\" rpy=\"0 0 1.5708\"");
  urdf = withJoint(urdf, "rail_y", "axis xyz=\"0 1 0\"", "axis xyz=\"1 0 0\"");
  for (const char* const end : { "", "_back" })
  {
    urdf = withJoint(urdf, "revolute" + std::string(end) + "_2", "axis xyz=\"0 0 1\"", "axis xyz=\"0 1 0\"");
    urdf = withJoint(urdf, "parallelogram" + std::string(end) + "_2", "axis xyz=\"1 0 0\"", "axis xyz=\"0 0 1\"");
  }
  urdf = withJoint(urdf, "parallelogram_back_2", "origin xyz=\"0 1 0\"", "origin xyz=\"1 0 0\"");
  const UrdfMachine read = readUrdf(urdf);
  EXPECT_TRUE(read.warnings.empty());
  EXPECT_EQ(slidingStrut(read.machine.leg(1)).length, Interval(1.0));
  EXPECT_NEAR(slidingStrut(read.machine.leg(1)).axis[0].mid(), -3.67e-6, 1e-8);
  EXPECT_LE(slidingStrut(read.machine.leg(1)).axis[0].width(), 1e-20);
}

TEST(UrdfReader, warnsOfWhatIsNotUsed)
{
  auto urdf = withJoint(good(), "revolute_1", "type=\"continuous\">",
                        "type=\"revolute\"><limit lower=\"-0.5\" upper=\"0.75\" effort=\"1\" velocity=\"1\"/>");
  urdf = withJoint(urdf, "revolute_back_2", "type=\"continuous\">",
                   "type=\"revolute\"><limit lower=\"-1\" upper=\"1\" effort=\"1\" velocity=\"1\"/>");
  urdf = withJoint(urdf, "rail_z", "<axis",
                   "<safety_controller soft_lower_limit=\"-0.1\" soft_upper_limit=\"0.2\" k_velocity=\"1\"/><axis");
  urdf = withJoint(urdf, "rail_y", "<axis", "<orign xyz=\"1 2 3\"/><axis");
  urdf = withJoint(urdf, "rail_y", "<origin", "<origin ryp=\"0 0 1\"");
  const UrdfMachine read = readUrdf(urdf);
  expectSameGeometry(read.machine, unit());
  EXPECT_EQ(read.warnings,
            (std::vector<std::string>{
                "joint 'rail_y': <origin ryp> is not an attribute of it and not used",
                "joint 'rail_y': <orign> is not an element of a joint and not used",
                "the limits of passive joints hold only where hinge limits are asked for: [-0.5, 0.75] rad "
                "('revolute_1'), [-1, 1] rad "
                "('revolute_back_2')",
                "joint 'rail_z': the soft limits [-0.1, 0.2] m of its <safety_controller> are not used" }));
}

TEST(UrdfReader, warnsOfPassiveJointsThatDoNotReachEveryDirection)
{
  auto urdf = withJoint(good(), "parallelogram_1", "xyz=\"0 0 1\"", "xyz=\"0.2 0 1\"");
  urdf = withJoint(urdf, "parallelogram_back_1", "xyz=\"0 0 1\"", "xyz=\"0.2 0 1\"");
  const UrdfMachine read = readUrdf(urdf);
  ASSERT_EQ(read.warnings.size(), 1u);
  EXPECT_NE(read.warnings[0].find("'revolute_1' and 'parallelogram_1' cannot turn the strut in every direction"),
            std::string::npos)
      << read.warnings[0];
}
}  // namespace test
}  // namespace pkm_workspace
