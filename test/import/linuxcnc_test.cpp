// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "expect_import.h"

namespace pkm_workspace
{
namespace test
{
namespace
{
const std::string& ini()
{
  static const std::string text = sample("ldelta.ini");
  return text;
}

FirmwareMachine importedWith(const std::string& text, const std::string& hal)
{
  return importFirmware({ "machine.ini", text, [&](const std::string& name) {
                           return name == "ldelta.hal" ? std::optional<std::string>(hal) : std::nullopt;
                         } });
}

void expectRefusedWith(const std::string& text, const std::string& hal, const std::string& pattern)
{
  SCOPED_TRACE(pattern);
  expectThrow<std::invalid_argument>([&] { importedWith(text, hal); }, pattern);
}

void expectIniEditsRefused(const std::vector<Spoil>& spoils)
{
  for (const Spoil& spoil : spoils)
    expectRefusedWith(edited(ini(), spoil.was, spoil.is), sample("ldelta.hal"), spoil.pattern);
}

/// lineardeltakins-common.h: set_geometry() and kinematics_inverse(). [mm]
Carriages lineardeltakins(double l, double r, const std::array<double, 3>& offsets = {})
{
  return [=](double x, double y, double z) {
    const double sin60 = std::sqrt(3.0) / 2.0;
    const auto joint = [&](double tower_x, double tower_y) {
      return z + std::sqrt(l * l - (tower_x - x) * (tower_x - x) - (tower_y - y) * (tower_y - y));
    };
    return std::array<double, 3>{ joint(0, r) + offsets[0], joint(-sin60 * r, -0.5 * r) + offsets[1],
                                  joint(sin60 * r, -0.5 * r) + offsets[2] };
  };
}

TEST(LinuxCnc, CommandsOfTheIniFileCount)
{
  const std::string commands = "HALFILE = ldelta.hal\nHALCMD = setp lineardeltakins.R 100.0\nHALCMD = show";
  const std::string text = edited(ini(), "HALFILE = ldelta.hal", commands);
  const std::string unset = edited(sample("ldelta.hal"), "sets R 130.25", "#");
  const std::string without = edited(unset, "net R lineardeltakins.R => lineardelta.R", "#");
  EXPECT_EQ(importedWith(text, without).machine.legs[0].radius, 0.1);
}

TEST(LinuxCnc, IsTheFirmware_sMachine)
{
  const FirmwareMachine machine =
      importFirmwareFile(std::string(PKM_WORKSPACE_SOURCE_DIR) + "/test/data/firmware/ldelta.ini");
  EXPECT_EQ(machine.format, "linuxcnc");
  expectSameKinematics(machine.machine, 70.0, lineardeltakins(269.0, 130.25));
  const double upper[] = { 0.5405, 0.540125, 0.54 };
  const double lower[] = { 0.04, 0.04, 0.0395 };
  for (std::size_t i = 0; i < 3; ++i)
  {
    EXPECT_EQ(machine.machine.legs[i].lower, lower[i]);
    EXPECT_EQ(machine.machine.legs[i].upper, upper[i]);
    EXPECT_EQ(machine.machine.legs[i].joint, "joint_" + std::to_string(i));
  }
}

/// [JOINT_n] MAX_VELOCITY is the joint's, in units of the machine for each second; its manual has it so.
TEST(LinuxCnc, TakesTheSpeedsOfTheCarriages)
{
  const std::string with = edited(ini(), "[JOINT_1]\n", "[JOINT_1]\nMAX_VELOCITY = 152.4\n");
  const FirmwareMachine machine = importedWith(with, sample("ldelta.hal"));
  EXPECT_EQ(machine.machine.legs[0].speed, 0.0) << "none is known";
  EXPECT_EQ(machine.machine.legs[1].speed, 0.1524);
  EXPECT_EQ(meaningOf(machine, "JOINT_1 MAX_VELOCITY"), "largest speed of joint 1: 0.1524 m/s");
  expectRefusedWith(edited(with, "152.4", "-1"), sample("ldelta.hal"), "JOINT_1 MAX_VELOCITY = -?.*-1.*mm/s");
}

TEST(LinuxCnc, InchesAreExact)
{
  std::string text = edited(ini(), "LINEAR_UNITS = mm", "LINEAR_UNITS = inch");
  text = edited(text, "ROD = 269.0", "ROD = 10.5");
  const FirmwareMachine machine = importedWith(text, edited(sample("ldelta.hal"), "sets R 130.25", "sets R 5.1"));
  expectSameKinematics(machine.machine, 70.0, lineardeltakins(266.7, 129.54));
  EXPECT_EQ(machine.machine.legs[0].length, 0.2667);
  EXPECT_EQ(machine.machine.legs[2].lower, 1.0033);
}

TEST(LinuxCnc, OffsetsOfJointsMoveTheirZero)
{
  const std::string hal =
      "setp lineardeltakins.L 269\nsetp lineardeltakins.R 130.25\nsetp lineardeltakins.J1off -3.5\n";
  expectSameKinematics(importedWith(ini(), hal).machine, 70.0, lineardeltakins(269.0, 130.25, { 0, -3.5, 0 }));
}

TEST(LinuxCnc, JointsOfOldReleasesAreAxes)
{
  std::string text = ini();
  for (const char* const joint : { "[JOINT_0]", "[JOINT_1]", "[JOINT_2]" })
    text = edited(text, joint, "[AXIS_" + std::string(joint).substr(7));
  EXPECT_EQ(importedWith(text, sample("ldelta.hal")).machine.legs[2].lower, 0.0395);
}

TEST(LinuxCnc, DefaultsCountWhereNothingElseCan)
{
  const FirmwareMachine machine = importedWith(ini(), "loadrt lineardeltakins\n");
  expectSameKinematics(machine.machine, 70.0, lineardeltakins(269.0, 130.25));
  EXPECT_EQ(meaningOf(machine, "lineardeltakins.L"), "struts: 0.269 m, the default");
  expectImportRefused(ini(), "lineardeltakins.L is missing; put the HAL files beside the INI file");
  expectRefusedWith(edited(ini(), "HALUI = halui", "HALFILE = more.tcl"), "loadrt lineardeltakins\n",
                    "lineardeltakins.R is missing");
}

TEST(LinuxCnc, FilesThatAreIncludedAreRead)
{
  const std::string text = edited(ini(), "[DELTA]\nROD = 269.0\n", "#INCLUDE delta.inc\n");
  const auto other = [](const std::string& name) -> std::optional<std::string> {
    if (name == "delta.inc")
      return "[DELTA]\nROD = 270.5\n";
    if (name == "ldelta.hal")
      return "loadrt lineardeltakins\nsource lengths.hal # of the rods\n";
    return name == "lengths.hal" ? std::optional<std::string>("setp lineardeltakins.L [DELTA](ROD)\n") : std::nullopt;
  };
  expectSameKinematics(importFirmware({ "machine.ini", text, other }).machine, 70.0, lineardeltakins(270.5, 130.25));
  expectRefusedWith(text, "source lengths.hal\n", "lineardeltakins.L is missing; put the HAL files beside");
  expectRefusedWith(text, "source ldelta.hal\n", "ldelta.hal:1: 'source ldelta.hal' includes that file a second time");
}

TEST(LinuxCnc, TellsWhatItTookAndWhatNot)
{
  const FirmwareMachine machine = importedWith(ini(), sample("ldelta.hal"));
  EXPECT_EQ(meaningOf(machine, "lineardeltakins.R"), "radius, across from effector joint to carriage joint: 0.13025 m");
  EXPECT_EQ(machine.taken.at(2).place.file, "ldelta.hal");
  EXPECT_EQ(reasonFor(machine, "AXIS_Z MIN_LIMIT"), "a limit of the tool, not of a joint");
  EXPECT_NE(reasonFor(machine, "JOINT_0 HOME_OFFSET"), "");
  EXPECT_NE(reasonFor(machine, "[EMC]"), "");
  EXPECT_NE(reasonFor(machine, "HAL HALFILE"), "");
}

TEST(LinuxCnc, MalformedIniFilesAreRefused)
{
  expectIniEditsRefused({
      { "= lineardeltakins", "= trivkins",
        "ini:16: KINS KINEMATICS = 'trivkins' is not a delta; allowed: lineardeltakins, rotarydeltakins" },
      { "= lineardeltakins", "= rotarydeltakins", "JOINT_0 MAX_LIMIT = '540.5' degrees is out of range" },
      { "KINEMATICS = lineardeltakins\n", "",
        "\\[KINS\\] KINEMATICS is missing; expected lineardeltakins or rotarydeltakins" },
      { "LINEAR_UNITS = mm\n", "", "\\[TRAJ\\] LINEAR_UNITS is missing; expected mm or inch" },
      { "LINEAR_UNITS = mm", "LINEAR_UNITS = furlong", "'furlong' is not a unit; allowed: mm, inch" },
      { "[KINS]", "[KINS", "ini:15: '\\[KINS' begins a section that has no name or no end" },
      { "JOINTS = 3", "JOINTS", "ini:17: 'JOINTS' is neither a \\[section\\] nor a key with a value" },
      { "MAX_LIMIT = 540.5\n", "", "JOINT_0 MAX_LIMIT is missing; write it into \\[JOINT_0\\]" },
      { "MIN_LIMIT = 39.5\n", "", "JOINT_2 MIN_LIMIT is missing" },
      { "MIN_LIMIT = 39.5\n", "MIN_LIMIT = 600\n",
        "upper limit of joint_2, 0.54 m, must be above the lower one, 0.6 m" },
      { "MIN_LIMIT = 39.5\n", "MIN_LIMIT = -1e99\n", "not a number; allowed|out of range" },
      { "MIN_LIMIT = 39.5\n", "MIN_LIMIT = low\n", "ini:35: JOINT_2 MIN_LIMIT = 'low' is not a number" },
      { "MIN_LIMIT = 39.5\n", "MIN_LIMIT = 39.5 mm\n", "'39.5 mm' is not a number" },
      { "MIN_LIMIT = 39.5\n", "MIN_LIMIT = 39.5\nMIN_LIMIT = 40\n", "JOINT_2 MIN_LIMIT is given twice" },
      { "MAX_LIMIT = 540.125", "MAX_LIMIT = inf", "'inf' is not a number" },
      { "MAX_LIMIT = 540.125", "MAX_LIMIT =", "JOINT_1 MAX_LIMIT = '' is not a number" },
      { "ROD = 269.0", "ROD = 0.269", "lineardeltakins.L = '0.269' mm is out of range; allowed: from 1 to 100000 mm" },
      { "ROD = 269.0", "ROD = 100",
        "arm of joint_0, 0.1 m, must be longer than the radius that it bridges, 0.13025 m" },
      { "ROD = 269.0", "BAR = 269.0", "hal:6: lineardeltakins.L = '\\[DELTA\\]ROD' is not a number" },
  });
}

TEST(LinuxCnc, MalformedHalFilesAreRefused)
{
  for (const Spoil& spoil :
       std::vector<Spoil>{ { "130.25", "thirteen", "ldelta.hal:5: lineardeltakins.R = 'thirteen' is not a number" },
                           { "130.25", "-130.25", "'-130.25' mm is out of range" },
                           { "130.25", "nan", "'nan' is not a number" },
                           { "sets R 130.25", "sets R 130.25\nsets R 131",
                             "lineardeltakins.R is given twice: '130.25' in ldelta.hal:5" },
                           { "sets R 130.25", "setp lineardeltakins.R1off 2\nsets R 130.25",
                             "R1off = '2' changes the kinematics in a way" },
                           { "[DELTA]ROD", "[DELTA]RODS", "'\\[DELTA\\]RODS' is not a number" },
                           { "[DELTA]ROD", "", "lineardeltakins.L = '' is not a number" } })
    expectRefusedWith(ini(), edited(sample("ldelta.hal"), spoil.was, spoil.is), spoil.pattern);
}
}  // namespace
}  // namespace test
}  // namespace pkm_workspace
