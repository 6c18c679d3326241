// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "pkm_workspace/urdf_io/urdf_reader.h"
#include "support/expect_throw.h"
#include "urdf_io/expect_refused.h"
#include "urdf_io/urdf_edit.h"

namespace pkm_workspace
{
namespace test
{
namespace
{
using Sentences = std::vector<std::string>;

std::string fileOf(const std::string& name)
{
  return PKM_WORKSPACE_SOURCE_DIR "/test/data/" + name;
}
}  // namespace

TEST(UrdfRemedies, limitsThatLeaveNoWay)
{
  const std::string remedy =
      "; many exporters write 0 0 where no limits were set. Nothing can move within these joint limits: write the real "
      "ones into the URDF, or leave joint limits out of the question";
  const UrdfMachine read = readUrdfFile(fileOf("zero_limits.urdf"));
  EXPECT_EQ(read.machine.leg(0).limits, Interval(0.0));
  EXPECT_EQ(read.warnings, (Sentences{ "rails cannot move, their <limit> has lower = upper" + remedy +
                                       ": 0 m ('tower_1', 'tower_2', 'tower_3')" }));
  const std::string one = withJoint(good(), "rail_y", "lower=\"-1.3\" upper=\"2.3\"", "lower=\"0.5\" upper=\"0.5\"");
  EXPECT_EQ(readUrdf(one).warnings,
            (Sentences{ "rail 'rail_y' cannot move, its <limit> has lower = upper = 0.5 m" + remedy }));
}

TEST(UrdfRemedies, lengthsInMillimetres)
{
  const Sentences warnings = readUrdfFile(fileOf("millimetres.urdf")).warnings;
  EXPECT_EQ(warnings,
            (Sentences{ "the struts are very long: is the URDF in millimetres? Its lengths are metres; if it is, "
                        "multiply those of all origins, limits and shapes by 0.001: 218 m ('tower_1', 'tower_2', "
                        "'tower_3')" }));
  EXPECT_TRUE(readUrdf(writeUrdf(orthoglide(20.0))).warnings.empty());
  EXPECT_EQ(readUrdf(writeUrdf(orthoglide(20.1))).warnings.size(), 1U);
}

TEST(UrdfRemedies, xacroThatWasNotRun)
{
  expectThrow<std::invalid_argument>([] { readUrdfFile(fileOf("delta.urdf.xacro")); },
                                     "line 3: <xacro:property> is xacro, .*run 'xacro FILE > machine.urdf'");
  const std::string includes = replaced(good(), "</robot>", "<xacro:include filename=\"legs.xacro\"/></robot>");
  expectRefused(includes, "<xacro:include> is xacro");
  // what xacro has written has its namespace left
  const std::string done = replaced(good(), "<robot ", "<robot xmlns:xacro=\"http://www.ros.org/wiki/xacro\" ");
  EXPECT_TRUE(readUrdf(done).warnings.empty());
}

TEST(UrdfRemedies, oneSentenceForEachKind)
{
  EXPECT_EQ(readUrdfFile(fileOf("passive_limits.urdf")).warnings,
            (Sentences{ "the limits of passive joints hold only where hinge limits are asked for: [-0.35, 0.35] rad "
                        "('u1_1', 'u2_1', 'v2_1', 'v1_1', "
                        "'u1_2', 'u2_2', 'v2_2', 'v1_2', 'u1_3', 'u2_3', 'v2_3', 'v1_3')" }));
  std::string urdf = good();
  for (const char* const joint : { "rail_x", "rail_z" })
    urdf = withJoint(urdf, joint, "<axis", "<orign xyz=\"1 2 3\"/><axis");
  EXPECT_EQ(readUrdf(urdf).warnings,
            (Sentences{ "<orign> is not an element of a joint and not used: 'rail_x', 'rail_z'" }));
}
}  // namespace test
}  // namespace pkm_workspace
