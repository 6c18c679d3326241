// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/import/zone_file.h"

#include <gtest/gtest.h>

#include "pkm_workspace/machine/zone_keys.h"
#include "support/expect_throw.h"

namespace pkm_workspace
{
namespace
{
constexpr const char* EVERY_KIND = R"(
tool_radius: 0.004
keep_in:
  - {kind: cylinder, center: [0, 0, 0.2], radius: 0.14, height: 0.4}
  - kind: half_space
    name: above the table
    point: [0, 0, 0.01]
    normal: [0, 0, 1]
keep_out:
  - {kind: box, name: column_1, center: [0.13, 0, 0.3], sides: [0.03, 0.04, 0.6], orientation: [0, 0, 0.6, 0.8]}
  - {kind: sphere, center: [0.1, 0, 0], radius: 0.02}
  - {kind: cylinder, center: [0.1, 0.1, 0], radius: 0.02, height: .inf}
)";
}  // namespace

TEST(ZoneFile, holdsEveryKind)
{
  const ZoneFile file = readZoneText(EVERY_KIND, "zones.yaml");
  ASSERT_EQ(file.zones.size(), 5u);
  EXPECT_EQ(file.tool_radius, 0.004);
  EXPECT_EQ(file.zones[0].use, Zone::Use::KEEP_IN);
  EXPECT_EQ(file.zones[0].kind, Zone::Kind::CYLINDER);
  EXPECT_EQ(file.zones[0].height, 0.4);
  EXPECT_EQ(title(file.zones[1]), "half-space 'above the table'");
  EXPECT_EQ(file.zones[1].normal, Eigen::Vector3d::UnitZ());
  EXPECT_EQ(file.zones[2].use, Zone::Use::KEEP_OUT);
  EXPECT_EQ(file.zones[2].sides, Eigen::Vector3d(0.03, 0.04, 0.6));
  EXPECT_EQ(file.zones[2].pose.orientation[2], 0.6);
  EXPECT_EQ(file.zones[3].radius, 0.02);
  EXPECT_EQ(file.zones[4].height, std::numeric_limits<double>::infinity());
  Problems problems;
  validateZones(file.zones, file.tool_radius, problems);
  EXPECT_TRUE(problems.empty());
}

TEST(ZoneFile, whatIsWrongIsToldWithItsLine)
{
  const auto refused = [](const std::string& text, const std::string& part) {
    test::expectThrow<std::invalid_argument>([&] { readZoneText(text, "zones.yaml"); }, part);
  };
  refused("keep_out:\n  - {kind: cube, center: [0, 0, 0]}", "zones.yaml:2: 'cube' is not a kind of zone");
  refused("keep_out:\n  - {kind: box, center: [0, 0, 0]}", "zones.yaml:2: a box needs sides .SX SY SZ.");
  refused("keep_out:\n  - {kind: sphere, center: [0, 0, 0], radius: 1, height: 2}",
          "unknown key 'height' in a sphere; its keys are: kind, name, center, radius");
  refused("keep_out:\n  - {kind: sphere, center: [0, 0], radius: 1}", "center needs 3 numbers .X Y Z., got 2");
  refused("keep_out:\n  - kind: sphere\n    center: [0, 0, zero]\n    radius: 1", "zones.yaml:3: center = 'zero'");
  refused("keep_out:\n  - {kind: sphere, centre: [0, 0, 0], radius: 1}", "unknown key 'centre' in a zone of keep_out");
  refused("keep_off: []", "unknown key 'keep_off' in the file; its keys are: tool_radius, keep_in, keep_out");
  refused("keep_out: {kind: box}", "zones.yaml:1: keep_out must be a list of zones");
  refused("tool_radius: [1, 2]", "tool_radius needs one number");
  refused("keep_out: [", "not valid YAML");
  refused("keep_out:\n  - {kind: sphere, center: [[0, 0, 0]], radius: 1}",
          "zones.yaml:2: center must be .*a list or a map");
  refused("keep_out:\n  - {kind: sphere, center: {x: 0}, radius: 1}", "zones.yaml:2: center must be .* it is a map");
  refused("keep_out:\n  - {kind: 1}\n  - {kind: 2}", "zones.yaml:3");
}

TEST(ZoneKeys, numbersAreReadBackAsTheyWere)
{
  for (const Zone& zone : readZoneText(EVERY_KIND, "zones.yaml").zones)
  {
    const Zone again = readZone(zone.use, ZONE_KINDS[static_cast<std::size_t>(zone.kind)], zone.name, numbersOf(zone));
    EXPECT_EQ(describe(again), describe(zone));
  }
}

TEST(ZoneKeys, messagesNameTheirFields)
{
  const auto refused = [](const std::string& kind, const ZoneNumbers& numbers, const std::string& part) {
    test::expectThrow<std::invalid_argument>(
        [&] { readZone(Zone::Use::KEEP_IN, kind, "", numbers, ZoneNames::FIELDS); }, part);
  };
  refused("sphere", { { "radius", { 1 } } }, "a sphere needs pose.position");
  refused("half_space", { { "point", { 0, 0, 0 } }, { "orientation", { 0, 0, 1, 0 } }, { "normal", { 0, 0, 1 } } },
          "pose.orientation must be 0: a half_space has only name, pose.position, normal");
}

TEST(ZoneKeys, wordsNameWhatIsMissing)
{
  const auto refused = [](const std::vector<std::string>& words, const std::string& part) {
    test::expectThrow<std::invalid_argument>([&] { readZone(Zone::Use::KEEP_IN, words); }, part);
  };
  EXPECT_EQ(readZone(Zone::Use::KEEP_IN, { "cylinder", "0", "0", "0.5", "0.1", "inf" }).radius, 0.1);
  refused({}, "'' is not a kind of zone; these are: box, cylinder, sphere, half_space");
  refused({ "sphere", "0", "0", "0" }, "needs 4 numbers, got 3; give sphere X Y Z RADIUS");
  refused({ "sphere", "0", "0", "0", "1", "2" }, "needs 4 numbers, got 5; give sphere X Y Z RADIUS");
  refused({ "box", "0", "x", "0", "1", "2", "3" }, "'x' is not a number; give box X Y Z SX SY SZ");
}
}  // namespace pkm_workspace
