// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "pkm_workspace/common/whole_file.h"
#include "pkm_workspace/machine/catalogue.h"
#include "pkm_workspace/urdf_io/urdf_reader.h"
#include "support/expect_throw.h"
#include "urdf_io/urdf_edit.h"

namespace pkm_workspace
{
namespace test
{
namespace
{
std::string urdfOf(const std::string& name)
{
  return readWholeFile(PKM_WORKSPACE_SOURCE_DIR "/urdf/" + name + ".urdf", 1000000);
}

void expectNear(const IntervalVector& a, const IntervalVector& b)
{
  for (std::size_t k = 0; k < 3; ++k)
  {
    EXPECT_NEAR(a[k].mid(), b[k].mid(), 1e-11);
    EXPECT_LE(a[k].width(), 1e-12);
  }
}

void expectLegRefused(const std::string& xml, const std::string& pattern)
{
  expectThrow<std::invalid_argument>([&] { readUrdf(xml); }, pattern);
}
}  // namespace

TEST(LegForms, aDeltaIsReadAsItsNumbersHaveIt)
{
  const Machine read = readUrdf(urdfOf("delta")).machine;
  const Machine made = delta();
  for (int i = 0; i < 3; ++i)
  {
    const Crank& crank = std::get<Crank>(read.leg(i).kind);
    const Crank& expected = std::get<Crank>(made.leg(i).kind);
    expectNear(crank.pivot, expected.pivot);
    expectNear(crank.along, expected.along);
    expectNear(crank.across, expected.across);
    expectNear(crank.platform, expected.platform);
    EXPECT_NEAR(crank.radius.mid(), 0.524, 1e-14);
    EXPECT_NEAR(crank.length.mid(), 1.244, 1e-11);
    EXPECT_EQ(crank.working_mode, 1);
    EXPECT_EQ(crank.reference, 0.45) << "the middle of its limits";
    EXPECT_EQ(read.leg(i).limits, Interval(-0.6, 1.5));
    EXPECT_EQ(read.leg(i).speed, 10.0);
    EXPECT_EQ(read.leg(i).effort, 200.0);
  }
  EXPECT_LE((read.zero() - made.zero()).norm(), 1e-11);
}

TEST(LegForms, aTripodIsReadAsItsNumbersHaveIt)
{
  const Machine read = readUrdf(urdfOf("tripod")).machine;
  const Machine made = tripod();
  for (int i = 0; i < 3; ++i)
  {
    const auto& strut = std::get<TelescopicStrut>(read.leg(i).kind);
    const auto& expected = std::get<TelescopicStrut>(made.leg(i).kind);
    expectNear(strut.foot, expected.foot);
    expectNear(strut.platform, expected.platform);
    EXPECT_NEAR(strut.length.mid(), 0.8, 1e-11);
    EXPECT_EQ(read.leg(i).limits, made.leg(i).limits);
  }
  EXPECT_LE((read.zero() - made.zero()).norm(), 1e-11);
}

TEST(LegForms, legsMayBeMixed)
{
  const Machine read = readUrdf(urdfOf("mixed_legs")).machine;
  EXPECT_TRUE(std::holds_alternative<SlidingStrut>(read.leg(0).kind));
  EXPECT_TRUE(std::holds_alternative<TelescopicStrut>(read.leg(1).kind));
  EXPECT_TRUE(std::holds_alternative<Crank>(read.leg(2).kind));
  UrdfOptions named;
  named.rails = { "crank_z", "rail_x", "strut_y" };
  EXPECT_TRUE(std::holds_alternative<Crank>(readUrdf(urdfOf("mixed_legs"), named).machine.leg(0).kind));
}

TEST(LegForms, whatIsNeitherIsRefusedWithTheJoint)
{
  const std::string crank = urdfOf("delta"), strut = urdfOf("tripod");
  expectLegRefused(withJoint(crank, "elbow_1", "multiplier=\"-1\"", "multiplier=\"-2\""),
                   "joint 'elbow_1' follows the crank 'crank_1' with multiplier -2 and offset 0, expected -1 and 0");
  expectLegRefused(withJoint(crank, "elbow_1", "axis xyz=\"0 1 0\"", "axis xyz=\"0 1 0.01\""),
                   "joint 'elbow_1' follows the crank 'crank_1' about another axis; expected one that is parallel");
  expectLegRefused(withJoint(crank, "elbow_1", "<mimic joint=\"crank_1\" multiplier=\"-1\"/>", ""),
                   "2 prismatic joints and cranks \\('crank_2', 'crank_3'\\)");
  const std::string folded = withJoint(crank, "elbow_1", "xyz=\"0.524 0 0\"", "xyz=\"0 0 0\"");
  expectLegRefused(withJoint(folded, "crank_1", "xyz=\"0.164 0 0\"", "xyz=\"0.688 0 0\""),
                   "crank 'crank_1': its elbow is .* m from its axis, expected more");
  expectLegRefused(withJoint(strut, "strut_1", "axis xyz=\"-0.4 0 ", "axis xyz=\"-0.3 0 "),
                   "joint 'strut_1' has to lengthen its strut: its axis is .* rad off the strut");
  expectLegRefused(withJoint(strut, "strut_1", "axis xyz=\"-0.4 0 ", "axis xyz=\"0.4 0 -"),
                   "joint 'strut_1' has to lengthen its strut: .* and to point to the platform");
}

TEST(LegForms, limitsOfElbowsAreNotPassedOver)
{
  const std::string limit = "<limit lower=\"-0.1\" upper=\"0.1\" velocity=\"1\" effort=\"1\"/><axis";
  const std::string free = withJoint(urdfOf("delta"), "elbow_1", "continuous", "revolute");
  const UrdfMachine read = readUrdf(withJoint(free, "elbow_1", "<axis", limit));
  EXPECT_NE(passiveJoints(read.machine.leg(0)).open_hinges.at(0).find("joint 'elbow_1' is a passive joint"),
            std::string::npos);
  EXPECT_NE(read.warnings.at(0).find("elbow_1"), std::string::npos);
}

TEST(LegForms, aCrankMayTurnAllAround)
{
  std::string text = urdfOf("delta");
  for (const char* joint : { "crank_1", "crank_2", "crank_3" })
    text = withJoint(text, joint, "revolute", "continuous");
  const UrdfMachine read = readUrdf(text);
  EXPECT_FALSE(read.machine.hasJointLimits());
  EXPECT_TRUE(read.warnings.empty()) << read.warnings.at(0);
}

TEST(LegForms, hingesThatFollowADriveAreRefused)
{
  const std::string free = urdfOf("delta");
  const std::string driven = withJoint(free, "revolute_2", "<axis", "<mimic joint=\"crank_1\"/><axis");
  expectLegRefused(driven, "joint 'revolute_2' follows 'crank_1', which drives a leg");
}

TEST(LegForms, limitsOfPassiveJointsAreRefusedByNameWhenAsked)
{
  const std::string limited =
      withJoint(withJoint(urdfOf("delta"), "revolute_2", "continuous", "revolute"), "revolute_2", "<axis",
                "<limit lower=\"-1\" upper=\"1\" velocity=\"1\" effort=\"1\"/><axis");
  const Machine machine = readUrdf(limited).machine;
  ASSERT_TRUE(machine.hasHingeLimits());
  EXPECT_EQ(
      passiveJoints(machine.leg(1)).open_hinges[0],
      "joint 'revolute_2' is a passive joint of a forearm, whose limits are not known as planes; those of struts on "
      "sliders are");
}
}  // namespace test
}  // namespace pkm_workspace
