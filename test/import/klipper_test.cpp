// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "expect_import.h"

namespace pkm_workspace
{
namespace test
{
namespace
{
const std::string& klipper()
{
  static const std::string text = sample("klipper.cfg");
  return text;
}

/// The sample without what a calibration saved.
const std::string& plainKlipper()
{
  static const std::string text = klipper().substr(0, klipper().find("#*#"));
  return text;
}

/// Klipper's delta.py: towers at radius * (cos, sin)(angle), carriages at z + sqrt(arm^2 - |tower - (x, y)|^2).
Carriages klipperCarriages(double radius, const std::array<double, 3>& angles, const std::array<double, 3>& arms)
{
  return [=](double x, double y, double z) {
    std::array<double, 3> carriages{};
    for (std::size_t i = 0; i < 3; ++i)
    {
      const double angle = angles[i] / 180.0 * M_PI;
      carriages[i] = z + std::sqrt(arms[i] * arms[i] - std::pow(std::cos(angle) * radius - x, 2) -
                                   std::pow(std::sin(angle) * radius - y, 2));
    }
    return carriages;
  };
}

TEST(Klipper, SavedCalibrationCounts)
{
  const FirmwareMachine machine = imported(klipper());
  EXPECT_EQ(machine.format, "klipper");
  expectSameKinematics(machine.machine, 70.0,
                       klipperCarriages(130.246113, { 210.213, 329.8665, 89.7 }, { 269.0, 268.8125, 269.0 }));
  EXPECT_EQ(machine.machine.legs[1].length, 0.2688125);
  EXPECT_EQ(machine.machine.legs[2].length, 0.269);
  EXPECT_EQ(machine.machine.legs[0].radius, 0.130246113);
  EXPECT_NE(reasonFor(machine, "printer delta_radius").find("line 55 counts"), std::string::npos);
  EXPECT_NE(reasonFor(machine, "stepper_a arm_length").find("line 59 counts"), std::string::npos);
}

TEST(Klipper, DefaultsAreThoseOfTheFirmware)
{
  const FirmwareMachine machine = imported(plainKlipper());
  expectSameKinematics(machine.machine, 70.0, klipperCarriages(130.5, { 210, 330, 89.7 }, { 269.0, 269.0, 269.0 }));
}

TEST(Klipper, LimitsFollowFromTheFirmware_sMoves)
{
  const MachineDescription machine = imported(klipper()).machine;
  const double ends[] = { 296.91125, 297.1265, 296.91125 };  // stepper_c takes what stepper_a has
  const double arms[] = { 269.0, 268.8125, 269.0 };
  const double radius = 130.246113;
  for (std::size_t i = 0; i < 3; ++i)
  {
    const double top = ends[i] + std::sqrt(arms[i] * arms[i] - radius * radius);
    const double bottom = -2 + std::sqrt(arms[i] * arms[i] - std::pow(radius + 110.0, 2));
    EXPECT_LE(machine.legs[i].upper, top * 1e-3);
    EXPECT_GE(machine.legs[i].upper, top * 1e-3 - 1.1e-6);
    EXPECT_GE(machine.legs[i].lower, bottom * 1e-3);
    EXPECT_LE(machine.legs[i].lower, bottom * 1e-3 + 1.1e-6);
    EXPECT_EQ(machine.legs[i].height, 0.0);
    EXPECT_EQ(machine.legs[i].working_mode, -1);
  }
  EXPECT_EQ(machine.legs[0].joint, "stepper_a");
}

TEST(Klipper, TellsWhatItTookAndWhatNot)
{
  const FirmwareMachine machine = imported(klipper());
  EXPECT_EQ(meaningOf(machine, "stepper_b arm_length"), "strut of stepper_b: 0.2688125 m");
  EXPECT_EQ(meaningOf(machine, "stepper_c angle"), "direction of stepper_c: 89.7 degrees");
  EXPECT_EQ(meaningOf(machine, "printer minimum_z_position"), "lowest z of the tool: -0.002 m");
  EXPECT_EQ(reasonFor(machine, "printer max_velocity"), "a limit of the tool's speed, not of a carriage's");
  EXPECT_EQ(machine.machine.legs[0].speed, 0.0);
  EXPECT_NE(reasonFor(machine, "stepper_a homing_speed"), "");
  EXPECT_EQ(reasonFor(machine, "[extruder]"), "no part of the geometry (2 values)");
  EXPECT_NE(reasonFor(machine, "[gcode_macro PARK]"), "");
  EXPECT_NE(reasonFor(machine, "include macros.cfg").find("was not read"), std::string::npos);
  for (const TakenValue& taken : machine.taken)
    EXPECT_EQ(taken.place.line > 0, taken.written != "not set") << taken.key;
  EXPECT_EQ(meaningOf(machine, "stepper_c arm_length"), "strut of stepper_c: 0.269 m, the default");
  EXPECT_EQ(meaningOf(imported(plainKlipper()), "stepper_b angle"), "direction of stepper_b: 330 degrees, the default");
}

TEST(Klipper, ReadsWhatItIncludes)
{
  const std::string main = edited(plainKlipper(), "arm_length: 269.0\n", "");
  expectImportRefused(main, "stepper_a arm_length is missing");
  const auto other = [](const std::string& name) -> std::optional<std::string> {
    return name == "macros.cfg" ? std::optional<std::string>("[stepper_a]\narm_length: 270.25\n") : std::nullopt;
  };
  const FirmwareMachine machine = importFirmware({ "printer.cfg", main, other });
  EXPECT_EQ(machine.machine.legs[2].length, 0.27025);
  EXPECT_EQ(machine.taken[2].place.file, "macros.cfg");
  const auto itself = [&](const std::string&) { return std::optional<std::string>("[include macros.cfg]\n"); };
  expectThrow<std::invalid_argument>(
      [&] {
        importFirmware({ "printer.cfg", main, itself });
      },
      "macros.cfg:1: '\\[include macros.cfg\\]' includes that file a second time");
}

TEST(Klipper, AnyLineEndMarkAndEncodingIsRead)
{
  std::string windows = "\xEF\xBB\xBF";
  for (const char c : klipper())
    windows += c == '\n' ? "\r\n" : std::string(1, c);
  windows = edited(windows, "measured", "gemessen: \xB0 und \xC3\xA4");  // a lone byte of Latin-1, and UTF-8
  windows = edited(windows, "print_radius = 110", "print_radius\t=\t110");
  const FirmwareMachine machine = imported(windows);
  EXPECT_EQ(machine.machine.legs[0].lower, imported(klipper()).machine.legs[0].lower);
  EXPECT_EQ(machine.taken.back().place.line, imported(klipper()).taken.back().place.line);
}

TEST(Klipper, EveryFaultIsToldAtOnce)
{
  std::string text = edited(plainKlipper(), "arm_length: 269.0", "arm_length: long");
  text = edited(text, "delta_radius: 130.5 ", "delta_radius: -130.5");
  expectImportRefused(text,
                      "(.|\n)*machine.cfg:12: printer delta_radius = '-130.5'(.|\n)*"
                      "machine.cfg:25: stepper_a arm_length = 'long' is not a number");
}

TEST(Klipper, WrongKindsAndRadiiAreRefused)
{
  expectEditsRefused(
      plainKlipper(),
      {
          { "kinematics: delta\n", "kinematics: corexy\n",
            "machine.cfg:8: .*'corexy' is not a linear delta; allowed: delta" },
          { "kinematics: delta\n", "", "\\[printer\\] kinematics is missing; expected kinematics: delta" },
          { "kinematics: delta\n", "kinematics: rotary_delta\n", "'rotary_delta' is not a linear delta" },
          { "delta_radius: 130.5 ", "", "printer delta_radius is missing|neither a" },
          { "delta_radius: 130.5 ", "delta_radius: ", "cfg:12: printer delta_radius = '' is not a number" },
          { "delta_radius: 130.5 ", "delta_radius: 130,5",
            "'130,5' is not a number; allowed: a decimal number.*1 to 100000 mm" },
          { "delta_radius: 130.5 ", "delta_radius: 130.5mm ", "'130.5mm' is not a number.*without its unit" },
          { "delta_radius: 130.5 ", "delta_radius: inf", "'inf' is not a number" },
          { "delta_radius: 130.5 ", "delta_radius: nan", "'nan' is not a number" },
          { "delta_radius: 130.5 ", "delta_radius: 1e999", "'1e999' is not a number" },
          { "delta_radius: 130.5 ", "delta_radius: 0.1305", "'0.1305' mm is out of range.*check its unit" },
          { "delta_radius: 130.5 ", "delta_radius: 0x82", "'0x82' is not a number" },
          { "delta_radius: 130.5 ", "delta_radius: 1e6", "'1e6' mm is out of range; allowed: from 1 to 100000 mm" },
          { "delta_radius: 130.5 ", "delta_radius: 300", "arm of stepper_a, 0.269 m, must be longer than.*0.3 m" },
          { "delta_radius: 130.5 ", "delta_radius: 269.0", "must be longer than the radius" },
      });
}

TEST(Klipper, MalformedFilesAreRefused)
{
  expectEditsRefused(
      plainKlipper(),
      {
          { "arm_length: 269.0\n", "", "stepper_a arm_length is missing; write it into \\[stepper_a\\], in mm" },
          { "arm_length: 269.0\n", "arm_length: 269.0\narm_length: 270\n",
            "cfg:26: stepper_a arm_length is given twice: '269.0' in machine.cfg:25 and '270' here" },
          { "position_endstop: 297.05\n", "", "stepper_a position_endstop is missing" },
          { "position_endstop: 297.05\n", "position_endstop: -3\n", "z = -0.003 m, must be above its lowest place" },
          { "angle: 89.7", "angle: 330.5", "cfg:25: stepper_b and stepper_c stand at 330 and 330.5 degrees" },
          { "angle: 89.7", "angle: 1570", "'1570' degrees is out of range; allowed: from -360 to 360 degrees" },
          { "angle: 89.7", "angle: north", "'north' is not a number" },
          { "[stepper_c]", "[stepper_c", "cfg:32: '\\[stepper_c' begins a section that has no name or no end" },
          { "[mcu]", "serial 1\n[mcu]", "cfg:4: 'serial 1' is neither a \\[section\\] nor a key with a value" },
          { "[include macros.cfg]", "speed: 5", "cfg:2: 'speed' stands before the first \\[section\\]" },
          { "[printer]", "[print]", "\\[printer\\] kinematics is missing" },
          { "print_radius = 110", "print_radius = 0", "printer print_radius = '0' mm is out of range" },
          { "minimum_z_position: -2", "minimum_z_position: 400", "must be above its lowest place, z = 0.4 m" },
          { "[stepper_a]", "#*# [stepper_a]", "cfg:16: .* whose first line is missing" },
      });
  expectImportRefused(edited(klipper(), "#*# angle = 329", "#*#\xC3\xA4ngle = 329"),
                      "cfg:63: .*has no blank after #\\*#");
  expectImportRefused(edited(klipper(), "#*# [delta_calibrate]", "[delta_calibrate]"),
                      "cfg:67: .*stands after the beginning of the block of SAVE_CONFIG");
}

TEST(Firmware, UnknownTextsAreRefused)
{
  expectImportRefused("", "looks like none of the formats that are read: klipper \\(Klipper's printer.cfg\\)");
  expectImportRefused("G1 X0\n", "machine.cfg: the text looks like none");
  expectImportRefused("[printer]\n", "the format 'klippr' is not known; allowed: klipper", "klippr");
  expectImportRefused(std::string("[printer]\0\n", 11), "zero bytes; save it as UTF-8");
  expectImportRefused("\xFF\xFE[\x01", "it is UTF-16");
  expectImportRefused("[printer]\n" + std::string(20000, 'x'), "cfg:2: no more than");
}
}  // namespace
}  // namespace test
}  // namespace pkm_workspace
