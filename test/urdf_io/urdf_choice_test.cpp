// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "pkm_workspace/machine/catalogue.h"
#include "pkm_workspace/urdf_io/urdf_reader.h"
#include "pkm_workspace/urdf_io/urdf_writer.h"
#include "urdf_io/expect_machine.h"
#include "urdf_io/urdf_edit.h"

namespace pkm_workspace
{
namespace test
{
namespace
{
/// The Orthoglide with tool tips 0.25 below its tcp links, and a fourth prismatic joint.
std::string rich()
{
  std::string urdf = writeUrdf(orthoglide());
  for (const std::string n : { "1", "2", "3" })
    urdf = withElements(urdf, branch("tip_of_tool_" + n, "fixed", "tcp_" + n, "<origin xyz=\"0 0 -0.25\"/>"));
  return withElements(urdf,
                      branch("lift", "prismatic", "base_link",
                             "<axis xyz=\"0 0 1\"/><limit lower=\"0\" upper=\"1\" effort=\"1\" velocity=\"1\"/>"));
}

using Links = std::array<std::string, 3>;
}  // namespace

TEST(UrdfChoice, theDeepestTripleCounts)
{
  const UrdfMachine read = readUrdf(rich(), { { "rail_x", "rail_y", "rail_z" }, {} });
  EXPECT_EQ(read.tcp_links, (Links{ "tip_of_tool_1", "tip_of_tool_2", "tip_of_tool_3" }));
  EXPECT_EQ(read.machine.zero(), Eigen::Vector3d(0.0, 0.0, -0.25));
  EXPECT_EQ(slidingStrut(read.machine.leg(0)).platform, (IntervalVector{ 0.0, 0.0, 0.25 }));
}

TEST(UrdfChoice, linksThatCoincideOnOneLegOnlyDoNotDeepenATriple)
{
  auto urdf = withElements(writeUrdf(orthoglide()), branch("plate", "fixed", "tcp_2"));
  urdf = withElements(urdf, branch("flange", "fixed", "plate"));
  EXPECT_EQ(readUrdf(urdf).tcp_links, (Links{ "tcp_1", "tcp_2", "tcp_3" }));
}

TEST(UrdfChoice, legsMayDifferInDepth)
{
  auto urdf = withJoint(writeUrdf(orthoglide()), "tcp_joint_3", "<child link=\"tcp_3\"/>", "<child link=\"adapter\"/>");
  urdf = withElements(urdf,
                      "<link name=\"adapter\"/><joint name=\"adapter\" type=\"fixed\"><parent link=\"adapter\"/>"
                      "<child link=\"tcp_3\"/><origin xyz=\"0.5 0 0\"/></joint>");
  urdf = withJoint(urdf, "tcp_joint_3", "xyz=\"0 0 0\"", "xyz=\"-0.5 0 0\"");
  const UrdfMachine read = readUrdf(urdf);
  EXPECT_EQ(read.tcp_links, (Links{ "tcp_1", "tcp_2", "tcp_3" }));
  expectSameGeometry(read.machine, orthoglide());
}

TEST(UrdfChoice, namesSettleIt)
{
  const UrdfMachine read = readUrdf(rich(), { { "rail_z", "rail_x", "rail_y" }, { "tcp_2", "tip_3", "tcp_1" } });
  EXPECT_EQ(read.tcp_links, (Links{ "tip_3", "tcp_1", "tcp_2" }));
  EXPECT_EQ(read.machine.leg(0).joint, "rail_z");
  EXPECT_EQ(slidingStrut(read.machine.leg(1)).axis, (IntervalVector{ 1.0, 0.0, 0.0 }));
  EXPECT_EQ(read.machine.zero(), Eigen::Vector3d::Zero());
}

TEST(UrdfChoice, legsStandInTheOrderOfTheFile)
{
  std::string urdf = writeUrdf(orthoglide());
  urdf = replaced(urdf, "<joint name=\"rail_x\"", "<joint name=\"zz\"");
  EXPECT_EQ(readUrdf(urdf).machine.leg(0).joint, "zz");
}
}  // namespace test
}  // namespace pkm_workspace
