// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/machine/machine.h"

#include <gtest/gtest.h>

#include <functional>
#include <locale>
#include <regex>
#include <set>

#include "pkm_workspace/machine/catalogue.h"
#include "pkm_workspace/machine/rails.h"
#include "support/exact_machines.h"
#include "support/expect_throw.h"

namespace pkm_workspace
{
namespace test
{
namespace
{
using Eigen::Vector3d;

/// One change to the unit Orthoglide.
using Change = std::function<void(Machine::Legs&, Vector3d&)>;

Machine changed(const Change& change)
{
  Machine::Legs legs = orthoglide().legs();
  Vector3d zero = Vector3d::Zero();
  change(legs, zero);
  return Machine("made up", legs, zero);
}

struct Defect
{
  const char* name;
  Change change;
  const char* message;
};

const Defect DEFECTS[] = {
  { "UnboundedOrigin", [](auto& legs, auto&) { slidingStrut(legs[1]).origin[2] = Interval(0.0, INF); },
    "leg 'rail_y': rail origin, axis and platform point must be finite" },
  { "UnboundedPlatform", [](auto& legs, auto&) { slidingStrut(legs[2]).platform[0] = Interval::entire(); },
    "leg 'rail_z': .*finite" },
  { "UnboundedAxis", [](auto& legs, auto&) { slidingStrut(legs[0]).axis[0] = Interval(1.0, INF); },
    "leg 'rail_x': .*finite" },
  { "EmptyOrigin", [](auto& legs, auto&) { slidingStrut(legs[0]).origin[0] = Interval::empty(); },
    "leg 'rail_x': .*finite" },
  { "LongAxis", [](auto& legs, auto&) { slidingStrut(legs[0]).axis[0] = 1.5; },
    R"(leg 'rail_x': the axis must have unit length, its squared length is \[2\.25, 2\.25\])" },
  { "ZeroAxis", [](auto& legs, auto&) { slidingStrut(legs[0]).axis[0] = 0.0; },
    R"(unit length, its squared length is \[0, 0\])" },
  { "ZeroLength", [](auto& legs, auto&) { slidingStrut(legs[1]).length = 0.0; },
    R"(leg 'rail_y': strut length \[0, 0\] m must be from 1e-9 m to 1e9 m)" },
  { "TinyLength", [](auto& legs, auto&) { slidingStrut(legs[1]).length = 4.7e-107; },
    "length .*4.7e-107.* from 1e-9 m to 1e9 m" },
  { "HugeLength", [](auto& legs, auto&) { slidingStrut(legs[1]).length = 1e200; },
    "length .*1e.200.* from 1e-9 m to 1e9 m" },
  { "FarOrigin", [](auto& legs, auto&) { slidingStrut(legs[0]).origin[1] = -2e9; },
    "leg 'rail_x': .* must be within 1e9 m" },
  { "FarPlatform", [](auto& legs, auto&) { slidingStrut(legs[2]).platform[1] = 2e9; },
    "leg 'rail_z': .* must be within 1e9 m" },
  { "FarZero", [](auto&, auto& zero) { zero.x() = 2e9; }, "the tool point must be finite, within 1e9 m" },
  { "NegativeLength", [](auto& legs, auto&) { slidingStrut(legs[1]).length = -2.0; }, R"(strut length \[-2, -2\] m)" },
  { "UnboundedLength", [](auto& legs, auto&) { slidingStrut(legs[1]).length = Interval(1.0, INF); },
    R"(strut length \[1, inf\] m)" },
  { "WorkingMode", [](auto& legs, auto&) { slidingStrut(legs[2]).working_mode = 0; },
    R"(leg 'rail_z': working mode 0 must be \+1 or -1)" },
  { "NoLimits", [](auto& legs, auto&) { legs[0].limits = Interval::empty(); },
    "leg 'rail_x': the joint limits leave no value" },
  { "NoZero", [](auto&, auto& zero) { zero.x() = std::nan(""); }, "zero configuration: the tool point must be finite" },
  { "OutOfReach",
    [](auto&, auto& zero) {
      zero = { 0.0, 1.0, 1.0 };
    },
    R"(zero configuration: a strut does not reach the tool point \(0 1 1\) m)" },
  { "Serial",
    [](auto& legs, auto& zero) {
      for (auto& leg : legs)
        slidingStrut(leg).length = 5.0;
      zero = { 0.0, 3.0, 4.0 };
    },
    R"(leg 'rail_x': its strut is across its rail at zero \(serial singularity\))" },
  { "Parallel",
    [](auto& legs, auto& zero) {
      for (auto& leg : legs)
        slidingStrut(leg).length = 3.0;
      zero = { 1.0, 2.0, 2.0 };
    },
    R"(det A = 0 \(parallel singularity\))" },
};

std::ostream& operator<<(std::ostream& stream, const Defect& defect)
{
  return stream << defect.name;
}

class MachineRefusal : public testing::TestWithParam<Defect>
{
};

TEST_P(MachineRefusal, namesTheDefect)
{
  expectThrow<std::invalid_argument>([] { changed(GetParam().change); }, GetParam().message);
  expectThrow<std::invalid_argument>([] { changed(GetParam().change); }, "^machine 'made up' is refused:\n");
}

INSTANTIATE_TEST_SUITE_P(All, MachineRefusal, testing::ValuesIn(DEFECTS),
                         [](const auto& info) { return std::string(info.param.name); });

TEST(MachineRefusal, namesAllDefectsAtOnce)
{
  const Change change = [](Machine::Legs& legs, Vector3d& zero) {
    slidingStrut(legs[0]).axis = { 2.0, 0.0, 0.0 };
    slidingStrut(legs[1]).length = -1.0;
    slidingStrut(legs[2]).working_mode = 3;
    zero.z() = INF;
  };
  expectThrow<std::invalid_argument>(
      [&] { changed(change); },
      "rail_x': the axis[^]*rail_y': strut length[^]*rail_z': working mode 3[^]*zero configuration: the tool point");
}

TEST(MachineHash, isAUuidThatNamesTheGeometryOnly)
{
  const Machine machine = orthoglide();
  EXPECT_TRUE(std::regex_match(machine.geometryHash(),
                               std::regex("[0-9a-f]{8}-[0-9a-f]{4}-5[0-9a-f]{3}-[89ab][0-9a-f]{3}-[0-9a-f]{12}")));
  EXPECT_EQ(machine.geometryHash(), orthoglide().geometryHash());
  const Machine renamed("other name", machine.legs(), Vector3d(0.01, 0.02, 0.03));
  EXPECT_EQ(machine.geometryHash(), renamed.geometryHash()) << "another point of the same aspect";
}

TEST(MachineHash, isTheSameInEveryProcessAndRelease)
{
  // SHA-1 name UUID (RFC 4122) of the geometry's text; recorded results refer to it.
  EXPECT_EQ(orthoglide().geometryHash(), "85bd3fa7-2df2-5308-98eb-f3d7b6103531");
}

TEST(MachineHash, doesNotDependOnTheSignOfZeroOrTheLocale)
{
  const std::string expected = orthoglide().geometryHash();
  const Machine negative = changed([](Machine::Legs& legs, Vector3d&) { slidingStrut(legs[0]).axis[1] = -0.0; });
  EXPECT_EQ(negative.geometryHash(), expected) << "-0 is 0";
  struct Comma : std::numpunct<char>
  {
    char do_decimal_point() const override { return ','; }
    char do_thousands_sep() const override { return '.'; }
    std::string do_grouping() const override { return "\1"; }
  };
  const std::locale before = std::locale::global(std::locale(std::locale::classic(), new Comma));
  const std::string with_comma = orthoglide(1.5).geometryHash();
  std::locale::global(before);
  EXPECT_EQ(with_comma, orthoglide(1.5).geometryHash());
}

TEST(MachineHash, changesWithEveryNumber)
{
  const Change changes[] = {
    [](Machine::Legs&, Vector3d&) {},
    [](Machine::Legs& legs, Vector3d&) { slidingStrut(legs[0]).origin[0] = std::nextafter(-1.0, 0.0); },
    [](Machine::Legs& legs, Vector3d&) {
      slidingStrut(legs[0]).origin[0] = Interval(std::nextafter(-1.0, -2.0), -1.0);
    },
    [](Machine::Legs& legs, Vector3d&) { slidingStrut(legs[2]).platform[1] = 1e-300; },
    [](Machine::Legs& legs, Vector3d&) { slidingStrut(legs[1]).axis[1] = Interval(1.0, std::nextafter(1.0, 2.0)); },
    [](Machine::Legs& legs, Vector3d&) { slidingStrut(legs[1]).length = std::nextafter(1.0, 2.0); },
    [](Machine::Legs& legs, Vector3d&) { legs[1].limits = Interval(-1.0, INF); },
    [](Machine::Legs& legs, Vector3d&) { legs[2].limits = Interval(-1.0, INF); },
    [](Machine::Legs& legs, Vector3d&) { legs[2].limits = Interval(-INF, 1.0); },
    [](Machine::Legs& legs, Vector3d&) { slidingStrut(legs[2]).working_mode = -1; },
    [](Machine::Legs&, Vector3d& zero) { zero = Vector3d::Constant(-0.546); },
    [](Machine::Legs& legs, Vector3d&) { std::swap(legs[0], legs[1]); },
  };
  std::set<std::string> hashes;
  for (const auto& change : changes)
    hashes.insert(changed(change).geometryHash());
  EXPECT_EQ(hashes.size(), std::size(changes));
}

/// An UraneSX whose axes are known to a rounding only.
Machine::Legs uranesxLegsRounded()
{
  Machine::Legs legs = uranesx().legs();
  for (Leg& leg : legs)
    slidingStrut(leg).axis = { 0.0, Interval(0x1p-60, 0x1p-59), Interval(std::nextafter(1.0, 0.0), 1.0) };
  return legs;
}

Machine uranesxWithDirections(const std::array<int, 3>& directions)
{
  Machine::Legs legs = uranesxLegsRounded();
  for (std::size_t i = 0; i < 3; ++i)
  {
    slidingStrut(legs[i]).direction = directions[i];
    if (directions[i] < 0)
    {
      slidingStrut(legs[i]).axis = { 0.0, -slidingStrut(legs[i]).axis[1], -slidingStrut(legs[i]).axis[2] };
      slidingStrut(legs[i]).working_mode = 1;
    }
  }
  return Machine("uranesx", legs, uranesx().zero());
}

TEST(Machine, enclosuresThatAreTheSameAreNoSharedDirection)
{
  const Machine apart = uranesxWithDirections({ 0, 0, 0 });
  EXPECT_FALSE(apart.hasParallelRails());
  EXPECT_FALSE(uranesxWithDirections({ 1, 1, 0 }).hasParallelRails());
  EXPECT_FALSE(uranesxWithDirections({ 1, 1, 3 }).hasParallelRails());
  const Machine together = uranesxWithDirections({ 2, 2, 2 });
  EXPECT_TRUE(together.hasParallelRails());
  EXPECT_NE(together.geometryHash(), apart.geometryHash());
  EXPECT_NE(uranesxWithDirections({ 1, 1, 0 }).geometryHash(), apart.geometryHash());
  EXPECT_EQ(uranesxWithDirections({ 1, 1, 1 }).geometryHash(), together.geometryHash()) << "numbers are only names";
  const Machine against = uranesxWithDirections({ 5, -5, 5 });
  EXPECT_TRUE(against.hasParallelRails());
  EXPECT_EQ(parallelSense(against.leg(0), against.leg(1)), -1);
  EXPECT_EQ(parallelSense(against.leg(0), against.leg(2)), 1);
}

TEST(Machine, legsThatShareADirectionShareWhatIsKnownOfIt)
{
  Machine::Legs legs = uranesxLegsRounded();
  for (Leg& leg : legs)
    slidingStrut(leg).direction = 1;
  slidingStrut(legs[1]).axis[1] = Interval(0x1p-60, 0x1.8p-60);
  slidingStrut(legs[2]).axis[1] = Interval(0x1.4p-60, 0x1p-59);
  const Machine machine("uranesx", legs, uranesx().zero());
  for (const Leg& leg : machine.legs())
    EXPECT_EQ(slidingStrut(leg).axis[1], Interval(0x1.4p-60, 0x1.8p-60));
  slidingStrut(legs[2]).axis[1] = Interval(0x1p-58, 0x1p-57);
  expectThrow<std::invalid_argument>([&] { Machine("uranesx", legs, uranesx().zero()); },
                                     "'rail_1' and 'rail_3' are said to share a direction, but their axes are apart");
}

TEST(Machine, railsAreParallelWhereTheirExactDirectionsAreTheSame)
{
  EXPECT_TRUE(uranesx().hasParallelRails());
  EXPECT_FALSE(orthoglide().hasParallelRails());
  EXPECT_FALSE(crookedMachine("crooked", 3).machine.hasParallelRails());
  const auto withLastAxis = [](const IntervalVector& axis) {
    Machine::Legs legs = uranesx().legs();
    slidingStrut(legs[2]).axis = axis;
    slidingStrut(legs[2]).working_mode = axis[2].certainlyPositive() ? -1 : 1;
    return Machine("uranesx", legs, uranesx().zero());
  };
  EXPECT_TRUE(withLastAxis({ 0.0, 0.0, -1.0 }).hasParallelRails()) << "one rail counts downwards";
  EXPECT_TRUE(withLastAxis({ -0.0, 0.0, 1.0 }).hasParallelRails());
  EXPECT_FALSE(withLastAxis({ 0.0, 0x1p-1074, 1.0 }).hasParallelRails()) << "nearly is not enough";
}

TEST(Machine, knowsItsScaleAndWhetherJointsAreLimited)
{
  EXPECT_FALSE(orthoglide().hasJointLimits());
  EXPECT_TRUE(changed([](auto& legs, auto&) { legs[2].limits = Interval(-INF, 1.0); }).hasJointLimits());
  EXPECT_EQ(orthoglide(0.31058).scale(), 0.31058);
  for (std::size_t i = 0; i < 3; ++i)
    EXPECT_EQ(changed([i](auto& legs, auto&) { slidingStrut(legs[i]).length = Interval(1.25, 1.5); }).scale(), 1.5)
        << i;
}

TEST(Machine, hasNoConfigurationOverASetThatReachesTooFar)
{
  const Machine machine = orthoglide();
  EXPECT_TRUE(
      configurationAt(machine, IntervalVector{ Interval(-0.5, 0.5), Interval(-0.5, 0.5), Interval(-0.5, 0.5) }));
  EXPECT_FALSE(
      configurationAt(machine, IntervalVector{ Interval(-0.8, 0.8), Interval(-0.8, 0.8), Interval(-0.8, 0.8) }));
  EXPECT_FALSE(configurationAt(machine, IntervalVector{ Interval::entire(), 0.0, 0.0 }));
}
}  // namespace
}  // namespace test
}  // namespace pkm_workspace
