// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/urdf_io/urdf_writer.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <sstream>

#include "pkm_workspace/machine/catalogue.h"
#include "pkm_workspace/urdf_io/urdf_reader.h"
#include "support/expect_throw.h"
#include "support/machines.h"
#include "urdf_io/expect_machine.h"

namespace pkm_workspace
{
namespace test
{
namespace
{
std::string fileText(const std::string& name)
{
  std::ifstream file(PKM_WORKSPACE_SOURCE_DIR "/urdf/" + name);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

std::string withoutComment(const std::string& text)
{
  const std::size_t begin = text.find("<!--");
  return begin == std::string::npos ? text : text.substr(0, begin) + text.substr(text.find("-->") + 4);
}

Machine driven(const Machine& machine, const Eigen::Vector3d& speeds, const Eigen::Vector3d& efforts)
{
  Machine::Legs legs = machine.legs();
  for (std::size_t i = 0; i < 3; ++i)
  {
    legs[i].speed = speeds[static_cast<Eigen::Index>(i)];
    legs[i].effort = efforts[static_cast<Eigen::Index>(i)];
  }
  return { machine.name(), legs, machine.zero() };
}

Machine driven(const Machine& machine, double speed, double effort)
{
  return driven(machine, Eigen::Vector3d::Constant(speed), Eigen::Vector3d::Constant(effort));
}

/// As no drive scale can be written.
std::vector<Machine> written(std::vector<Machine> machines)
{
  for (Machine& machine : machines)
  {
    Machine::Legs legs = machine.legs();
    for (Leg& leg : legs)
      if (auto* const crank = std::get_if<Crank>(&leg.kind))
        crank->drive_scale = 0.0;
    machine = { machine.name(), legs, machine.zero() };
  }
  return machines;
}

bool isWithinLimits(const Machine& machine, const Eigen::Vector3d& joints)
{
  return machine.leg(0).limits.contains(joints[0]) && machine.leg(1).limits.contains(joints[1]) &&
         machine.leg(2).limits.contains(joints[2]);
}

Machine readBack(const Machine& machine)
{
  return readUrdf(writeUrdf(machine)).machine;
}
}  // namespace

/// But for a comment on where the limits of the drives are from.
TEST(UrdfWriter, writesTheFilesOfThePackage)
{
  EXPECT_EQ(writeUrdf(driven(orthoglide(), 1.2, 280.0)), withoutComment(fileText("orthoglide.urdf")));
  EXPECT_EQ(writeUrdf(driven(uranesx(), 1.6, 2000.0)), withoutComment(fileText("uranesx.urdf")));
  EXPECT_EQ(writeUrdf(driven(orthoglidePrototype(), 1.2, 280.0)),
            withoutComment(fileText("orthoglide_prototype.urdf")));
  DeltaDimensions dimensions;
  dimensions.limits = { -0.6, 1.5 };
  EXPECT_EQ(writeUrdf(driven(delta(dimensions), 10.0, 200.0)), withoutComment(fileText("delta.urdf")));
  EXPECT_EQ(writeUrdf(driven(tripod(), 0.5, 1500.0)), withoutComment(fileText("tripod.urdf")));
  EXPECT_EQ(writeUrdf(driven(mixedLegs(), { 1.0, 0.5, 5.0 }, { 300.0, 500.0, 150.0 })),
            withoutComment(fileText("mixed_legs.urdf")));
}

TEST(UrdfWriter, writesWhatIsKnownOfDrivesAndNothingElse)
{
  const Machine unknown = readBack(orthoglide());
  for (const Leg& leg : unknown.legs())
  {
    EXPECT_EQ(INF, leg.speed);
    EXPECT_EQ(INF, leg.effort);
  }
  const Machine back = readBack(driven(uranesx(), 0.1, 1.0 / 3.0));
  for (const Leg& leg : back.legs())
  {
    EXPECT_EQ(0.1, leg.speed);
    EXPECT_EQ(1.0 / 3.0, leg.effort);
  }
  MachineDescription described;
  for (std::size_t i = 0; i < 3; ++i)
  {
    LegDescription& leg = described.legs[i];
    leg.joint = "rail_" + std::to_string(i);
    leg.angle = 2.0 * M_PI / 3.0 * static_cast<double>(i);
    leg.radius = 0.1;
    leg.length = 0.27;
    leg.height = 0.3;
    leg.upper = 0.2;
  }
  described.legs[1].speed = 0.5;
  const Machine read = readUrdf(writeUrdf(described)).machine;
  EXPECT_EQ(INF, read.leg(0).speed);
  EXPECT_EQ(0.5, read.leg(1).speed);
  EXPECT_EQ(INF, read.leg(1).effort);
}

TEST(UrdfWriter, theFilesOfThePackageAreReadWithoutWarning)
{
  for (const char* const name : { "orthoglide", "uranesx", "orthoglide_prototype", "delta", "tripod", "mixed_legs" })
  {
    const UrdfMachine read = readUrdfFile(PKM_WORKSPACE_SOURCE_DIR "/urdf/" + std::string(name) + ".urdf");
    EXPECT_EQ(read.machine.name(), name);
    EXPECT_TRUE(read.warnings.empty());
  }
}

TEST(UrdfWriter, thePrototypeHasTheTravelOfTheMachineInNantes)
{
  const Machine back = readBack(orthoglidePrototype());
  for (const Leg& leg : back.legs())
    EXPECT_NEAR(leg.limits.width(), 0.257, 0.0005);
}

TEST(UrdfWriter, theOrthoglideReadsBackBitForBit)
{
  for (const double length : { 1.0, 0.31058, 310.58, 1000.0, 1e-3, 1.0 / 3.0 })
  {
    const Machine machine = orthoglide(length);
    const Machine back = readBack(machine);
    expectSameGeometry(machine, back);
    EXPECT_EQ(back.zero(), machine.zero());
  }
}

/// Where all directions are along axes. The middle of its limits is what a crank's angles are counted from.
TEST(UrdfWriter, oneLegOfEachKindReadsBackBitForBit)
{
  const Machine back = readBack(mixedLegs());
  expectSameGeometry(mixedLegs(), back);
  EXPECT_EQ(back.geometryHash(), mixedLegs().geometryHash());
}

TEST(UrdfWriter, everyMachineReadsBackToEnclosuresThatOverlap)
{
  std::vector<Machine> machines = everyKind();
  for (unsigned seed = 10; seed < 60; ++seed)
  {
    machines.push_back(crookedMix(seed));
    machines.push_back(crooked(seed, std::pow(10.0, static_cast<int>(seed % 7) - 3)));
    machines.push_back(crooked(seed, 0.7, Eigen::Vector3d(1e4, -300.0, 0.1 * seed)));
    machines.push_back(uranesx(Interval(0.4 + 0.01 * seed), Interval(0.1), 1.0 + 0.03 * seed));
  }
  for (const Machine& machine : written(machines))
  {
    SCOPED_TRACE(machine.name() + " " + machine.geometryHash());
    const Machine back = readBack(machine);
    expectOverlap(machine, back);
    EXPECT_EQ(back.hasParallelRails(), machine.hasParallelRails());
    EXPECT_LE(widest(back), 1e-15 * machine.scale() + 1e-15);
    for (int i = 0; i < 3; ++i)
      EXPECT_LE(back.leg(i).limits.lower(), back.leg(i).limits.upper());
  }
}

TEST(UrdfWriter, theUranesxReadsBackToItsOwnZeroConfiguration)
{
  const Machine back = readBack(uranesx());
  EXPECT_EQ(back.zero().head<2>(), Eigen::Vector2d::Zero());
  EXPECT_NEAR(back.zero().z(), uranesx().zero().z(), 1e-15);
  EXPECT_TRUE(back.hasParallelRails());
}

TEST(UrdfWriter, readingBackTwiceChangesNothing)
{
  for (const Machine& machine : written(everyKind()))
  {
    const Machine once = readBack(machine);
    expectOverlap(once, readBack(once));
    for (int i = 0; i < 3; ++i)
      EXPECT_EQ(once.leg(i).limits, readBack(once).leg(i).limits);
  }
}

TEST(UrdfWriter, keepsTheLimitsThatAMachineHas)
{
  Machine::Legs legs = orthoglide().legs();
  legs[0].limits = Interval(0.1, 0.7);
  legs[1].limits = Interval(-std::numeric_limits<double>::infinity(), -0.1);
  legs[2].limits = Interval(5.0, std::numeric_limits<double>::infinity());
  const Machine back = readBack(Machine("limited", legs, Eigen::Vector3d::Zero()));
  EXPECT_EQ(back.leg(0).limits, Interval(0.1, 0.7));
  EXPECT_EQ(back.leg(1).limits, Interval(-1.3, -0.1));
  EXPECT_EQ(back.leg(2).limits, Interval(5.0, 5.0));
}

TEST(UrdfWriter, writesCranksWithoutLimitsAsJointsThatTurnAllAround)
{
  const Machine back = readBack(driven(delta(), 10.0, 200.0));
  EXPECT_FALSE(back.hasJointLimits());
  EXPECT_EQ(back.leg(1).speed, 10.0);
  EXPECT_EQ(back.leg(1).effort, 200.0);
  EXPECT_EQ(readBack(delta()).leg(1).speed, INF);
}

TEST(UrdfWriter, writesLimitsForStrutsThatHaveNone)
{
  TripodDimensions dimensions;
  dimensions.limits = Interval::entire();
  const Machine back = readBack(tripod(dimensions));
  for (const Leg& leg : back.legs())
    EXPECT_EQ(leg.limits, Interval(-0.65, 0.8));
}

TEST(UrdfWriter, refusesWhatNoUrdfSays)
{
  expectThrow<std::invalid_argument>([] { writeUrdf(crookedMix(4)); },
                                     "leg 3 counts a turn of its crank as 0.6 m, and no URDF says so; leave the drive");
}

TEST(UrdfWriter, choosesLimitsThatNoReachablePointPasses)
{
  for (const Machine& machine : written(everyKind()))
  {
    if (machine.hasParallelRails() || std::holds_alternative<TelescopicStrut>(machine.leg(0).kind))
      continue;
    const Machine back = readBack(machine);
    const double step = 0.1 * machine.scale();
    int reached = 0;
    for (int x = -14; x <= 14; ++x)
      for (int y = -14; y <= 14; ++y)
        for (int z = -14; z <= 14; ++z)
        {
          const Eigen::Vector3d p = back.zero() + step * Eigen::Vector3d(x, y, z);
          const auto rho = inverseKinematics(back, p);
          if (!rho || !isWithinLimits(machine, *rho))
            continue;
          EXPECT_TRUE(isWithinLimits(back, *rho)) << machine.name() << " at " << p.transpose();
          ++reached;
        }
    EXPECT_GT(reached, 100) << machine.name();
  }
}

TEST(UrdfWriter, writesAMachineWhereItsJointsAreZero)
{
  // Beyond the parallel singularity the Orthoglide's joints are 0 at -2/3 in each axis.
  const Machine beyond("beyond", orthoglide().legs(), Eigen::Vector3d::Constant(-0.546));
  const Machine back = readBack(beyond);
  EXPECT_EQ(back.aspect(), -orthoglide().aspect());
  EXPECT_TRUE(back.zero().isApprox(Eigen::Vector3d::Constant(-2.0 / 3.0), 1e-12));
  expectOverlap(back, beyond);

  Machine::Legs legs = orthoglide().legs();
  for (Leg& leg : legs)
    slidingStrut(leg).origin = Interval(-3.0) * slidingStrut(leg).axis;
  expectThrow<std::invalid_argument>([&] { writeUrdf(Machine("far", legs, Eigen::Vector3d::Zero())); },
                                     "machine 'far' cannot be written as a URDF: with all joints at 0 no tool point");
}

TEST(UrdfWriter, refusesJointsWithoutNamesOfTheirOwn)
{
  for (const char* const name : { "", "rail_x", "revolute_1" })
  {
    Machine::Legs legs = orthoglide().legs();
    legs[2].joint = name;
    expectThrow<std::invalid_argument>(
        [&] { writeUrdf(Machine("m", legs, Eigen::Vector3d::Zero())); },
        "machine 'm' cannot be written as a URDF: joint name '" + std::string(name) + "'");
  }
}

TEST(UrdfWriter, escapesNames)
{
  Machine::Legs legs = orthoglide().legs();
  legs[0].joint = "a\"<&>'b";
  const Machine back = readBack(Machine("<\"&'>", legs, Eigen::Vector3d::Zero()));
  EXPECT_EQ(back.leg(0).joint, "a\"<&>'b");
  EXPECT_EQ(back.name(), "<\"&'>");
}
}  // namespace test
}  // namespace pkm_workspace
