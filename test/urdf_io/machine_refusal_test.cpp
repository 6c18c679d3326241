// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "urdf_io/expect_refused.h"
#include "urdf_io/urdf_edit.h"

namespace pkm_workspace
{
namespace test
{
namespace
{
const char* const PRISMATIC = "<axis xyz=\"1 0 0\"/><limit lower=\"0\" upper=\"1\" effort=\"1\" velocity=\"1\"/>";
}  // namespace

// Rails

TEST(MachineRefusal, otherThanThreeRails)
{
  expectRefused(withElements(good(), branch("lift", "prismatic", "base_link", PRISMATIC)),
                "4 prismatic joints and cranks \\('rail_x', 'rail_y', 'rail_z', 'lift'\\), expected the three that "
                "drive the legs");
  expectRefused(withJoint(good(), "rail_z", "prismatic", "fixed"),
                "2 prismatic joints and cranks \\('rail_x', 'rail_y'\\)");
  expectRefused("<robot name=\"x\"><link name=\"base\"/></robot>", "0 prismatic joints and cranks \\(none\\)");
}

TEST(MachineRefusal, railsThatAreCarriedOrDriven)
{
  expectRefused(withJoint(good(), "rail_z", "base_link", "slider_1"),
                "rail 'rail_z' is carried by joint 'rail_x', which is prismatic; expected fixed joints");
  expectRefused(withJoint(good(), "rail_z", "<axis", "<mimic joint=\"rail_x\"/><axis"),
                "rail 'rail_z' follows joint 'rail_x' by <mimic>, expected an actuated joint");
  const auto turning = withElements(good(),
                                    "<link name=\"world\"/><joint name=\"table\" type=\"continuous\"><axis xyz=\"0 0 "
                                    "1\"/><parent link=\"world\"/><child link=\"base_link\"/></joint>");
  expectRefused(turning, "rail 'rail_y' is carried by joint 'table', which is continuous");
}

TEST(MachineRefusal, railsThatAreNamedWrongly)
{
  expectRefused(good(), "rails names 2 joints \\('rail_x', 'rail_y'\\), expected three",
                { { "rail_x", "rail_y" }, {} });
  expectRefused(
      good(),
      "rails names 'rail_w', which is not a joint; the prismatic joints and cranks are: 'rail_x', 'rail_y', 'rail_z'",
      { { "rail_x", "rail_y", "rail_w" }, {} });
  expectRefused(good(), "rails names joint 'revolute_1', which is continuous",
                { { "rail_x", "rail_y", "revolute_1" }, {} });
  expectRefused(good(), "rails names joint 'rail_x' twice", { { "rail_x", "rail_y", "rail_x" }, {} });
}

// Struts and wrists

TEST(MachineRefusal, axesThatDoNotMeet)
{
  auto apart = withJoint(good(), "parallelogram_1", "xyz=\"0 0 0\"", "xyz=\"0.001 0 0\"");
  apart = withJoint(apart, "parallelogram_back_1", "xyz=\"1 0 0\"", "xyz=\"0.999 0 0\"");
  expectRefused(apart,
                "the axes of the passive joints 'revolute_1' 'parallelogram_1' at the slider do not meet: they are "
                "0.001 m apart, expected at most 1e-05 L = 1e-05 m");
  auto wrist = withJoint(good(), "revolute_back_2", "xyz=\"0 0 0\"", "xyz=\"0 0.002 0\"");
  wrist = withJoint(wrist, "parallelogram_back_2", "xyz=\"0 1 0\"", "xyz=\"0 0.998 0\"");
  expectRefused(wrist, "'parallelogram_back_2' 'revolute_back_2' at the platform do not meet: they are 0.002 m apart");
}

TEST(MachineRefusal, parallelAxes)
{
  auto urdf = withJoint(good(), "parallelogram_1", "<axis xyz=\"0 0 1\"/>", "<axis xyz=\"0 1 0\"/>");
  urdf = withJoint(urdf, "parallelogram_back_1", "<axis xyz=\"0 0 1\"/>", "<axis xyz=\"0 1 0\"/>");
  expectRefused(urdf,
                "'revolute_1' 'parallelogram_1' at the slider are parallel, expected axes that meet in one point");
}

TEST(MachineRefusal, aWristThatTurnsThePlatform)
{
  const auto back = [](const std::string& from, const std::string& to) {
    return withJoint(good(), "revolute_back_1", from, to);
  };
  const std::string leg = "leg of rail 'rail_x': ";
  expectRefused(
      back("multiplier=\"-1\"", "multiplier=\"1\""),
      leg +
          "joint 'revolute_back_1' turns the platform: it follows 'revolute_1' with multiplier 1 about the same "
          "axis as 'revolute_1', expected -1");
  expectRefused(back("xyz=\"0 1 0\"", "xyz=\"0 -3 0\""), "with multiplier -1 about the opposite axis .*, expected 1");
  expectRefused(back("multiplier=\"-1\"", "multiplier=\"-0.5\""),
                "with multiplier -0.5 about the same axis .*, expected -1");
  expectRefused(
      back("xyz=\"0 1 0\"", "xyz=\"0 1 0.01\""),
      "'revolute_back_1' turns the platform: its axis is 0.01 rad off that of 'revolute_1', which it follows");
  expectRefused(
      back("<mimic joint=\"revolute_1\" multiplier=\"-1\"/>", ""),
      "'revolute_back_1' turns the platform: it follows none of the joints 'revolute_1', 'parallelogram_1' at the "
      "slider; expected <mimic>");
  expectRefused(back("joint=\"revolute_1\"", "joint=\"parallelogram_1\""),
                "'revolute_back_1' turns the platform: it follows 'parallelogram_1' before 'revolute_1' is undone");
  expectRefused(back("type=\"continuous\"", "type=\"fixed\""),
                "link 'wrist_1' turns with joint 'revolute_1', which nothing undoes; expected a joint that follows it "
                "by <mimic>");
  expectRefused(back("multiplier=\"-1\"", "multiplier=\"-1\" offset=\"0.1\""), "<mimic> offset = 0.1 rad, expected 0");
  expectRefused(back("joint=\"revolute_1\"", "joint=\"rail_x\""),
                "'revolute_back_1' follows 'rail_x', which is prismatic");
}

TEST(MachineRefusal, aWristThatUndoesInTheWrongOrder)
{
  auto urdf = withJoint(good(), "parallelogram_back_3", "joint=\"parallelogram_3\"", "joint=\"revolute_3\"");
  expectRefused(urdf,
                "joint 'parallelogram_back_3' turns the platform: it follows 'revolute_3' before 'parallelogram_3' is "
                "undone; expected the joints of the wrist in the reverse order");
}

TEST(MachineRefusal, aWristThatIsTurnedAgainstTheStrut)
{
  const auto urdf = withJoint(good(), "parallelogram_back_1", "xyz=\"1 0 0\"", "xyz=\"1 0 0\" rpy=\"0.3 0 0\"");
  expectRefused(urdf,
                "joint 'parallelogram_back_1' turns the platform: its axis is 0.3 rad off that of 'parallelogram_1'");
}

TEST(MachineRefusal, strutsWithoutTheirFreedom)
{
  auto urdf = withJoint(good(), "parallelogram_1", "continuous", "fixed");
  urdf = withJoint(urdf, "parallelogram_back_1", "continuous", "fixed");
  expectRefused(withElements(urdf, ""),
                "link 'tip_1' swings about one axis only, that of joint 'revolute_1'; expected two or three");
  urdf = withJoint(withJoint(urdf, "revolute_1", "continuous", "fixed"), "revolute_back_1", "continuous", "fixed");
  expectRefused(urdf, "'bar_joint_[ab]_1' follows 'parallelogram_1', which is fixed; expected a passive joint");
  expectRefused(withJoint(good(), "revolute_1", "continuous", "floating"),
                "joint 'revolute_1' between slider and platform is floating, expected revolute, continuous or fixed");
}

TEST(MachineRefusal, strutsThatAreCoupled)
{
  auto urdf = withJoint(good(), "revolute_2", "<axis", "<mimic joint=\"revolute_1\"/><axis");
  expectRefused(urdf, "joints 'revolute_1' and 'revolute_2' both follow 'revolute_1', which couples their struts");
}

TEST(MachineRefusal, aStrutWithoutLength)
{
  expectRefused(withJoint(good(), "parallelogram_back_1", "xyz=\"1 0 0\"", "xyz=\"0 0 0\""),
                "strut of link 'strut_1': its length L = 0 m, expected a positive length");
}

// The zero configuration

TEST(MachineRefusal, tcpFramesApart)
{
  expectRefused(
      withJoint(good(), "tcp_joint_2", "xyz=\"0 0 0\"", "xyz=\"0 0.0125 0\""),
      "tcp frames of links 'tcp_1', 'tcp_2', 'tcp_3' are 0.0125 m apart at zero, expected at most 0.01 L = 0.01 m");
  expectRefused(withJoint(good(), "parallelogram_back_3", "xyz=\"0 0 1\"", "xyz=\"0 0 1.5\""),
                "are 0.5 m apart at zero");
}

TEST(MachineRefusal, aSerialSingularityAtZero)
{
  auto urdf = withJoint(good(), "rail_y", "<axis xyz=\"0 1 0\"/>", "<axis xyz=\"1 0 0\"/>");
  expectRefused(
      urdf,
      "link 'strut_2': a strut across its rail 'rail_y' at zero \\(serial singularity\\): eta = 0 m, expected "
      "more than 0.0001 L = 0.0001 m in size");
}

TEST(MachineRefusal, aParallelSingularityAtZero)
{
  // Leg 2 lies along leg 1: rail along x from A = (-1, 0, 0), strut along x.
  auto urdf = withJoint(good(), "rail_y", "xyz=\"0 -1 0\"", "xyz=\"-1 0 0\"");
  urdf = withJoint(urdf, "rail_y", "<axis xyz=\"0 1 0\"/>", "<axis xyz=\"1 1 0\"/>");
  urdf = withJoint(urdf, "parallelogram_back_2", "xyz=\"0 1 0\"", "xyz=\"1 0 0\"");
  expectRefused(urdf,
                "links 'strut_1', 'strut_2', 'strut_3': struts in parallel planes at zero \\(parallel singularity\\): "
                "det A = 0 m\\^3, expected more than 0.0001 L_1 L_2 L_3 = 0.0001 m\\^3 in size");
}

// Tool points

TEST(MachineRefusal, noLinkForTheToolPoint)
{
  const auto begin = good().find("<joint name=\"tcp_joint_3\"");
  const auto end = good().find("<joint name=\"bar_joint_a_3\"");
  expectRefused(good().substr(0, begin) + good().substr(end),
                "leg of rail 'rail_z': no link is fixed to link 'tip_3', expected one for the tool point");
}

TEST(MachineRefusal, toolPointsThatAreNamedWrongly)
{
  const auto names = [](const std::vector<std::string>& links) { return UrdfOptions{ {}, links }; };
  expectRefused(good(), "tcp_links names 2 links, expected three, one for each leg", names({ "tcp_1", "tcp_2" }));
  expectRefused(good(), "tcp_links names 'tool', which is not a link; the links are: 'bar_a_1', .*'wrist_3'",
                names({ "tcp_1", "tcp_2", "tool" }));
  expectRefused(good(), "tcp_links names link 'base_link', which no rail carries",
                names({ "tcp_1", "tcp_2", "base_link" }));
  expectRefused(good(), "tcp_links names links 'tcp_1' and 'tip_1' on the leg of rail 'rail_x'",
                names({ "tcp_1", "tcp_2", "tip_1" }));
  expectRefused(good(), "tcp link 'wrist_3': link 'wrist_3' turns with joint 'revolute_3'",
                names({ "tcp_1", "tcp_2", "wrist_3" }));
  const char* const third = "<axis xyz=\"0 1 0\"/><mimic joint=\"revolute_1\"/>";
  expectRefused(
      withElements(good(), branch("spindle", "continuous", "tip_1", third)),
      "tcp link 'spindle': joint 'spindle' turns the platform: it follows 'revolute_1', which is undone already",
      names({ "spindle", "tcp_2", "tcp_3" }));
  expectRefused(good(), "tcp link 'slider_3': link 'slider_3' is carried by no passive joints",
                names({ "tcp_1", "tcp_2", "slider_3" }));
}

TEST(MachineRefusal, toolPointsThatAreAmbiguous)
{
  std::string urdf = good();
  for (const char* const n : { "1", "2", "3" })
    urdf = withElements(
        urdf, branch(std::string("other_") + n, "fixed", std::string("tip_") + n, "<origin xyz=\"0 0 0.2\"/>"));
  expectRefused(urdf,
                "the links '.*_1', '.*_2', '.*_3' coincide at zero, and so do .*, elsewhere and as deep; name the tool "
                "point's with tcp_links");
}

TEST(MachineRefusal, filesThatCannotBeRead)
{
  expectThrow<std::invalid_argument>([] { readUrdfFile("no/such.urdf"); },
                                     "^no/such.urdf: cannot be read: No such file");
  expectThrow<std::invalid_argument>([] { readUrdfFile(PKM_WORKSPACE_SOURCE_DIR); }, "cannot be read: it is a folder");
  expectThrow<std::invalid_argument>([] { readUrdfFile(PKM_WORKSPACE_SOURCE_DIR "/package.xml"); },
                                     "package.xml: the URDF is refused:\n  the outermost element is <package>");
}
}  // namespace test
}  // namespace pkm_workspace
