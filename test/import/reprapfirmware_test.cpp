// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "expect_import.h"

namespace pkm_workspace
{
namespace test
{
namespace
{
const std::string& configG()
{
  static const std::string text = sample("config.g");
  return text;
}

/// LinearDeltaKinematics.cpp: Recalc() and Transform(). [mm, degrees, shares]
struct RepRapNumbers
{
  std::array<double, 3> rods;
  double radius;
  std::array<double, 3> corrections;
  double tilt_x;
  double tilt_y;

  std::array<double, 3> operator()(double x, double y, double z) const
  {
    const auto radians = [](double degrees) { return degrees * M_PI / 180.0; };
    const std::array<double, 3> tower_x = { -(radius * std::cos(radians(30 + corrections[0]))),
                                            radius * std::cos(radians(30 - corrections[1])),
                                            -(radius * std::sin(radians(corrections[2]))) };
    const std::array<double, 3> tower_y = { -(radius * std::sin(radians(30 + corrections[0]))),
                                            -(radius * std::sin(radians(30 - corrections[1]))),
                                            radius * std::cos(radians(corrections[2])) };
    std::array<double, 3> carriages{};
    for (std::size_t i = 0; i < 3; ++i)
      carriages[i] = std::sqrt(rods[i] * rods[i] - std::pow(x - tower_x[i], 2) - std::pow(y - tower_y[i], 2)) + z +
                     x * tilt_x + y * tilt_y;
    return carriages;
  }
};

const RepRapNumbers REPRAP = { { 269.0, 268.8, 269.1 }, 130.246, { -0.105, 0.161, 0.0 }, 0.0011, -0.0008 };

TEST(RepRapFirmware, IsTheFirmware_sMachineOverATiltedBed)
{
  const FirmwareMachine machine = imported(configG());
  EXPECT_EQ(machine.format, "reprapfirmware");
  // In the axes of the towers, a point of the bed's coordinates is as much higher as the bed is there.
  expectSameKinematics(machine.machine, 70.0, [](double x, double y, double z) {
    return REPRAP(x, y, z - REPRAP.tilt_x * x - REPRAP.tilt_y * y);
  });
  EXPECT_EQ(machine.machine.legs[1].length, 0.2688);
}

TEST(RepRapFirmware, TheMountLevelsTheBed)
{
  const MachineDescription machine = imported(configG()).machine;
  ASSERT_TRUE(machine.mount);
  const Eigen::Vector3d& rpy = machine.mount->rpy;
  const Eigen::Matrix3d rotation =
      (Eigen::AngleAxisd(rpy.z(), Eigen::Vector3d::UnitZ()) * Eigen::AngleAxisd(rpy.y(), Eigen::Vector3d::UnitY()) *
       Eigen::AngleAxisd(rpy.x(), Eigen::Vector3d::UnitX()))
          .toRotationMatrix();
  for (const Eigen::Vector2d& p :
       { Eigen::Vector2d(0.1, 0.0), Eigen::Vector2d(0.0, 0.1), Eigen::Vector2d(-0.07, 0.03) })
  {
    const Eigen::Vector3d on_bed(p.x(), p.y(), REPRAP.tilt_x * p.x() + REPRAP.tilt_y * p.y());
    const Eigen::Vector3d level = rotation * on_bed;
    EXPECT_NEAR(level.z(), 0.0, 1e-15);
    EXPECT_NEAR((level.head<2>() - p).norm(), 0.0, 1e-6);
  }
  EXPECT_FALSE(imported(edited(configG(), " A0.11 B-0.08", "")).machine.mount);
}

TEST(RepRapFirmware, SwitchesAreWhereTheFirmwareHomes)
{
  const MachineDescription machine = imported(configG()).machine;
  const std::array<double, 3> carriages = REPRAP(0, 0, 305.47);
  const double above[] = { -0.748, -0.006, 0.755 };
  for (std::size_t i = 0; i < 3; ++i)
  {
    EXPECT_LE(machine.legs[i].upper, (carriages[i] + above[i]) * 1e-3);
    EXPECT_GE(machine.legs[i].upper, (carriages[i] + above[i]) * 1e-3 - 1.1e-6);
    const double sunk = -0.5 - 110.0 * std::hypot(0.0011, 0.0008);
    const double lowest = sunk + std::sqrt(std::pow(REPRAP.rods[i], 2) - std::pow(130.246 + 110.0, 2));
    EXPECT_GE(machine.legs[i].lower, lowest * 1e-3);
    EXPECT_LE(machine.legs[i].lower, lowest * 1e-3 + 1.1e-6);
  }
}

TEST(RepRapFirmware, OneLengthIsForAllRods)
{
  const FirmwareMachine machine = imported("M669 K3\nM665 R130.25 L269 H300\n");
  expectSameKinematics(machine.machine, 70.0, RepRapNumbers{ { 269, 269, 269 }, 130.25, { 0, 0, 0 }, 0, 0 });
  EXPECT_EQ(meaningOf(machine, "M665 L"), "struts: 0.269 m, 0.269 m, 0.269 m");
  EXPECT_EQ(meaningOf(machine, "M665 B"), "largest distance of the tool from the middle: 0.08 m, the default");
}

TEST(RepRapFirmware, TellsWhatItTookAndWhatNot)
{
  const FirmwareMachine machine = imported(configG());
  EXPECT_EQ(meaningOf(machine, "M666 A"), "slope of the bed along x: 0.0011 m for each metre");
  EXPECT_EQ(meaningOf(machine, "M208 Z"), "lowest z of the tool: -0.0005 m");
  EXPECT_EQ(reasonFor(machine, "M208"), "on a delta only the lower end of Z is used");
  EXPECT_EQ(reasonFor(machine, "M569"), "no part of the geometry (3 values)");
  EXPECT_NE(reasonFor(imported(edited(configG(), "B110.0", "B110.0 Q5")), "M665 Q"), "");
  EXPECT_NE(reasonFor(imported(edited(configG(), "B110.0", "B110.0 \xC2\xB0")), "M665 \xC2\xB0"), "");
}

TEST(RepRapFirmware, OtherMachinesAreRefused)
{
  expectEditsRefused(
      configG(),
      { { "M83", "M669 K1", "cfg:4: M669 K = '1' is not a linear delta; allowed: 3" },
        { "M83", "M669 K3 X100 Y0", "cfg:4: M669 X = '100' sets a fourth tower" },
        { "269.000:268.800:269.100", "269:269:269:269", "M665 L = '269:269:269:269' is for 4 towers, expected one" },
        { "269.000:268.800:269.100", "269:268.8", "is for 2 towers" },
        { "M83", "G20", "cfg:4: G20 sets inches" },
        { "M666 X", "if {true}\n  M666 X", "cfg:15: M666 depends on a condition" },
        { "\nM665 ", "\nwhile {sensors.probe}\n    M665 ", "cfg:14: M665 depends on a condition" } });
}

TEST(RepRapFirmware, MalformedFilesAreRefused)
{
  expectEditsRefused(
      configG(),
      { { "269.000:268.800:269.100", "269.000:long:269.100", "cfg:13: M665 L = '269.000:' is for 2 towers|no number" },
        { "269.000:268.800:269.100", "269.000::269.100", "M665 L = '' is not a number" },
        { "L269.000:268.800:269.100 ", "", "M665 L is missing; it is the length of the rods in mm" },
        { "269.000:268.800:269.100", "269.000:130.246:269.100", "arm of tower_y, 0.130246 m, must be longer" },
        { "269.000:268.800:269.100", "0.269", "'0.269' mm is out of range" },
        { "R130.246 ", "", "M665 R is missing" },
        { "R130.246", "R{global.radius}", "'\\{global.radius\\}' is not a number" },
        { "R130.246", "R-130.246", "'-130.246' mm is out of range; allowed: from 1 to 100000 mm" },
        { "R130.246", "R130.246 R131", "M665 R is given twice" },
        { "R130.246", "Rinf", "M665 R = '' is not a number" },
        { "R130.246", "R130,246", "'130,246' is not a number" },
        { "R130.246", "R300", "must be longer than the radius" },
        { "H305.470 ", "", "M665 H is missing" },
        { "H305.470", "H", "M665 H = '' is not a number" },
        { "H305.470", "H-1", "must be above its lowest place" },
        { "B110.0", "B0", "M665 B = '0' mm is out of range" },
        { "Y0.161", "Y-120", "'-120' degrees is out of range; allowed: from -30 to 30 degrees" },
        { "Z0.755", "Z755", "'755' mm is out of range; allowed: from -100 to 100 mm" },
        { "A0.11", "A0.1.1", "'0.1.1' is not a number" },
        { "A0.11", "A45", "M666 A = '45' % is out of range; allowed: from -20 to 20 %" },
        { "M666 X", "M666 Z0\nM666 X", "M666 Z is given twice: '0' in machine.cfg:14 and '0.755' here" },
        { "M208 Z-0.5", "M208 Z{low}", "M208 Z = '\\{low\\}' is not a number" },
        { "M208 Z-0.5", "M208 Z400", "must be above its lowest place, z = 0.4 m" } });
}
}  // namespace
}  // namespace test
}  // namespace pkm_workspace
