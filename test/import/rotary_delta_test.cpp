// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "expect_import.h"

namespace pkm_workspace
{
namespace test
{
namespace
{
constexpr double DEGREE = M_PI / 180.0;

FirmwareMachine importedRotary(const std::string& ini, const std::string& hal)
{
  return importFirmware({ "machine.ini", ini, [&](const std::string& name) {
                           return name == "rdelta.hal" ? std::optional<std::string>(hal) : std::nullopt;
                         } });
}

/// rotarydeltakins-common.h: inverse_j0() of the point turned so that thigh 0 is towards -y, for thighs at 0, 120 and
/// 240 degrees counter-clockwise from there. The knee is where a circle about the hip meets a sphere about the ankle,
/// in the plane of the thigh: the line z = b y - a of both, and the outer one of its two points.
Cranks rotarydeltakins(double platform, double thigh, double shin, double foot)
{
  return [=](double x, double y, double z) {
    std::array<double, 3> angles{};
    for (std::size_t i = 0; i < 3; ++i)
    {
      const double turn = -120.0 * DEGREE * static_cast<double>(i);
      const double along = -(std::sin(turn) * x + std::cos(turn) * y), aside = std::cos(turn) * x - std::sin(turn) * y;
      const double ankle = along + foot;
      const double a =
          (aside * aside + ankle * ankle + z * z + thigh * thigh - shin * shin - platform * platform) / (2.0 * z);
      const double b = (ankle - platform) / z;
      const double root = thigh * thigh * (b * b + 1.0) - (a - b * platform) * (a - b * platform);
      const double knee = (platform + a * b + std::sqrt(root)) / (b * b + 1.0);
      angles[i] = std::atan2(b * knee - a, knee - platform);
    }
    return angles;
  };
}

/// delta_calcAngleYZ() of grblHAL's delta.c, for motors at 270, 30 and 150 degrees; sides of triangles in place of
/// radii.
Cranks grblHal(double base, double crank, double forearm, double effector)
{
  return [=](double x, double y, double z) {
    const double tan30 = std::tan(30.0 * DEGREE), cos120 = -0.5, sin120 = std::sqrt(3.0) / 2.0;
    const auto angle = [&](double x0, double y0) {
      const double edge = -0.5 * tan30 * base, shifted = y0 - 0.5 * tan30 * effector;
      const double a =
          (x0 * x0 + shifted * shifted + z * z + crank * crank - forearm * forearm - edge * edge) / (2.0 * z);
      const double b = (edge - shifted) / z;
      const double root = crank * crank * (b * b + 1.0) - (a + b * edge) * (a + b * edge);
      const double joint = (edge - a * b - std::sqrt(root)) / (b * b + 1.0);
      return std::atan(-(a + b * joint) / (edge - joint)) + (joint > edge ? M_PI : 0.0);
    };
    return std::array<double, 3>{ angle(x, y), angle(x * cos120 + y * sin120, y * cos120 - x * sin120),
                                  angle(x * cos120 - y * sin120, y * cos120 + x * sin120) };
  };
}
}  // namespace

TEST(RotaryDelta, OfLinuxCncIsTheFirmware_sMachine)
{
  const FirmwareMachine machine =
      importFirmwareFile(std::string(PKM_WORKSPACE_SOURCE_DIR) + "/test/data/firmware/rdelta.ini");
  EXPECT_EQ(machine.format, "linuxcnc");
  expectSameCranks(machine.machine, 200.0, -420.0, -180.0, rotarydeltakins(100.25, 150.0, 350.5, 45.5));
  const LegDescription& leg = machine.machine.legs[0];
  EXPECT_EQ(leg.joint, "joint_0");
  EXPECT_DOUBLE_EQ(leg.lower, -40.0 * DEGREE);
  EXPECT_DOUBLE_EQ(leg.upper, 95.5 * DEGREE);
  EXPECT_DOUBLE_EQ(leg.speed, M_PI);
  EXPECT_EQ(machine.machine.legs[1].speed, 0.0) << "none is known";
  EXPECT_DOUBLE_EQ(machine.machine.legs[2].lower, -39.5 * DEGREE);
  EXPECT_EQ(leg.crank, 0.15);
  EXPECT_EQ(leg.length, 0.3505);
  EXPECT_EQ(meaningOf(machine, "rotarydeltakins.footradius"), "radius of the forearms' lower ends: 0.0455 m");
  EXPECT_EQ(meaningOf(machine, "JOINT_0 MAX_VELOCITY"), "largest speed of joint 0: 180 degrees/s");
  EXPECT_EQ(reasonFor(machine, "AXIS_Z MIN_LIMIT"), "a limit of the tool, not of a joint");
}

TEST(RotaryDelta, OfLinuxCncMayBeInInches)
{
  const std::string ini = edited(sample("rdelta.ini"), "LINEAR_UNITS = mm", "LINEAR_UNITS = inch");
  const std::string hal =
      "setp rotarydeltakins.platformradius 4\nsetp rotarydeltakins.thighlength 6.5\n"
      "setp rotarydeltakins.shinlength 14.25\nsetp rotarydeltakins.footradius 0.75\n";
  expectSameCranks(importedRotary(ini, hal).machine, 200.0, -450.0, -200.0,
                   rotarydeltakins(101.6, 165.1, 361.95, 19.05));
}

TEST(RotaryDelta, OfLinuxCncIsRefusedWithPlaceAndRemedy)
{
  const auto refuse = [](const std::string& ini, const std::string& hal, const std::string& pattern) {
    SCOPED_TRACE(pattern);
    expectThrow<std::invalid_argument>([&] { importedRotary(ini, hal); }, pattern);
  };
  const std::string ini = sample("rdelta.ini"), hal = sample("rdelta.hal");
  refuse(ini, "setp rotarydeltakins.footradius 6\n",
         "the forearm, 0.014 m, must be longer than what it bridges where all cranks are level, 0.014 m");
  refuse(ini, edited(hal, "45.5", "-45.5"), "rotarydeltakins.footradius = '-45.5' mm is out of range");
  refuse(ini, edited(hal, "thighlength 150", "thighlength long"), "hal:3: rotarydeltakins.thighlength = 'long' is not");
  refuse(ini, hal + "setp rotarydeltakins.kneeoffset 1\n",
         "rotarydeltakins.kneeoffset = '1' changes the kinematics in a way that is not read; allowed: platformradius");
  refuse(edited(ini, "MAX_LIMIT = 95.5", "MAX_LIMIT = -40"), hal,
         "the upper limit of joint_0, -40 degrees, must be above the lower one, -40 degrees");
  refuse(edited(ini, "MAX_LIMIT = 95.5", "MAX_LIMIT = 400"), hal,
         "ini:24: JOINT_0 MAX_LIMIT = '400' degrees is out of");
  refuse(edited(ini, "HALFILE = rdelta.hal", "HALFILE = other.hal"), hal,
         "rotarydeltakins.thighlength is missing; put");
}

TEST(RotaryDelta, OfGrblHalIsTheFirmware_sMachine)
{
  const FirmwareMachine machine = imported(sample("grblhal.txt"));
  EXPECT_EQ(machine.format, "grblhal");
  EXPECT_EQ(machine.machine.name, "grblhal_delta");
  expectSameCranks(machine.machine, 150.0, -400.0, -150.0, grblHal(187.5, 102.0, 310.5, 62.25));
  const LegDescription& leg = machine.machine.legs[2];
  EXPECT_EQ(leg.joint, "motor_c");
  EXPECT_DOUBLE_EQ(leg.lower, -5.5 * DEGREE);
  EXPECT_DOUBLE_EQ(leg.upper, 98.0 * DEGREE);
  EXPECT_DOUBLE_EQ(leg.speed, 2.0);
  EXPECT_EQ(meaningOf(machine, "$643"), "side of the triangle whose inscribed circle the cranks' axes touch: 0.1875 m");
  EXPECT_EQ(reasonFor(machine, "$645"), "a limit of the tool, not of a crank");
}

TEST(RotaryDelta, OfGrblHalIsRefusedWithPlaceAndRemedy)
{
  expectEditsRefused(sample("grblhal.txt"),
                     { { "$648=98.000", "$648=0.000", "cfg:20: \\$648 = 0 has the firmware compute how far" },
                       { "$648=98.000\n", "", "\\$648 is missing; the answer to \\$\\$ of release v0.03" },
                       { "$646=-5.500", "$646=99", "the upper limit of motor_a, 98 degrees, must be above the lower" },
                       { "$641=310.500", "$641=0.3105", "\\$641 = '0.3105' mm is out of range" },
                       { "$642=102.000\n", "", "\\$642 is missing; the answer to" },
                       { "$642=102.000", "$642=102.000\n$642=103", "\\$642 is given twice" },
                       { "$641=310.500", "$641=130", "the forearm, 0.13 m, must be longer than what it bridges" } });
}
}  // namespace test
}  // namespace pkm_workspace
