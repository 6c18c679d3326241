// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <regex>

#include "pkm_workspace/machine/description.h"
#include "pkm_workspace/urdf_io/urdf_reader.h"
#include "pkm_workspace/urdf_io/urdf_writer.h"
#include "support/expect_throw.h"
#include "support/random.h"

namespace pkm_workspace
{
namespace test
{
namespace
{
using Eigen::Vector3d;

double degrees(double angle)
{
  return angle * M_PI / 180.0;
}

/// The calibrated machine of an integrator, homed at one height.
MachineDescription calibrated()
{
  MachineDescription machine;
  machine.name = "calibrated";
  const double angles[] = { 0.0, 120.4, 239.7 };
  const double lengths[] = { 0.2690, 0.2688, 0.2691 };
  for (std::size_t i = 0; i < 3; ++i)
  {
    LegDescription& leg = machine.legs[i];
    leg.joint = "rail_" + std::to_string(i + 1);
    leg.angle = degrees(angles[i]);
    leg.radius = 0.130;
    leg.height = 0.3;
    leg.platform_joint = { 0.030, 0.0, 0.0 };
    leg.length = lengths[i];
    leg.upper = 0.35;
  }
  machine.tool = { 0.0, 0.0, -0.040 };
  machine.mount = Mount{ { 0.0, 0.0, 0.75 }, { 0.0, 0.0, degrees(15.0) } };
  return machine;
}

/// A machine with nothing straight about it.
MachineDescription crooked(Random& random)
{
  MachineDescription machine = calibrated();
  for (LegDescription& leg : machine.legs)
  {
    const auto some = [&random](double size) { return random.uniform(-size, size); };
    leg.angle += some(0.2);
    leg.foot = { some(0.02), some(0.02) };
    leg.lean = some(0.4);
    leg.side_lean = some(0.4);
    leg.slider_joint = { some(0.02), some(0.02), some(0.02) };
    leg.platform_joint += Vector3d(some(0.01), some(0.01), some(0.01));
    leg.length += some(0.02);
  }
  machine.mount->rpy = { random.uniform(-3.0, 3.0), random.uniform(-1.5, 1.5), random.uniform(-3.0, 3.0) };
  return machine;
}

/// How much the strut of a leg is too long, by the description's own words [m].
double excess(const MachineDescription& machine, std::size_t i, const Vector3d& tool_in_root, double joint)
{
  const LegDescription& leg = machine.legs[i];
  const Vector3d& rpy = machine.mount->rpy;
  const Eigen::Quaterniond stands = Eigen::AngleAxisd(rpy.z(), Vector3d::UnitZ()) *
                                    Eigen::AngleAxisd(rpy.y(), Vector3d::UnitY()) *
                                    Eigen::AngleAxisd(rpy.x(), Vector3d::UnitX());
  const Vector3d tool = stands.conjugate() * (tool_in_root - machine.mount->xyz);
  // Leaning: first outwards, about the leg's y; then sideways, so that the side lean is the angle out of that plane.
  const double radial = std::sin(leg.lean) * std::cos(leg.side_lean);
  const double upright = std::cos(leg.lean) * std::cos(leg.side_lean);
  const Vector3d along(radial, std::sin(leg.side_lean), upright);
  const auto in_machine = [&leg](const Vector3d& v) {
    return Vector3d(Eigen::AngleAxisd(leg.angle, Vector3d::UnitZ()) * v);
  };
  const Vector3d slider = Vector3d(leg.foot.x(), leg.foot.y(), 0.0) +
                          in_machine(Vector3d(leg.radius, 0.0, leg.height) + joint * along + leg.slider_joint);
  const Vector3d platform = tool - machine.tool + in_machine(leg.platform_joint);
  return (platform - slider).norm() - leg.length;
}

/// Joint values of points near the zero configuration against the description.
void expectDescribed(const MachineDescription& description, Random& random, double reach = 0.03)
{
  const UrdfMachine urdf = readUrdf(writeUrdf(description));
  for (int k = 0; k < 20; ++k)
  {
    const auto some = [&random, reach] { return random.uniform(-reach, reach); };
    const Vector3d p = urdf.machine.zero() + Vector3d(some(), some(), some());
    const auto joints = inverseKinematics(urdf.machine, p);
    ASSERT_TRUE(joints);
    for (std::size_t i = 0; i < 3; ++i)
      EXPECT_NEAR(excess(description, i, p, (*joints)[static_cast<Eigen::Index>(i)]), 0.0, 1e-13) << "leg " << i;
  }
}
}  // namespace

TEST(DescribedMachine, isWhatItsUrdfSays)
{
  Random random(SEED);
  SCOPED_TRACE(SEED);
  expectDescribed(calibrated(), random);
  int tried = 0;
  for (int k = 0; k < cases(40); ++k)
  {
    const MachineDescription machine = crooked(random);
    if (!assembledTool(machine, Vector3d::Zero()))
      continue;
    ++tried;
    expectDescribed(machine, random);
  }
  EXPECT_GT(tried, 20);
}

// Sliders on lying rails, as in a Triaglide, and sliders below their platform.
TEST(DescribedMachine, standsOnItsOtherSide)
{
  Random random(SEED);
  SCOPED_TRACE(SEED);
  MachineDescription lying = calibrated();
  for (LegDescription& leg : lying.legs)
    leg.lean = degrees(90.0);
  const double lower = assembledTool(lying, Vector3d::Zero())->z();
  expectDescribed(lying, random, 0.005);
  lying.is_upper = true;
  EXPECT_GT(assembledTool(lying, Vector3d::Zero())->z(), lower + 0.4);
  expectDescribed(lying, random, 0.005);
  MachineDescription below = calibrated();
  for (LegDescription& leg : below.legs)
    leg.working_mode = 1;
  expectDescribed(below, random);
  EXPECT_EQ(slidingStrut(readUrdf(writeUrdf(below)).machine.leg(0)).working_mode, 1);
}

TEST(DescribedMachine, keepsTheStrutsLengthAndParallelRails)
{
  const UrdfMachine urdf = readUrdf(writeUrdf(calibrated()));
  EXPECT_TRUE(urdf.machine.hasParallelRails());
  EXPECT_EQ(urdf.root_link, "world");
  EXPECT_TRUE(urdf.warnings.empty());
  const double lengths[] = { 0.2690, 0.2688, 0.2691 };
  for (int i = 0; i < 3; ++i)
  {
    EXPECT_TRUE(slidingStrut(urdf.machine.leg(i)).length.contains(lengths[i]));
    EXPECT_LT(slidingStrut(urdf.machine.leg(i)).length.width(), 1e-15);
    EXPECT_EQ(urdf.machine.leg(i).limits, Interval(0.0, 0.35));
  }
}

// The zero is solved: what the sliders' equal heights leave open is in the struts' angles, to 1e-9 rad.
TEST(DescribedMachine, standsAssembledAtZero)
{
  const UrdfMachine urdf = readUrdf(writeUrdf(calibrated()));
  const auto joints = inverseKinematics(urdf.machine, urdf.machine.zero());
  ASSERT_TRUE(joints);
  EXPECT_LT(joints->norm(), 1e-8);
}

TEST(DescribedMachine, hasNumbersForPeople)
{
  const std::string text = writeUrdf(calibrated());
  EXPECT_NE(text.find(R"(<origin xyz="0 0 0" rpy="0 0 2.101376419401173"/>)"), std::string::npos) << text;
  EXPECT_NE(text.find(R"(<origin xyz="0.13 0 0.3"/>)"), std::string::npos);
  EXPECT_NE(text.find(R"(<origin xyz="0 0 -0.2688"/>)"), std::string::npos);
  EXPECT_NE(text.find(R"(<origin xyz="0 0 -0.04"/>)"), std::string::npos);
  EXPECT_NE(text.find("<!-- leg 2: turned by 120.4 degrees, rail at radius 0.13 m, strut 0.2688 m -->"),
            std::string::npos);
}

TEST(DescribedMachine, refusesWhatNoMachineHas)
{
  const auto refuse = [](const std::function<void(MachineDescription&)>& spoil, const std::string& pattern) {
    MachineDescription machine = calibrated();
    spoil(machine);
    expectThrow<std::invalid_argument>([&] { writeUrdf(machine); }, pattern);
  };
  refuse([](auto& m) { m.legs[1].length = -0.27; },
         "leg 2: strut length = -0.27 m, expected a length from 1e-9 to 1e9 m");
  refuse([](auto& m) { m.legs[0].upper = -1.0; }, "leg 1: travel from 0 to -1 m, expected the lower end first");
  refuse([](auto& m) { m.legs[2].angle = std::nan(""); }, "leg 3: angle = nan rad, expected a finite angle");
  refuse([](auto& m) { m.legs[2].radius = 1e300; }, "leg 3: radius = 1e.300 m, expected a number from -1e9 to 1e9 m");
  refuse([](auto& m) { m.legs[0].working_mode = 0; }, "leg 1: working mode 0, expected -1 or 1");
  refuse([](auto& m) { m.tool.x() = INFINITY; }, "tool: a coordinate is not a number");
  refuse([](auto& m) { m.legs[0].length = 0.05; }, "with all joints at 0 m the struts do not meet");
}
}  // namespace test
}  // namespace pkm_workspace
