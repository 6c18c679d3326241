// SPDX-License-Identifier: BSD-3-Clause
// Zones to keep in and out of, held against the definition (test/support/zones.h).
#include "pkm_workspace/machine/zone.h"

#include <gtest/gtest.h>

#include "pkm_workspace/dexterity/criterion_bytes.h"
#include "pkm_workspace/dexterity/verdict.h"
#include "pkm_workspace/dexterity/workspace_bounds.h"
#include "pkm_workspace/dexterity/zone_forms.h"
#include "pkm_workspace/machine/frame.h"
#include "support/cases.h"
#include "support/machines.h"
#include "support/oracle.h"

namespace pkm_workspace
{
namespace test
{
namespace
{
using Eigen::Vector3d;

Criterion withZones(Random& random, const Machine& machine)
{
  Criterion criterion;
  criterion.set = random.once(3) ? Criterion::Set::DEXTROUS : Criterion::Set::REACHABLE;
  criterion.zones = randomZones(random, spaceOf(machine));
  criterion.tool_radius = random.once(2) ? 0.02 * machine.scale() : 0.0;
  return criterion;
}

ZoneOracle::Vector exactly(const Vector3d& p)
{
  return { p.x(), p.y(), p.z() };
}

/// @param fewest boxes of 1500 that have to be inside, and outside
void expectVerdictsOfTheOracle(const Machine& machine, int fewest)
{
  Random random(SEED);
  RandomBoxes boxes(SEED);
  int inside = 0, outside = 0;
  for (int k = 0; k < cases(1500) && !testing::Test::HasFailure(); ++k)
  {
    const Criterion criterion = withZones(random, machine);
    const BoxTest test(machine, criterion);
    const Oracle oracle(machine, criterion);
    const Box box = boxes.boxIn(spaceOf(machine), machine.scale());
    const BoxVerdict verdict = test.classify(box);
    inside += verdict == BoxVerdict::INSIDE;
    outside += verdict == BoxVerdict::OUTSIDE;
    for (int sample = 0; verdict != BoxVerdict::UNDECIDED && sample < 4; ++sample)
    {
      const Vector3d point = sample == 0 ? box.upper : sample == 1 ? box.lower : boxes.pointIn(box);
      ASSERT_EQ(oracle.isGood(point), verdict == BoxVerdict::INSIDE)
          << machine.name() << ", case " << k << ": " << describe(criterion);
    }
  }
  EXPECT_GT(inside, cases(fewest)) << machine.name();
  EXPECT_GT(outside, cases(fewest)) << machine.name();
}
}  // namespace

TEST(Zones, verdictsHoldAtEveryPointOfTheBox)
{
  for (const Machine& machine : slidingKinds())
    expectVerdictsOfTheOracle(machine, 60);
  for (const Machine& machine : { delta(), mixed(), crookedMix(4) })
    expectVerdictsOfTheOracle(machine, 10);
}

/// A single zone, all else free: boxes are settled but for those at its surface.
TEST(Zones, boxesAwayFromTheSurfaceAreSettled)
{
  const Machine machine = orthoglide();
  Random random(SEED);
  RandomBoxes boxes(SEED);
  const Box space{ Vector3d::Constant(-0.3), Vector3d::Constant(0.3) };
  for (int k = 0; k < cases(2000); ++k)
  {
    Criterion criterion;
    criterion.set = Criterion::Set::REACHABLE;
    criterion.zones = { randomZone(random, space, k % 2 == 0 ? Zone::Use::KEEP_IN : Zone::Use::KEEP_OUT) };
    const Box box = boxes.boxIn(space, 0.1);
    const double radius = 0.5 * (box.upper - box.lower).norm();
    const ZoneOracle oracle(criterion.zones[0], 0.0);
    const auto clearance = static_cast<double>(oracle.clearance(exactly(box.center())));
    const BoxVerdict verdict = BoxTest(machine, criterion).classify(box);
    // the round surfaces' forms are of second order, not exact
    if (std::abs(clearance) > 3.0 * radius)
    {
      EXPECT_EQ(verdict, clearance > 0.0 ? BoxVerdict::INSIDE : BoxVerdict::OUTSIDE)
          << k << ": " << describe(criterion.zones[0]);
    }
  }
}

TEST(Zones, limitsAtAPointEncloseTheClearance)
{
  const Machine machine = crooked(1);
  Random random(SEED);
  RandomBoxes boxes(SEED);
  for (int k = 0; k < cases(300); ++k)
  {
    const Criterion criterion = withZones(random, machine);
    const Vector3d point = boxes.pointIn(spaceOf(machine));
    std::size_t zones = 0;
    for (const Limit& limit : evaluatePoint(machine, criterion, point).limits)
      if (limit.kind == Limit::Kind::KEEP_IN || limit.kind == Limit::Kind::KEEP_OUT)
      {
        const auto exact = Oracle(machine, criterion).valueOf(limit, exactly(point));
        EXPECT_TRUE(limit.value.lower() <= exact && exact <= limit.value.upper()) << describe(criterion);
        EXPECT_LE(limit.value.width(), 1e-12);
        EXPECT_EQ(limit.zone, title(criterion.zones[static_cast<std::size_t>(limit.which)]));
        ++zones;
      }
    EXPECT_EQ(zones, criterion.zones.size());
  }
}

TEST(Zones, pointsWithinAreBadAndNearest)
{
  Random random(SEED);
  RandomBoxes boxes(SEED);
  const Box space{ Vector3d::Constant(-1.0), Vector3d::Constant(1.0) };
  for (int k = 0; k < cases(500); ++k)
  {
    const Zone zone = randomZone(random, space, Zone::Use::KEEP_OUT);
    const double tool_radius = random.once(2) ? 0.05 : 0.0;
    const ZoneToKeepOut to_keep_out = zonesToKeepOut({ zone }, tool_radius).front();
    const ZoneOracle oracle(zone, tool_radius);
    const Vector3d p = boxes.pointIn(space);
    const auto within = pointWithin(to_keep_out, p);
    ASSERT_TRUE(within) << describe(zone);
    EXPECT_LT(oracle.clearance(exactly(*within)), 0) << describe(zone);
    const Vector3d around = pointAround(to_keep_out.numbers, p);
    EXPECT_LE((around - *within).norm(), 1e-10);
    if (oracle.clearance(exactly(p)) > 1e-9)
    {
      EXPECT_GT(oracle.clearance(exactly(around)), 0) << describe(zone);
    }
    for (int other = 0; other < 50; ++other)
    {
      const Vector3d q = boxes.pointIn(space);
      const double least = oracle.clearance(exactly(q)) < 0 ? (*within - p).norm() - 1e-9 : 0.0;
      EXPECT_GE((q - p).norm(), least) << describe(zone);
    }
  }
}

TEST(Zones, boundsHoldAllPointsOfTheSet)
{
  const Machine machine = orthoglide();
  Random random(SEED);
  RandomBoxes boxes(SEED);
  int narrowed = 0;
  for (int k = 0; k < cases(300); ++k)
  {
    Criterion criterion = withZones(random, machine);
    criterion.set = Criterion::Set::REACHABLE;
    const Box bounds = boundsOfSet(machine, criterion);
    Criterion free = criterion;
    free.zones.clear();
    free.tool_radius = 0.0;
    narrowed += !(bounds.upper == boundsOfSet(machine, free).upper);
    const Oracle oracle(machine, criterion);
    for (int sample = 0; sample < 30; ++sample)
    {
      const Vector3d p = boxes.pointIn(spaceOf(machine));
      const bool is_held = (p.array() >= bounds.lower.array()).all() && (p.array() <= bounds.upper.array()).all();
      EXPECT_TRUE(is_held || !oracle.isGood(p)) << describe(criterion);
    }
  }
  EXPECT_GT(narrowed, cases(100));
}

TEST(Zones, ofTheRootAreTheSameSeenFromAnotherFrame)
{
  const Machine machine = orthoglide();
  Random random(SEED);
  RandomBoxes boxes(SEED);
  int settled = 0;
  for (int k = 0; k < cases(300); ++k)
  {
    Criterion criterion = withZones(random, machine);
    for (Zone& zone : criterion.zones)
    {
      zone.in_root = true;
      zone.frame = Pose();
    }
    const Pose root = randomPose(random, { Vector3d::Constant(-2.0), Vector3d::Constant(2.0) });
    const Vector3d p = boxes.pointIn(spaceOf(machine));
    const Vector3d moved = mid(transformed(root, enclose(p)));
    const BoxVerdict here = BoxTest(machine, criterion).classify(p);
    criterion.zones = seenFrom(root, criterion.zones);
    const BoxVerdict there = BoxTest(machineInFrame(machine, root), criterion).classify(moved);
    settled += here != BoxVerdict::UNDECIDED && here == there;
    EXPECT_TRUE(here == there || here == BoxVerdict::UNDECIDED || there == BoxVerdict::UNDECIDED)
        << describe(criterion);
  }
  EXPECT_GT(settled, cases(280));
}

TEST(Zones, bytesHoldThemAndTellThemApart)
{
  Random random(SEED);
  for (int k = 0; k < cases(100); ++k)
  {
    const Criterion criterion = withZones(random, orthoglide());
    ByteWriter writer;
    put(criterion, writer);
    ByteReader reader(writer.bytes(), writer.bytes().size());
    const Criterion read = takeCriterion(reader);
    EXPECT_EQ(reader.left(), 0u);
    EXPECT_TRUE(read == criterion);
    EXPECT_EQ(describe(read), describe(criterion));
    Criterion of_node = criterion;
    for (Zone& zone : of_node.zones)
      zone.in_root = true;
    EXPECT_TRUE(of_node == criterion) << "where they are counts, not who gave them";
    Criterion other = criterion;
    other.zones.back().pose.translation.z() += 1e-9;
    EXPECT_FALSE(other == criterion);
  }
}

TEST(Zones, whatIsWrongIsRefused)
{
  const auto complaints = [](const Zone& zone, double tool_radius) {
    Problems problems;
    validateZones({ zone }, tool_radius, problems);
    return problems;
  };
  Zone box;
  box.sides = { 0.1, 0.2, 0.3 };
  EXPECT_TRUE(complaints(box, 0.2).empty());
  box.use = Zone::Use::KEEP_IN;
  EXPECT_TRUE(complaints(box, 0.04).empty());
  EXPECT_EQ(complaints(box, 0.05).size(), 1u);
  EXPECT_EQ(complaints(box, -0.1).size(), 1u);
  EXPECT_EQ(complaints(box, INF).size(), 1u);
  box.sides.y() = 0.0;
  EXPECT_EQ(complaints(box, 0.0).size(), 1u);
  Zone cylinder;
  cylinder.kind = Zone::Kind::CYLINDER;
  cylinder.radius = 0.1;
  cylinder.height = INF;
  EXPECT_TRUE(complaints(cylinder, 0.0).empty());
  cylinder.radius = std::nan("");
  EXPECT_EQ(complaints(cylinder, 0.0).size(), 1u);
  Zone half_space;
  half_space.kind = Zone::Kind::HALF_SPACE;
  EXPECT_TRUE(complaints(half_space, 0.0).empty());
  half_space.normal.setZero();
  EXPECT_EQ(complaints(half_space, 0.0).size(), 1u);
  half_space.pose.orientation = { 1.0, 1.0, 0.0, 0.0 };
  EXPECT_EQ(complaints(half_space, 0.0).size(), 1u);
  Problems problems;
  requireEffect(0.1, {}, problems);
  validateZones(std::vector<Zone>(MOST_ZONES + 1, cylinder), 0.0, problems);
  EXPECT_EQ(problems.size(), 2u + MOST_ZONES + 1u);
}
}  // namespace test
}  // namespace pkm_workspace
