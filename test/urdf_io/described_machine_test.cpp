// SPDX-License-Identifier: BSD-3-Clause
#include "urdf_io/described.h"

namespace pkm_workspace
{
namespace test
{
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
  refuseSpoilt([](auto& m) { m.legs[1].length = -0.27; },
               "leg 2: strut length = -0.27 m, expected a length from 1e-9 to 1e9 m");
  refuseSpoilt([](auto& m) { m.legs[0].upper = -1.0; }, "leg 1: travel from 0 to -1 m, expected the lower end first");
  refuseSpoilt([](auto& m) { m.legs[2].angle = std::nan(""); }, "leg 3: angle = nan rad, expected a finite angle");
  refuseSpoilt([](auto& m) { m.legs[2].radius = 1e300; },
               "leg 3: radius = 1e.300 m, expected a number from -1e9 to 1e9 m");
  refuseSpoilt([](auto& m) { m.legs[0].working_mode = 0; }, "leg 1: working mode 0, expected -1 or 1");
  refuseSpoilt([](auto& m) { m.tool.x() = INFINITY; }, "tool: a coordinate is not a number");
  refuseSpoilt([](auto& m) { m.legs[0].length = 0.05; }, "with all joints at 0 m the struts do not meet");
}
}  // namespace test
}  // namespace pkm_workspace
