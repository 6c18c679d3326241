// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "expect_import.h"
#include "marlin_carriages.h"

namespace pkm_workspace
{
namespace test
{
namespace
{
const std::string& configuration()
{
  static const std::string text = sample("marlin_configuration.txt");
  return text;
}

const MarlinNumbers MARLIN = { 130.25, 269.0, { 0.4, -0.3, 0.0 }, { 0.1, 0.0, -0.2 }, { 0.0, -0.2, 0.1 } };

TEST(Marlin, ConfigurationIsTheFirmware_sMachine)
{
  const FirmwareMachine machine = imported(configuration());
  EXPECT_EQ(machine.format, "marlin");
  expectSameKinematics(machine.machine, 70.0, MARLIN);
  EXPECT_EQ(machine.machine.legs[0].length, 0.269);
  EXPECT_EQ(machine.machine.legs[1].length, 0.2688);  // 269.0 - 0.2, where doubles make 0.26880000000000004
  EXPECT_EQ(machine.machine.legs[1].radius, 0.13025);
  EXPECT_EQ(machine.machine.legs[0].joint, "tower_a");
}

TEST(Marlin, SwitchesAreAboveHome)
{
  expectSwitches(imported(configuration()).machine, MARLIN, 305.5 + 1.5, { -0.25, 0.0, -1.125 });
  const std::string no_probe = edited(configuration(), "#define FIX_MOUNTED_PROBE", "");
  expectSwitches(imported(no_probe).machine, MARLIN, 305.5, { -0.25, 0.0, -1.125 });
}

TEST(Marlin, LowerLimitsFollowFromTheRadiusThatIsPrinted)
{
  const double lowest = std::sqrt(std::pow(269.0, 2) - std::pow(130.35 + 100.0, 2)) * 1e-3;
  const MachineDescription machine = imported(configuration()).machine;
  EXPECT_GE(machine.legs[0].lower, lowest);
  EXPECT_LE(machine.legs[0].lower, lowest + 1.1e-6);
}

TEST(Marlin, OlderNamesAreRead)
{
  std::string text = edited(configuration(), "DELTA_HEIGHT 305.5", "MANUAL_Z_HOME_POS 305.5");
  text = edited(text, "#define DELTA_DIAGONAL_ROD_TRIM_TOWER { 0.0, -0.2, 0.1 }",
                "#define DELTA_DIAGONAL_ROD_TRIM_TOWER_2 -0.2\n#define DELTA_DIAGONAL_ROD_TRIM_TOWER_3 0.1f");
  text = edited(text, "#define PRINTABLE_RADIUS", "#define DELTA_PRINTABLE_RADIUS");
  expectSameKinematics(imported(text).machine, 70.0, MARLIN);
  expectSwitches(imported(text).machine, MARLIN, 305.5, { -0.25, 0.0, -1.125 });
}

TEST(Marlin, TellsWhatItTookAndWhatNot)
{
  const FirmwareMachine machine = imported(configuration());
  EXPECT_EQ(meaningOf(machine, "DELTA_RADIUS"), "radius, across from effector joint to carriage joint: 0.13025 m");
  EXPECT_EQ(meaningOf(machine, "DELTA_DIAGONAL_ROD_TRIM_TOWER"), "added to the struts: 0 m, -0.0002 m, 0.0001 m");
  EXPECT_EQ(reasonFor(machine, "DELTA_SMOOTH_ROD_OFFSET"), "goes into other values, or into conditions");
  EXPECT_NE(reasonFor(machine, "other #defines"), "");
  EXPECT_EQ(machine.taken[1].place.line, 27U);
}

TEST(Marlin, WhatTheFileDoesNotDecideIsRefused)
{
  expectEditsRefused(
      configuration(),
      { { "LONG_RODS > 0", "MB(RAMPS_14_EFB)",
          "cfg:26: #if MB\\(RAMPS_14_EFB\\) && !defined\\(SHORT_RODS\\): whether DELTA_DIAGONAL_ROD counts "
          "depends on this condition" },
        { "LONG_RODS > 0", "MOTHERBOARD == 1020", "whether DELTA_DIAGONAL_ROD counts" },
        { "LONG_RODS > 0", "LONG_RODS >", "whether DELTA_DIAGONAL_ROD counts" },
        { "LONG_RODS > 0", "sizeof(int)", "whether DELTA_DIAGONAL_ROD counts" } });
  const std::string other_way = edited(configuration(), "LONG_RODS > 0", "LONG_RODS == 2 || EITHER(DELTAS, RODS)");
  EXPECT_EQ(imported(other_way).machine.legs[0].length, 0.215);
  const std::string unimportant =
      edited(configuration(), "#define EXTRUDERS 1", "#if MB(X)\n#define EXTRUDERS 1\n#endif");
  EXPECT_EQ(imported(unimportant).machine.legs[0].length, 0.269);
}

TEST(Marlin, MalformedTextIsRefused)
{
  expectEditsRefused(
      configuration(),
      { { "carriages and the effector take off */", "carriages", "cfg:15: the comment that begins here has no end" },
        { "\"Workshop // delta\"", "\"Workshop", "cfg:7: '\"Workshop' is a text without its closing quote" },
        { "#define EXTRUDERS 1", "#define", "cfg:9: '#define' defines no name; expected #define NAME value" },
        { "#define EXTRUDERS 1", "#endif", "cfg:9: this #endif has no #if" },
        { "#define EXTRUDERS 1", "#else", "cfg:9: '#else' follows no #if" },
        { "#endif\n\n#define FIX", "#define FIX", "cfg:23: '#if ENABLED\\(DELTA\\)' has no #endif" },
        { "#define DELTA\n", "//#define DELTA\n", "#define DELTA is missing; only Marlin's linear deltas are read" },
        { "#define DELTA\n", "#define DELTA 0\n", "#define DELTA is missing" },
        { "#define DELTA_HEIGHT 305.5", "", "machine.cfg: DELTA_HEIGHT is missing; write #define DELTA_HEIGHT" } });
}

TEST(Marlin, MalformedValuesAreRefused)
{
  expectEditsRefused(
      configuration(),
      { { "DELTA_HEIGHT 305.5", "DELTA_HEIGHT",
          "cfg:31: DELTA_HEIGHT = '' is not a number; allowed: a number, or a sum" },
        { "DELTA_HEIGHT 305.5", "DELTA_HEIGHT 305.5mm", "'305.5mm' is not a number" },
        { "DELTA_HEIGHT 305.5", "DELTA_HEIGHT INFINITY", "'INFINITY' is not a number" },
        { "DELTA_HEIGHT 305.5", "DELTA_HEIGHT (305.5", "'\\(305.5' is not a number" },
        { "DELTA_HEIGHT 305.5", "DELTA_HEIGHT 611/2", "'611/2' is not a number" },
        { "DELTA_HEIGHT 305.5", "DELTA_HEIGHT DELTA_HEIGHT", "'DELTA_HEIGHT' is not a number" },
        { "DELTA_HEIGHT 305.5", "DELTA_HEIGHT 0305", "'0305' is not a number" },
        { "DELTA_HEIGHT 305.5", "DELTA_HEIGHT system(\"true\")", "is not a number" },
        { "DELTA_HEIGHT 305.5", "DELTA_HEIGHT -4", "z = -0.00225 m, must be above its lowest place" },
        { "DELTA_HEIGHT 305.5", "DELTA_HEIGHT 305.5\n#define DELTA_HEIGHT 306",
          "given twice: '305.5' in machine.cfg:31" },
        { "DELTA_DIAGONAL_ROD 269.0", "DELTA_DIAGONAL_ROD 130.25", "arm of tower_a, 0.13025 m, must be longer than" },
        { "DELTA_DIAGONAL_ROD 269.0", "DELTA_DIAGONAL_ROD 0.269", "'0.269' mm is out of range" },
        { "DELTA_DIAGONAL_ROD 269.0", "DELTA_DIAGONAL_ROD 1e30", "'1e30' mm is out of range" },
        { "-1.125 }", "1.125 }", "cfg:32: DELTA_ENDSTOP_ADJ = '1.125' mm is out of range; allowed: from -100 to 0 mm" },
        { "-1.125 }", "-1.125, 0 }", "is not a list of three numbers; expected \\{ A, B, C \\} in mm" },
        { "{ 0.4, -0.3, 0.0 }", "0.4", "cfg:35: DELTA_TOWER_ANGLE_TRIM = '0.4' is not a list of three" },
        { "{ 0.4, -0.3, 0.0 }", "{ 0.4, -0.3, }", "DELTA_TOWER_ANGLE_TRIM = '' is not a number" },
        { "{ 0.4, -0.3, 0.0 }", "{ 120, -0.3, 0 }", "'120' degrees is out of range; allowed: from -30 to 30 degrees" },
        { "DELTA_CARRIAGE_OFFSET (2 * 17.5)", "DELTA_CARRIAGE_OFFSET (17.5 * 99)", "mm is out of range" },
        { "DELTA_CARRIAGE_OFFSET (2 * 17.5)", "CARRIAGE 35", "-\\(DELTA_CARRIAGE_OFFSET\\)\\)' is not a number" },
        { "NOZZLE_TO_PROBE_OFFSET { 10, 10, -1.5 }", "NOZZLE_TO_PROBE_OFFSET { 10, 10, Z }", "'Z' is not a number" } });
}
}  // namespace
}  // namespace test
}  // namespace pkm_workspace
