// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/import/machine_file.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "pkm_workspace/urdf_io/urdf_reader.h"
#include "pkm_workspace/urdf_io/urdf_writer.h"
#include "support/expect_throw.h"

namespace pkm_workspace
{
namespace test
{
namespace
{
const char* const SHORT_FILE = R"(all_legs: {rail_radius: 0.13, length: 0.269, travel: [0, 0.35]}
legs: [{}, {angle: 121}, {length: 0.27}]
)";

std::string changedIn(std::string text, const std::string& from, const std::string& to)
{
  const std::size_t place = text.find(from);
  EXPECT_NE(place, std::string::npos) << from;
  return text.replace(place, from.size(), to);
}

std::string changed(const std::string& from, const std::string& to)
{
  return changedIn(SHORT_FILE, from, to);
}
}  // namespace

TEST(MachineFile, templateDescribesACalibratedDelta)
{
  const MachineDescription machine = readMachineText(machineFileTemplate(), "template");
  EXPECT_EQ(machine.name, "my_machine");
  EXPECT_DOUBLE_EQ(machine.legs[1].angle, 120.4 * M_PI / 180.0);
  EXPECT_EQ(machine.legs[1].length, 0.2688);
  EXPECT_EQ(machine.legs[2].radius, 0.13);
  EXPECT_EQ(machine.tool, Eigen::Vector3d(0.0, 0.0, -0.04));
  EXPECT_DOUBLE_EQ(machine.mount->rpy.z(), 15.0 * M_PI / 180.0);
  EXPECT_TRUE(readUrdf(writeUrdf(machine)).warnings.empty());
}

// Found by fuzzing: a URDF with such a name is refused.
TEST(MachineFile, namesArePrintable)
{
  const std::string reason = "printable UTF-8 \\(byte 129\\)";
  expectThrow<std::invalid_argument>([] { readMachineText(std::string("name: my_\x81\n") + SHORT_FILE, "m.yaml"); },
                                     "m.yaml:1: name.*" + reason);
  expectThrow<std::invalid_argument>([] { readMachineText(changed("[{}", "[{joint: a\x81}"), "m.yaml"); },
                                     "m.yaml:2: joint.*" + reason);
}

// The template's own words: the tool touches the table with all sliders at the lower ends.
TEST(MachineFile, standsOnTheTableWithoutAHomeHeight)
{
  const MachineDescription machine = readMachineText(machineFileTemplate(), "template");
  const auto tool = assembledTool(machine, Eigen::Vector3d::Zero());
  ASSERT_TRUE(tool);
  EXPECT_NEAR(tool->z(), 0.0, 0.5e-6 + 1e-12);
}

TEST(MachineFile, templatesOfTheOtherKindsDescribeATripodAndADelta)
{
  const MachineDescription tripod = readMachineText(machineFileTemplate(LegDescription::Kind::TELESCOPE), "t");
  EXPECT_EQ(tripod.legs[1].kind, LegDescription::Kind::TELESCOPE);
  EXPECT_EQ(tripod.legs[1].joint, "strut_2");
  EXPECT_EQ(tripod.legs[1].length, 0.8004);
  EXPECT_EQ(tripod.legs[1].lower, -0.3);
  EXPECT_TRUE(tripod.is_upper);
  EXPECT_GT(readUrdf(writeUrdf(tripod)).machine.zero().z(), 0.6);
  const MachineDescription delta = readMachineText(machineFileTemplate(LegDescription::Kind::CRANK), "d");
  EXPECT_EQ(delta.legs[2].kind, LegDescription::Kind::CRANK);
  EXPECT_EQ(delta.legs[2].joint, "crank_3");
  EXPECT_EQ(delta.legs[2].crank, 0.524);
  EXPECT_EQ(delta.legs[2].radius, 0.164);
  EXPECT_DOUBLE_EQ(delta.legs[2].lower, -35.0 * M_PI / 180.0);
  EXPECT_LT(readUrdf(writeUrdf(delta)).machine.zero().z(), 0.75 - 0.9);
}

// What all legs share counts for those that have it.
TEST(MachineFile, legsMayBeOfDifferentKinds)
{
  const MachineDescription machine = readMachineText(R"(
unit: mm
all_legs: {rail_radius: 130, base_radius: 60, length: 269, crank: 90, base_height: 250}
legs:
  - {travel: [0, 350], home_height: 300}
  - {kind: telescope, travel: [-50, 60]}
  - {kind: crank, travel: [-60, 90], turn: -1, crank_zero: 15, axis_lean: 30, working_mode: 1, joint_speed_max: 3}
)",
                                                     "mix");
  EXPECT_EQ(machine.legs[0].kind, LegDescription::Kind::RAIL);
  EXPECT_EQ(machine.legs[0].radius, 0.13);
  EXPECT_EQ(machine.legs[0].height, 0.3);
  EXPECT_EQ(machine.legs[1].radius, 0.06);
  EXPECT_EQ(machine.legs[1].height, 0.25);
  EXPECT_EQ(machine.legs[1].upper, 0.06);
  EXPECT_EQ(machine.legs[1].crank, 0.0);
  EXPECT_EQ(machine.legs[2].crank, 0.09);
  EXPECT_DOUBLE_EQ(machine.legs[2].upper, M_PI / 2.0);
  EXPECT_DOUBLE_EQ(machine.legs[2].crank_zero, M_PI / 12.0);
  EXPECT_DOUBLE_EQ(machine.legs[2].axis_lean, M_PI / 6.0);
  EXPECT_EQ(machine.legs[2].turn, -1);
  EXPECT_EQ(machine.legs[2].working_mode, 1);
  EXPECT_EQ(machine.legs[2].speed, 3.0);
}

TEST(MachineFile, legsTakeWhatTheyHaveInCommon)
{
  const MachineDescription machine = readMachineText(SHORT_FILE, "short");
  EXPECT_EQ(machine.legs[0].length, 0.269);
  EXPECT_EQ(machine.legs[2].length, 0.27);
  EXPECT_EQ(machine.legs[0].angle, 0.0);
  EXPECT_DOUBLE_EQ(machine.legs[1].angle, 121.0 * M_PI / 180.0);
  EXPECT_FALSE(machine.mount);
}

// 268.8 mm are the double nearest to 0.2688, which 268.8 / 1000 need not be.
TEST(MachineFile, millimetresAreReadToTheLastDigit)
{
  const MachineDescription machine = readMachineText(
      "unit: mm\nall_legs: {rail_radius: 130.1, length: 268.8, travel: "
      "[-0.7, 350.3]}\nlegs: [{}, {}, {}]\n",
      "mm");
  EXPECT_EQ(machine.legs[0].length, 0.2688);
  EXPECT_EQ(machine.legs[0].radius, 0.1301);
  EXPECT_EQ(machine.legs[0].lower, -0.0007);
  EXPECT_EQ(machine.legs[0].upper, 0.3503);
}

TEST(MachineFile, refusesWithLineAndReason)
{
  const std::pair<std::string, std::string> cases[] = {
    { "", "f.yaml:1: the file must be a list of keys with their values" },
    { "- 1\n- 2\n", "f.yaml:1: the file must be a list of keys" },
    { "all_legs: [", "f.yaml:.*not valid YAML: " },
    { changed("length: 0.269", "lenght: 0.269"),
      "f.yaml:1: unknown key 'lenght' in all_legs; its keys are: kind, angle, rail_radius, base_" },
    { changed("length: 0.269", "length: 0.269, length: 0.3"), "f.yaml:1: 'length' stands a second time in all_legs" },
    { changed("length: 0.269", "length: long"), "f.yaml:1: length = 'long', expected a number \\[m\\]" },
    { changed("length: 0.269", "length: .inf"), "f.yaml:1: length = '.inf', expected a number \\[m\\]" },
    { changed("length: 0.269", "length: 1e400"), "f.yaml:1: length = '1e400', expected a number" },
    { changed("length: 0.269", "length: -0.3"), "leg 1: strut length = -0.3 m, expected a length from 1e-9 to 1e9 m" },
    { changed("length: 0.269, ", ""), "length is missing for leg 1, 2: that of its strut" },
    { changed("rail_radius: 0.13, ", ""), "rail_radius is missing: the distance of its rail from the middle" },
    { changed(", travel: [0, 0.35]", ""), "travel is missing: the least and the largest joint value" },
    { changed("[0, 0.35]", "[0.35, 0]"), "leg 1: travel from 0.35 to 0 m, expected the lower end first" },
    { changed("[0, 0.35]", "0.35"), "f.yaml:1: travel needs 2 values in brackets \\(LO HI\\), got 1" },
    { changed("{angle: 121}", "{angle: 121, x: 0.1}"), "leg 2: x and y belong together, and y is missing" },
    { changed("{angle: 121}", "{x: 0.1, y: 0.1}"),
      "f.yaml:1: rail_radius and x, y of leg 2 both say where its rail is" },
    { changed("{angle: 121}", "{working_mode: 2}"), "f.yaml:2: working_mode = '2', expected -1 or 1" },
    { changed("{angle: 121}", "{home: 0.1}"), "f.yaml:2: home of leg 2 says where the slider is at home, and home_h" },
    { changed("rail_radius: 0.13", "rail_radius: -0.13"), "f.yaml:1: rail_radius of leg 1 = -0.13 m, expected a pos" },
    { changed("length: 0.269", "length: 0.269, platform_radius: -0.03"), "platform_radius of leg 1 = -0.03 m, expec" },
    { changed("{angle: 121}", "{home_height: 1}"), "home_height is missing for leg 1, 3: other legs have a height" },
    { changed("[{}, {angle: 121}", "[{}, {}, {angle: 121}"), "f.yaml:2: legs must be a list of three.*got 4" },
    { changed("all_legs: {", "all_legs: {joint: a, "), "f.yaml:1: unknown key 'joint' in all_legs" },
    { changed("all_legs", "unit: cm\nall_legs"), "f.yaml:1: unit = 'cm', expected m or mm" },
    { std::string(SHORT_FILE) + "tool: [0, 0]\n", "f.yaml:3: tool needs 3 values in brackets \\(X Y Z\\), got 2" },
    { std::string(SHORT_FILE) + "mount: [0, 0, x]\n", "f.yaml:3: mount = 'x', expected a number \\[m\\]" },
    { std::string(SHORT_FILE) + "assembly: left\n", "f.yaml:3: assembly = 'left', expected lower or upper" },
    { std::string(SHORT_FILE) + "name: []\n", "f.yaml:3: name needs one value" },
    { changed("length: 0.269", "length: 0.1"), "the struts do not meet" },
    { "legs: [{}, {}, {}]\n" + std::string("all_legs: {length: 1}\n"), "f.yaml:2: all_legs must stand before legs" },
  };
  for (const auto& [text, pattern] : cases)
    expectThrow<std::invalid_argument>([&text = text] { readMachineText(text, "f.yaml"); }, pattern);
}

TEST(MachineFile, refusesWhatLegsOfAKindDoNotHave)
{
  const std::pair<std::string, std::string> cases[] = {
    { changed("{angle: 121}", "{kind: hexapod}"), "f.yaml:2: kind = 'hexapod', expected rail or telescope or crank" },
    { changed("{angle: 121}", "{crank: 0.1}"), "f.yaml:2: crank of leg 2, which is of kind rail: it has none" },
    { changed("{angle: 121}", "{kind: crank, lean: [0, 1]}"),
      "f.yaml:2: lean of leg 2, which is of kind crank: it ha" },
    { changed("{angle: 121}", "{kind: crank}"), "base_radius is missing for leg 2: the distance of its crank's axis" },
    { changed("{angle: 121}", "{kind: crank}"), "crank is missing for leg 2: the length of its crank" },
    { changed("{angle: 121}", "{kind: crank}"), "home_height is missing for leg 1, 3: other legs have a height" },
    { changed("{angle: 121}", "{kind: crank, turn: 0}"), "f.yaml:2: turn = '0', expected -1 or 1" },
    { changed("{angle: 121}", "{kind: telescope, base_radius: 0}"),
      "f.yaml:2: base_radius of leg 2 = 0 m, expected a" },
    { changed("length: 0.269", "length: 0.269, crank: 0.1"), "f.yaml:1: crank is a number of kind crank only, and no" },
  };
  for (const auto& [text, pattern] : cases)
    expectThrow<std::invalid_argument>([&text = text] { readMachineText(text, "f.yaml"); }, pattern);
}

TEST(MachineFile, saysEverythingAtOnce)
{
  const std::string text = changedIn(changed("length: 0.269", "length: long"), "angle: 121", "angel: 121");
  expectThrow<std::invalid_argument>([&] { readMachineText(text, "f.yaml"); }, "unknown key 'angel' in leg 2");
}
}  // namespace test
}  // namespace pkm_workspace
