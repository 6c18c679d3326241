// SPDX-License-Identifier: BSD-3-Clause
// Jobs in G-code as a planner has them checked, and limits for controllers. What the words mean is tested where they
// are read; here, that the node takes the same ones.
#include <pkm_workspace/CheckGcode.h>
#include <pkm_workspace/ExportLimits.h>

#include <cmath>
#include <regex>

#include "node_client.h"
#include "pkm_workspace/machine/catalogue.h"
#include "pkm_workspace/ros/client.h"
#include "pkm_workspace/tasks/limits_export.h"

namespace pkm_workspace
{
namespace test
{
namespace
{
using Response = CheckGcode::Response;

shape_msgs::SolidPrimitive boxOf(double side)
{
  shape_msgs::SolidPrimitive solid;
  solid.type = shape_msgs::SolidPrimitive::BOX;
  solid.dimensions = { side, side, side };
  return solid;
}

void expectRefused(const std::function<void(Client&)>& ask, const std::string& message)
{
  Client machine;
  try
  {
    ask(machine);
    FAIL() << "not refused, expected: " << message;
  }
  catch (const Refused& refused)
  {
    EXPECT_EQ(ErrorCode::INVALID_REQUEST, refused.error_code);
    EXPECT_TRUE(std::regex_search(refused.what(), std::regex(message))) << refused.what();
  }
}
}  // namespace

TEST(CheckGcode, provesAJob)
{
  Client machine;
  const Response answer =
      machine.checkGcode("%\nG21 G90 ; millimetres\nG0 X0 Y0 Z0\nG1 X100 F6000\nG2 X0 Y100 I-100\nM2\n");
  EXPECT_EQ(Response::INSIDE, answer.verdict) << answer.message;
  EXPECT_EQ(6, answer.lines);
  EXPECT_EQ(3, answer.moves + answer.unknown_moves);
  EXPECT_EQ(3, answer.first_unknown);
  EXPECT_EQ(0U, answer.offences.size());
  EXPECT_NE(std::string::npos, answer.message.find("Proved: every point of the path is in the set.")) << answer.message;
  EXPECT_LE(answer.motion.joints[0].lower, answer.motion.joints[0].upper);
  for (const auto& speed : answer.motion.joint_speeds)
    EXPECT_LE(speed, 1.2);
}

TEST(CheckGcode, listsEachLineThatOffends)
{
  Client machine;
  const std::string job = "G1 X0 Y0 Z0 F600\nX900 Y900\nX0 Y0\nX100\nX100000\n";
  const Response answer = machine.checkGcode(job);
  EXPECT_EQ(Response::OUTSIDE, answer.verdict) << answer.message;
  EXPECT_EQ(3, answer.outside) << "there, back, and away";
  ASSERT_EQ(3U, answer.offences.size());
  EXPECT_EQ(2, answer.offences[0].line);
  EXPECT_EQ(3, answer.offences[1].line);
  EXPECT_EQ(5, answer.offences[2].line);
  EXPECT_EQ(0.0, answer.offences[1].good_until);
  EXPECT_NEAR(answer.offences[0].point.x, answer.offences[0].point.y, 1e-9);
  EXPECT_NE("", answer.offences[0].reason);
  EXPECT_NE(std::string::npos, answer.message.find("gcode:2")) << answer.message;
  const Response few = machine.checkGcode(job, with::most_listed(1));
  EXPECT_EQ(1U, few.offences.size());
  EXPECT_EQ(3, few.outside);
}

TEST(CheckGcode, holdsTheJointsAtTheFeed)
{
  Client machine;
  const auto at = [&machine](double feed, const auto&... fields) {
    return machine.checkGcode("G1 X0 Y0 Z0 F" + std::to_string(feed) + "\nX100\n", fields...);
  };
  EXPECT_EQ(Response::INSIDE, at(60000.0).verdict);  // 1 m/s of the 1.2 m/s that the motor has
  const Response fast = at(90000.0);
  EXPECT_EQ(Response::OUTSIDE, fast.verdict) << fast.message;
  ASSERT_EQ(1U, fast.offences.size());
  EXPECT_EQ(BindingLimit::JOINT_SPEED, fast.offences[0].limit.kind);
  EXPECT_NEAR(1.5, fast.offences[0].tool_speed, 1e-12);
  EXPECT_EQ(Response::INSIDE, at(90000.0, with::joint_speeds_off()).verdict);
  EXPECT_EQ(Response::INSIDE, at(90000.0, with::joint_speed_max({ 2.0 })).verdict);
  EXPECT_EQ(Response::OUTSIDE, at(60000.0, with::joint_acceleration_max({ 1e-6 })).verdict);
}

TEST(CheckGcode, takesWhatTheJobDoesNotSay)
{
  Client machine;
  const std::string job = "G55 G91 G0 X100\n";
  EXPECT_EQ(Response::INSIDE, machine.checkGcode(job, with::tool_at({ 0, 0, 0 })).verdict);
  EXPECT_EQ(Response::OUTSIDE, machine.checkGcode(job, with::tool_at({ 5, 0, 0 })).verdict);
  EXPECT_EQ(1, machine.checkGcode(job, with::tool_at({ 0, 0, 0 })).moves_without_feed);
  EXPECT_EQ(Response::OUTSIDE, machine.checkGcode(job, with::tool_at({ 0, 0, 0 }), with::rapid_feed(1.5)).verdict);
  const std::string second = "G55 G90 G1 F600 X0 Y0 Z0\nX100\n";
  EXPECT_EQ(Response::INSIDE, machine.checkGcode(second).verdict);
  EXPECT_EQ(Response::OUTSIDE, machine.checkGcode(second, with::work_offsets({ { 0, 0, 0 }, { 5, 0, 0 } })).verdict);
  EXPECT_EQ(Response::INSIDE, machine.checkGcode(second, with::work_offsets({ { 5, 0, 0 } })).verdict) << "of G54";
  EXPECT_EQ(Response::OUTSIDE, machine.checkGcode(second, with::origin({ 0, 5, 0 })).verdict);
  EXPECT_EQ(Response::OUTSIDE, machine.checkGcode(second, with::psi_max(1.0001)).verdict);
}

TEST(CheckGcode, refusesLinesByTheirNumbers)
{
  const auto job = [](const std::string& text) { return [text](Client& machine) { machine.checkGcode(text); }; };
  expectRefused(job("G1 X0 Y0 Z0 F600\nG81 X1\nX5 Q\n"), "gcode:2: .*\ngcode:3: ");
  expectRefused(job(""), "gcode: nothing can be checked.*give tool_at");
  expectRefused(job("G91 G1 F600 X1\n"), "gcode: nothing can be checked.*give tool_at");
  const auto with = [](const auto&... fields) {
    return [=](Client& machine) { machine.checkGcode("G1 X0 Y0 Z0 F600\nX1\n", fields...); };
  };
  expectRefused(with(with::most_listed(10001)), "most_listed = 10001 must be from 1 to 10000");
  expectRefused(with(with::rapid_feed(-1.0)), "rapid_feed = -1 m/s must be from 1e-9");
  expectRefused(with(with::origin({ 0, 2000, 0 })), "origin = \\(0, 2000, 0\\) m must be within 1000 m");
  expectRefused(with(with::work_offsets(std::vector<Triple>(10))), "work_offsets has 10 entries, at most 9");
}

TEST(ExportLimits, writesWhatIsProved)
{
  Client machine;
  const auto answer = machine.exportLimits("linuxcnc", { 0.1, 0.1, 0.1 }, boxOf(0.3));
  ASSERT_EQ(answer.keys.size(), answer.values.size());
  EXPECT_EQ(6U, answer.keys.size());
  for (const double value : answer.values)
    EXPECT_LT(std::min(std::abs(value + 50.0), std::abs(value - 250.0)), 0.01) << answer.text;
  EXPECT_NE(std::string::npos, answer.message.find("Proved: every point of the box is")) << answer.message;
  ExportTask task;
  task.format = "linuxcnc";
  task.region = { makeSolid(SolidKind::BOX, { 0.3, 0.3, 0.3 }), { 0.1, 0.1, 0.1 } };
  const std::string text = exportLimits(PointEvaluator(orthoglide(), Criterion()), task).limits.text;
  const auto limits = [](const std::string& all) { return all.substr(all.find("\n[")); };
  EXPECT_EQ(limits(text), limits(answer.text));
}

TEST(ExportLimits, refusesWhatIsNotProvedOrHeld)
{
  const auto box = [](const std::string& format, double side) {
    return [=](Client& machine) { machine.exportLimits(format, { 0.1, 0.1, 0.1 }, boxOf(side)); };
  };
  expectRefused(box("linuxcnc", 3.0), "nothing is written, as the region is outside: Proved: ");
  expectRefused(box("klipper", 0.1), "a box cannot be held; give a cylinder, type = CYLINDER");
  expectRefused(box("grbl", 0.1), "format = 'grbl' must be one of .*klipper");
  shape_msgs::SolidPrimitive cylinder;
  cylinder.type = shape_msgs::SolidPrimitive::CYLINDER;
  cylinder.dimensions = { 0.1, 0.1 };
  expectRefused(
      [&](Client& machine) {
        machine.exportLimits("klipper", { 0, 0, 0.1 }, cylinder);
      },
      "joint 'rail_x' is not along z");
  expectRefused(
      [&](Client& machine) {
        machine.exportLimits("linuxcnc", { 0, 0, 0.1 }, cylinder);
      },
      "a cylinder cannot be held; give a box, type = BOX");
}
}  // namespace test
}  // namespace pkm_workspace
