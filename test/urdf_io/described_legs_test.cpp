// SPDX-License-Identifier: BSD-3-Clause
// Measured machines with legs of other kinds than struts on sliders.
#include "urdf_io/described.h"

namespace pkm_workspace
{
namespace test
{
namespace
{
/// A machine with legs of any kind, and nothing straight about it.
MachineDescription crookedLegs(Random& random)
{
  MachineDescription machine = crooked(random);
  for (std::size_t i = 0; i < 3; ++i)
  {
    LegDescription& leg = machine.legs[i];
    const auto some = [&random](double size) { return random.uniform(-size, size); };
    leg.kind = static_cast<LegDescription::Kind>(random.integer(0, 2));
    if (leg.kind == LegDescription::Kind::RAIL)
      continue;
    leg.lean = leg.side_lean = 0.0;
    leg.slider_joint.setZero();
    if (leg.kind == LegDescription::Kind::CRANK)
    {
      leg.radius = 0.05;
      leg.crank = 0.09 + some(0.02);
      leg.axis_lean = some(0.4);
      leg.crank_zero = some(0.3);
      leg.turn = some(1.0) > 0.0 ? 1 : -1;
      leg.lower = -0.7;
      leg.upper = 1.1;
    }
    else if (leg.kind == LegDescription::Kind::TELESCOPE)
      leg.lower = -0.1;
  }
  return machine;
}
}  // namespace

TEST(DescribedLegs, mayHaveLegsOfAnyKind)
{
  Random random(SEED);
  SCOPED_TRACE(SEED);
  int tried = 0;
  for (int k = 0; k < cases(100); ++k)
  {
    MachineDescription machine = crookedLegs(random);
    machine.is_upper = k % 4 == 0;
    if (!assembledTool(machine, Vector3d::Zero()))
      continue;
    ++tried;
    expectDescribed(machine, random, 0.01);
    const UrdfMachine urdf = readUrdf(writeUrdf(machine));
    for (int i = 0; i < 3; ++i)
    {
      const LegDescription& leg = machine.legs[static_cast<std::size_t>(i)];
      EXPECT_EQ(urdf.machine.leg(i).kind.index(), static_cast<std::size_t>(leg.kind));
      EXPECT_EQ(urdf.machine.leg(i).limits, Interval(leg.lower, leg.upper));
    }
  }
  EXPECT_GT(tried, cases(50));
}

// "-1: the forearm hangs below its crank": the elbow is out, and for a platform above it in.
TEST(DescribedLegs, hasItsElbowsWhereTheModeSays)
{
  for (const int turn : { -1, 1 })
  {
    MachineDescription machine = calibrated();
    for (LegDescription& leg : machine.legs)
    {
      leg.kind = LegDescription::Kind::CRANK;
      leg.crank = 0.1;
      leg.radius = 0.05;
      leg.turn = turn;
      leg.lower = -1.0;
    }
    const Vector3d hanging = *assembledTool(machine, Vector3d::Zero());
    EXPECT_LT(hanging.z(), 0.3);
    EXPECT_EQ(std::get<Crank>(readUrdf(writeUrdf(machine)).machine.leg(0).kind).working_mode, turn);
    const Vector3d lower = *assembledTool(machine, Vector3d::Constant(0.1));
    EXPECT_EQ(lower.z() < hanging.z(), turn == 1) << "larger joint values turn down: 1";
    for (LegDescription& leg : machine.legs)
      leg.working_mode = 1;
    EXPECT_GT(assembledTool(machine, Vector3d::Zero())->z(), 0.3);
    EXPECT_EQ(std::get<Crank>(readUrdf(writeUrdf(machine)).machine.leg(0).kind).working_mode, -turn);
  }
}

TEST(DescribedLegs, refuseWhatNoLegHas)
{
  refuseSpoilt(
      [](auto& m) {
        m.legs[1].kind = LegDescription::Kind::CRANK;
        m.legs[1].turn = 0;
        m.legs[1].upper = 7.0;
        m.legs[1].axis_lean = INFINITY;
        m.legs[1].crank_zero = INFINITY;
      },
      "leg 2: crank = 0 m, expected a length from 1e-9 to 1e9 m[^]*leg 2: lean of the crank's axis = inf rad[^]*crank "
      "at "
      "joint value 0 = inf rad, expected a finite angle[^]*sense of the crank's turn = 0, expected -1 or 1[^]*travel "
      "from "
      "0 to 7 rad, expected no more than a whole turn");
  refuseSpoilt(
      [](auto& m) {
        m.legs[0].kind = LegDescription::Kind::TELESCOPE;
        m.legs[0].slider_joint.x() = 0.01;
      },
      "leg 1: it has no rail, expected no lean and no slider joint");
  refuseSpoilt(
      [](auto& m) {
        m.legs[2].kind = LegDescription::Kind::TELESCOPE;
        m.legs[2].lower = -0.2691;
      },
      "leg 3: lower end of the travel = -0.2691 m, expected one that leaves the strut some length");
}
}  // namespace test
}  // namespace pkm_workspace
