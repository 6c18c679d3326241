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
const std::string& report()
{
  static const std::string text = sample("marlin_report.txt");
  return text;
}

const MarlinNumbers REPORTED = { 130.25, 269.0, { 0.4, -0.3, 0.0 }, { 0, 0, 0 }, { 0.0, -0.2, 0.1 } };

TEST(MarlinReport, IsTheFirmware_sMachine)
{
  const FirmwareMachine machine = imported(report());
  EXPECT_EQ(machine.format, "marlin-report");
  expectSameKinematics(machine.machine, 70.0, REPORTED);
  expectSwitches(machine.machine, REPORTED, 305.5 + 1.5, { -0.25, 0.0, -1.12 });
  EXPECT_EQ(machine.machine.legs[1].length, 0.2688);
  EXPECT_EQ(machine.machine.legs[0].lower, 0.0);
}

TEST(MarlinReport, CommandsWithoutATerminalAreRead)
{
  const FirmwareMachine machine =
      imported("m665 L269 R130.25 H 305.5 S200 X0.4 Y-.3 Z0 A0 B-0.2 C.1*37\nN5 M666 X-0.25 Z-1.12 ; home\n");
  EXPECT_EQ(machine.format, "marlin-report");
  expectSameKinematics(machine.machine, 70.0, REPORTED);
}

TEST(MarlinReport, TheRadiusOfACalibrationIsNoTrim)
{
  const FirmwareMachine machine = imported(edited(report(), "A0.00 B-0.20 C0.10", "B90.00"));
  expectSameKinematics(machine.machine, 70.0,
                       MarlinNumbers{ 130.25, 269.0, { 0.4, -0.3, 0.0 }, { 0, 0, 0 }, { 0, 0, 0 } });
  EXPECT_NE(reasonFor(machine, "M665 B").find("the radius of the calibration"), std::string::npos);
}

TEST(MarlinReport, TellsWhatItTookAndWhatNot)
{
  const FirmwareMachine machine = imported(report());
  EXPECT_EQ(meaningOf(machine, "M665 B"), "trim of the strut of tower B: -0.0002 m");
  EXPECT_EQ(meaningOf(machine, "M851 Z"), "z of the probe, by which the tool homes away from H: -0.0015 m");
  EXPECT_NE(reasonFor(machine, "M92"), "");
  EXPECT_NE(reasonFor(machine, "M665 S"), "");
  EXPECT_NE(reasonFor(machine, "DELTA_RADIUS_TRIM_TOWER"), "");
}

TEST(MarlinReport, MalformedReportsAreRefused)
{
  expectEditsRefused(report(),
                     { { "L269.00 ", "", "M665 L is missing; the answer to M665 or M503 has it" },
                       { "R130.25 ", "", "M665 R is missing" },
                       { "H305.50 ", "", "M665 H is missing; releases before 1.1.3 do not report it" },
                       { "L269.00", "L", "cfg:9: M665 L = '' is not a number" },
                       { "L269.00", "L269,00", "'269,00' is not a number" },
                       { "L269.00", "L-269.00", "'-269.00' mm is out of range; allowed: from 1 to 100000 mm" },
                       { "L269.00", "Lnan", "M665 L = '' is not a number" },
                       { "L269.00", "L0.269", "'0.269' mm is out of range" },
                       { "L269.00", "L26900000", "is out of range" },
                       { "L269.00", "L130.25", "must be longer than the radius" },
                       { "L269.00", "L269.00 L270", "M665 L is given twice: '269.00' in machine.cfg:9 and '270' here" },
                       { "R130.25", "R{radius}", "M665 R = '\\{radius\\}' is not a number" },
                       { "R130.25", "R130.2.5", "'130.2.5' is not a number" },
                       { "R130.25", "R=130.25", "'=130.25' is not a number" },
                       { "H305.50", "H-1.5", "must be above its lowest place" },
                       { "X0.40", "X210.4", "'210.4' degrees is out of range" },
                       { "X0.40", "X--0.4", "'--0.4' is not a number" },
                       { "B-0.20", "B-200", "'-200' mm is out of range; allowed: from -100 to 100 mm" },
                       { "X-0.25", "X0.25", "M666 X = '0.25' mm is out of range; allowed: from -100 to 0 mm" },
                       { "Y0.00 Z-1.12", "Y0.00 Z-1.12\necho:  M666 X-0.25", "M666 X is given twice" },
                       { "Z-1.50", "Z-1.5.0", "M851 Z = .-1.5.0. is not a number" },
                       { "G21", "G20", "cfg:3: G20 sets inches, expected millimetres; set G21" } });
}
}  // namespace
}  // namespace test
}  // namespace pkm_workspace
