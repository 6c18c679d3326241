// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "pkm_workspace/machine/machine.h"
#include "pkm_workspace/urdf_io/joint_values.h"
#include "pkm_workspace/urdf_io/urdf_reader.h"
#include "urdf_io/expect_refused.h"
#include "urdf_io/urdf_edit.h"

namespace pkm_workspace
{
namespace test
{
namespace
{
using Eigen::Vector3d;

UrdfMachine equalHomes(const UrdfOptions& options = {})
{
  return readUrdfFile(PKM_WORKSPACE_SOURCE_DIR "/test/data/equal_homes.urdf", options);
}

/// Where the three sliders of equal_homes.urdf have the strut's joint at joint values 0, and the struts' lengths: read
/// from the file by eye, in the frame base_link.
constexpr double TOWERS[] = { 0.0, 2.101376419401173, 4.1835542170304079 };
constexpr double LENGTHS[] = { 0.269, 0.2688, 0.2691 };

/// The middle of the platform's joints is in the frame base_link as this says of a tool point in the root frame.
Vector3d platformOf(const Vector3d& tool)
{
  const Vector3d in_base = Eigen::AngleAxisd(-0.26179938779914941, Vector3d::UnitZ()) * (tool - Vector3d(0, 0, 0.75));
  return in_base + Vector3d(0.0, 0.0, 0.04);
}

/// How much the strut of a leg is too long for its joint value [m].
double excess(int leg, const Vector3d& tool, double joint)
{
  const double angle = TOWERS[leg];
  const Vector3d outwards(std::cos(angle), std::sin(angle), 0.0);
  const Vector3d slider = 0.13 * outwards + Vector3d(0.0, 0.0, 0.34972184525988115 + joint);
  const double length = (platformOf(tool) + 0.03 * outwards - slider).norm();
  return length - LENGTHS[leg];
}
}  // namespace

// A calibrated machine homes its sliders at one height while its struts differ by tenths of a millimetre.
TEST(UnassembledZero, isWhereTheStrutsMeet)
{
  const UrdfMachine urdf = equalHomes();
  const Vector3d zero = urdf.machine.zero();
  for (int i = 0; i < 3; ++i)
    EXPECT_NEAR(excess(i, zero, 0.0), 0.0, 1e-14) << "leg " << i;
  EXPECT_EQ(urdf.tool_point,
            "the tool point is where the links 'tcp1', 'tcp2', 'tcp3' coincide at joint values 0, the deepest that do");
  EXPECT_EQ(urdf.gap,
            "the legs are drawn up to 0.000324 m apart at joint values 0 (allowed: 0.00269 m); the zero "
            "configuration is where the struts meet");
  EXPECT_TRUE(readUrdf(good()).gap.empty());
}

TEST(UnassembledZero, leavesTheControllersJointValues)
{
  const UrdfMachine urdf = equalHomes();
  for (const Vector3d& offset : { Vector3d(0.02, -0.03, 0.1), Vector3d(-0.05, 0.01, 0.2), Vector3d(0.0, 0.0, 0.3) })
  {
    const Vector3d p = urdf.machine.zero() + offset;
    const auto joints = inverseKinematics(urdf.machine, p);
    ASSERT_TRUE(joints);
    for (int i = 0; i < 3; ++i)
      EXPECT_NEAR(excess(i, p, (*joints)[i]), 0.0, 1e-14) << "leg " << i;
  }
}

TEST(UnassembledZero, isRefusedWhereTheLegsAreFarApart)
{
  const std::string far = withJoint(good(), "tcp_joint_2", "xyz=\"0 0 0\"", "xyz=\"0 0 0.011\"");
  expectRefused(far,
                "are 0.011 m apart at zero, expected at most 0.01 L = 0.01 m: at zero the machine must be drawn "
                "assembled, or nearly");
  const std::string near = withJoint(good(), "tcp_joint_2", "xyz=\"0 0 0\"", "xyz=\"0 0 0.009\"");
  EXPECT_NO_THROW(readUrdf(near));
}

// Which links belong together must not be guessed: a plate and a tool point 5 mm apart, in a machine drawn 4 mm apart.
TEST(UnassembledZero, isRefusedWhereLinksHaveTwoPartners)
{
  const std::string apart = withJoint(good(), "tcp_joint_2", "xyz=\"0 0 0\"", "xyz=\"0 0 0.004\"");
  const std::string two = withElements(apart, branch("cover", "fixed", "tcp_2", "<origin xyz=\"0 0 0.005\"/>"));
  expectRefused(two,
                "link 'tcp_1' is drawn within 0.01 m of both '(tcp_2|cover)' and '(tcp_2|cover)', which differ; name "
                "the three links of the tool point with tcp_links");
  UrdfOptions options;
  options.tcp_links = { "tcp_1", "tcp_2", "tcp_3" };
  EXPECT_NO_THROW(readUrdf(two, options));
}

TEST(UnassembledZero, countsTheDistanceOfEveryTwoLegs)
{
  const std::string up = withJoint(good(), "tcp_joint_2", "xyz=\"0 0 0\"", "xyz=\"0 0 0.006\"");
  expectRefused(withJoint(up, "tcp_joint_3", "xyz=\"0 0 0\"", "xyz=\"0 0 -0.006\""), "are 0.012 m apart at zero");
}

// Struts that lie nearly flat meet above and below, a millimetre or two apart: which one is drawn is no more than a
// guess.
TEST(UnassembledZero, isRefusedWhereTheOtherAssemblyIsNear)
{
  MachineDescription flat;
  for (std::size_t i = 0; i < 3; ++i)
  {
    flat.legs[i].joint = "rail_" + std::to_string(i + 1);
    flat.legs[i].angle = 2.0 * M_PI / 3.0 * static_cast<double>(i);
    flat.legs[i].radius = 0.1;
    flat.legs[i].length = 0.100004;
    flat.legs[i].upper = 0.1;
  }
  const std::string urdf = writeUrdf(flat);
  EXPECT_NO_THROW(readUrdf(urdf));
  expectRefused(withJoint(urdf, "tcp_joint_2", "xyz=\"0 0 0\"", "xyz=\"0 0 0.0003\""),
                "the struts do not meet within 0.001\\S* m of where they are drawn in one place alone");
  // Drawn assembled as far as its digits go, it is taken as it is drawn.
  const UrdfMachine drawn = readUrdf(withJoint(urdf, "tcp_joint_2", "xyz=\"0 0 0\"", "xyz=\"0 0 0.000005\""));
  EXPECT_NE(drawn.gap.find("the zero configuration is as the first leg is drawn"), std::string::npos) << drawn.gap;
}

TEST(ToolLink, isTheToolPointWhenNamed)
{
  const std::string text = withElements(good(), branch("spindle", "fixed", "tcp_1", "<origin xyz=\"0 0 -0.08\"/>"));
  const UrdfMachine ignored = readUrdf(text);
  ASSERT_EQ(ignored.warnings.size(), 1u);
  EXPECT_EQ(ignored.warnings[0],
            "link 'spindle' is fixed 0.08 m from where the legs meet, and is not the tool point; "
            "name it with tool_link if it is meant");
  UrdfOptions options;
  options.tool_link = "spindle";
  const UrdfMachine named = readUrdf(text, options);
  EXPECT_TRUE(named.warnings.empty());
  EXPECT_NE(named.tool_point.find("the tool point is the link 'spindle', as tool_link names it"), std::string::npos);
  EXPECT_EQ(named.machine.zero(), ignored.machine.zero() + Vector3d(0.0, 0.0, -0.08));
  for (const Vector3d& p : { Vector3d(0.1, 0.2, -0.1), Vector3d(0.0, 0.0, 0.0), Vector3d(-0.2, 0.1, 0.05) })
  {
    const auto platform = inverseKinematics(ignored.machine, p);
    const auto tool = inverseKinematics(named.machine, p + Vector3d(0.0, 0.0, -0.08));
    ASSERT_TRUE(platform && tool);
    EXPECT_LT((*platform - *tool).norm(), 1e-14);
  }
}

// The platform never turns: the tip is where the legs meet, and this further.
TEST(Tool, isSeenFromWhereTheLegsMeet)
{
  const std::string text = withElements(good(), branch("spindle", "fixed", "tcp_1", "<origin xyz=\"0 0 -0.08\"/>"));
  const Vector3d tip(0.03125, -0.0625, -0.125);
  const UrdfMachine platform = readUrdf(good());
  UrdfOptions options;
  options.tool = tip;
  const UrdfMachine tool = readUrdf(text, options);
  EXPECT_TRUE(tool.warnings.empty()) << "who gives a tool has chosen";
  EXPECT_NE(tool.tool_point.find("the tool point is (0.03125, -0.0625, -0.125) m from where the legs meet, as tool "
                                 "gives it; they meet where the links 'tcp_1'"),
            std::string::npos)
      << tool.tool_point;
  EXPECT_EQ(tool.machine.zero(), platform.machine.zero() + tip);
  for (const Vector3d& p : { Vector3d(0.1, 0.2, -0.1), Vector3d(0.0, 0.0, 0.0), Vector3d(-0.2, 0.1, 0.05) })
  {
    const auto of_platform = inverseKinematics(platform.machine, p);
    const auto of_tip = inverseKinematics(tool.machine, p + tip);
    ASSERT_TRUE(of_platform && of_tip);
    EXPECT_LT((*of_platform - *of_tip).norm(), 1e-14);
  }
  options.tool_link = "spindle";
  expectRefused(text, "tool = \\(0.03125, .*\\) m and tool_link = 'spindle' both tell the tool point; give one",
                options);
  options.tool_link = "";
  options.tool = Vector3d(0.0, NAN, 0.0);
  expectRefused(text, "tool = \\(0, nan, 0\\) m must be finite, within 1e9 m", options);
}

TEST(ToolLink, hasToBeFixedToThePlatform)
{
  UrdfOptions options;
  options.tool_link = "strut_2";
  expectRefused(good(), "tool_link 'strut_2': link 'strut_2' turns with joint 'parallelogram_2'", options);
  options.tool_link = "base_link";
  expectRefused(good(), "tool_link names link 'base_link', which no rail carries; expected one fixed to the platform",
                options);
  options.tool_link = "drill";
  expectRefused(good(), "tool_link names 'drill', which is not a link; the links are: ", options);
}
}  // namespace test
}  // namespace pkm_workspace
