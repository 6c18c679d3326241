// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "gcode_lines.h"

namespace pkm_workspace
{
namespace test
{
namespace
{
void expectRefused(const std::string& line, const std::string& reason)
{
  const std::string told = refusalOf({ "G1 F100 X1", line });
  EXPECT_NE(told.find(reason), std::string::npos) << line << ": " << told;
}

TEST(GcodeJob, WhatIsNotInTheSubsetIsRefused)
{
  for (const char* const line : { "G5 X1", "G38.2 Z1", "G41 D1", "G81 Z1", "G95", "G43.1 Z1", "G33 Z1", "G11", "M98 P1",
                                  "M206 X1", "M62", "G68 R45", "G76", "G100", "G0.5" })
    expectRefused(line, std::string(line).substr(0, std::string(line).find(' ')) + " is not among the codes");
  expectRefused("G1 X[1+2]", "parameters and expressions");
  expectRefused("#1=5", "parameters and expressions");
  expectRefused("G1 X#1", "parameters and expressions");
  expectRefused("/G1 X1", "depends on a switch");
  expectRefused("O100 sub", "O100 is not among the words");
  expectRefused("G1 A5", "A: this machine has the axes");
  expectRefused("G1 D5", "D5 is not among the words");
  expectRefused("G1 X1 X2", "X is given twice");
  expectRefused("G1 X", "X has no number");
  expectRefused("G X1", "G is not a code");
  expectRefused("G1.25 X1", "G1.25 is not a code");
  expectRefused("G1 X1..2", "is not a number");
  expectRefused("G1 X-", "it has no digits");
  expectRefused("G1 X1e-3", "is E a word of its own");
  expectRefused("G1 X1 2", "'2' begins no word");
  expectRefused("G1 X1 (open", "a comment that begins");
  expectRefused("G1 X1 (a (b))", "comments do not nest");
  expectRefused("G1 X1000000000", "at most 1000000 mm");
  expectRefused("G1 X1 P2", "P2 is without effect");
  expectRefused("G1 X1 I2", "I2 is without effect");
  expectRefused("H1", "H1 is without effect");
  expectRefused("START_PRINT", "S has no number");
  expectRefused("_PRINT", "'_' begins no word");
  expectRefused("G1 X\xC3\xA9", "X has no number");
}

TEST(GcodeJob, WhatContradictsItselfIsRefused)
{
  expectRefused("G0 G1 X1", "G0 and G1 exclude each other");
  expectRefused("G17 G18", "G17 and G18 exclude");
  expectRefused("G54 G55", "G54 and G55 exclude");
  expectRefused("G92 G1 X1", "two codes of the line need its axes");
  expectRefused("G80 X1", "no G0, G1, G2 or G3 is in effect");
  expectRefused("G20 F5", "old unit or the new one");
  expectRefused("F-5", "F must not be negative");
  expectRefused("M220 S50", "only M220 S100");
  expectRefused("G1 X1 M104 S5", "must stand in a line of its own");
  expectRefused("G43", "G43 without H");
  expectRefused("G43 H7", "the length of this tool is not given");
  expectRefused("G10", "G10 without L");
  expectRefused("G10 L20 P1 X0", "only G10 L2");
  expectRefused("G10 L2 P10 X0", "P10 must be a whole number from 0 to 9");
  expectRefused("G10 L2 P1.5 X0", "P1.5 must be a whole number");
  expectRefused("G92", "G92 needs");
  expectRefused("G53 G2 X1 I1", "G53 is read with G0 or G1");
  expectRefused("G53 G91 G1 X1", "G53 is read with");
  expectRefused("G2 X1", "an arc needs its center");
  expectRefused("G2 X2 R1 I1", "an arc needs its center");
  expectRefused("G2 X1 R1", "must end beside its start");
  expectRefused("G2 X2 K1", "K is not an axis of the plane in effect (G17)");
  expectRefused("G18 G2 X2 J1", "J is not an axis of the plane in effect (G18)");
  expectRefused("G19 G2 Y2 I1", "I is not an axis of the plane in effect (G19)");
  expectRefused("G90.1 G2 X2 I1", "J is missing");
  expectRefused("G2 X2 I1 P0", "P0 must be a whole number from 1");
}
}  // namespace
}  // namespace test
}  // namespace pkm_workspace
