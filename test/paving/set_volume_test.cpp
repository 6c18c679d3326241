// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/paving/set_volume.h"

#include <gtest/gtest.h>

#include <cmath>

#include "pkm_workspace/dexterity/verdict.h"
#include "support/cases.h"
#include "support/every_criterion.h"
#include "support/expect_throw.h"
#include "support/oracle.h"
#include "support/same_bits.h"

namespace pkm_workspace
{
namespace
{
using Eigen::Vector3d;
using test::SEED;

Paving paved(const Machine& machine, const Criterion& criterion, double resolution, const std::optional<Box>& box = {})
{
  PavingQuery query;
  query.criterion = criterion;
  query.resolution = resolution;
  query.box = box;
  return pave(machine, query);
}

Criterion reachable(Criterion::Aspect aspect)
{
  Criterion criterion;
  criterion.set = Criterion::Set::REACHABLE;
  criterion.aspect = aspect;
  return criterion;
}

SetVolume volumeTo(double accuracy, const Machine& machine, const Paving& paving)
{
  VolumeQuery query;
  query.accuracy = accuracy;
  return setVolume(machine, paving, query);
}

/// By the parts of boxes, none of which is divided.
Interval volumeAt(double resolution, const Machine& machine, const Criterion& criterion)
{
  return volumeTo(1.0, machine, paved(machine, criterion, resolution)).volume;
}

const double TRICYLINDER = 8.0 * (2.0 - std::sqrt(2.0));
}  // namespace

// docs/values.md: 8 (2 - sqrt 2) in both aspects, 4.227 of it in the machine's own.
TEST(SetVolume, reachableSetOfTheOrthoglide)
{
  const Machine machine = orthoglide();
  double width = 1.0;
  for (const double resolution : { 0.1, 0.05, 0.025 })
  {
    const Interval both = volumeAt(resolution, machine, reachable(Criterion::Aspect::BOTH));
    EXPECT_TRUE(both.contains(TRICYLINDER)) << both;
    EXPECT_LT(both.width(), 0.3 * width);
    width = both.width();
  }
  const Paving paving = paved(machine, reachable(Criterion::Aspect::BOTH), 0.1);
  const SetVolume close = volumeTo(1e-4, machine, paving);
  EXPECT_TRUE(close.complete);
  EXPECT_TRUE(close.volume.contains(TRICYLINDER)) << close.volume;
  EXPECT_LE(close.volume.width(), 1e-4 * TRICYLINDER);
  const Interval own = volumeTo(1e-3, machine, paved(machine, reachable(Criterion::Aspect::OWN), 0.1)).volume;
  const Interval other = volumeTo(1e-2, machine, paved(machine, reachable(Criterion::Aspect::OTHER), 0.1)).volume;
  EXPECT_TRUE((own + other).contains(TRICYLINDER));
  EXPECT_TRUE(own.intersects({ 4.226, 4.228 })) << own;
}

// A dense search finds 1.6318 (docs/values.md), good to 0.001.
TEST(SetVolume, dextrousSetOfTheOrthoglide)
{
  const Machine machine = orthoglide();
  const Paving paving = paved(machine, Criterion(), 0.05);
  const SetVolume coarse = volumeTo(1.0, machine, paving);
  EXPECT_LT(coarse.volume.width(), 0.1 * paving.volume_boundary.upper());
  const SetVolume close = volumeTo(5e-4, machine, paving);
  EXPECT_TRUE(close.complete);
  EXPECT_LE(close.volume.width(), 5e-4 * close.volume.upper());
  EXPECT_NEAR(close.volume.mid(), 1.6318, 1e-3);
  EXPECT_GT(close.boxes, coarse.boxes);
}

TEST(SetVolume, zonesWithinReach)
{
  const Machine machine = orthoglide();
  Criterion criterion = reachable(Criterion::Aspect::BOTH);
  Zone zone;
  zone.pose.translation = { 0.01, 0.02, 0.03 };
  zone.pose.orientation = { 0.1, 0.7, -0.3, std::sqrt(1.0 - 0.59) };
  zone.sides = { 0.3, 0.36, 0.45 };
  zone.radius = 0.2;
  zone.height = 0.3;
  const auto expectVolume = [&](Zone::Kind kind, double exact) {
    zone.kind = kind;
    for (const auto use : { Zone::Use::KEEP_IN, Zone::Use::KEEP_OUT })
    {
      zone.use = use;
      criterion.zones = { zone };
      const double expected = use == Zone::Use::KEEP_IN ? exact : TRICYLINDER - exact;
      const SetVolume found = volumeTo(1e-3, machine, paved(machine, criterion, 0.1));
      EXPECT_TRUE(found.volume.contains(expected)) << found.volume << ", exact " << expected;
      EXPECT_TRUE(found.complete);
    }
  };
  expectVolume(Zone::Kind::BOX, 0.3 * 0.36 * 0.45);
  expectVolume(Zone::Kind::SPHERE, 4.0 / 3.0 * M_PI * std::pow(0.2, 3.0));
  expectVolume(Zone::Kind::CYLINDER, M_PI * 0.04 * 0.3);
}

// The share of seeded points that belong to the set by its definition, within five standard deviations.
TEST(SetVolume, agreesWithSeededPointsForEveryCondition)
{
  for (const Machine& machine : { orthoglide(0.31058), test::crooked(1), test::cone(), test::crookedMix(4) })
    for (const test::MachineCase& each : test::everyCondition(machine))
    {
      SCOPED_TRACE(machine.name() + ", " + each.name + ", seed " + std::to_string(SEED));
      const Box space = test::spaceOf(machine);
      const Paving paving = paved(each.machine, each.criterion, 0.1 * machine.scale(), space);
      const Interval volume = volumeTo(0.03, each.machine, paving).volume;
      const test::Oracle oracle(each.machine, each.criterion);
      test::RandomBoxes random(SEED);
      const int points = test::cases(1000);
      int hits = 0;
      for (int k = 0; k < points; ++k)
        hits += oracle.isGood(random.pointIn(space)) ? 1 : 0;
      const double share = (hits + 1.0) / (points + 2.0);
      const double deviation = std::sqrt(share * (1.0 - share) / points);
      EXPECT_TRUE(volume.intersects(space.volume() * Interval(share - 5 * deviation, share + 5 * deviation)))
          << "volume " << volume << ", share " << share;
    }
}

// Half the resolution, a quarter of the width.
TEST(SetVolume, convergesWithTheSquareOfTheResolution)
{
  for (const test::MachineCase& each : test::everyCondition(test::crooked(1)))
  {
    SCOPED_TRACE(each.name);
    // where nothing keeps det A from 0, of order 3/2 next to where a strut lies across its rail
    const Criterion& criterion = each.criterion;
    const bool is_unsettled = criterion.aspect != Criterion::Aspect::BOTH && !criterion.settlesAspect();
    const Interval coarse = volumeAt(0.04, each.machine, criterion);
    const Interval fine = volumeAt(0.02, each.machine, criterion);
    EXPECT_TRUE(coarse.intersects(fine));
    if (coarse.upper() == 0.0)
      continue;
    EXPECT_GT(coarse.width() / fine.width(), is_unsettled ? 2.6 : 3.4) << coarse << ", " << fine;
  }
}

TEST(SetVolume, flatBoxesHaveAnArea)
{
  const Machine machine = uranesx();
  Criterion criterion = reachable(Criterion::Aspect::BOTH);
  Zone zone;
  zone.kind = Zone::Kind::CYLINDER;
  zone.use = Zone::Use::KEEP_IN;
  zone.radius = 0.2;
  zone.height = INF;
  criterion.zones = { zone };
  const double z = machine.zero().z();
  const Paving paving = paved(machine, criterion, 0.1, Box{ { -0.4, -0.4, z }, { 0.4, 0.4, z } });
  const SetVolume disc = volumeTo(1e-5, machine, paving);
  EXPECT_TRUE(disc.volume.contains(M_PI * 0.04)) << disc.volume;
  EXPECT_TRUE(disc.complete);
  for (const Vector3d& point : { Vector3d(0.0, 0.0, z), Vector3d(0.3, 0.0, z), Vector3d(0.2, 0.0, z) })
    EXPECT_EQ(volumeTo(1e-5, machine, paved(machine, criterion, 0.1, Box{ point, point })).volume, Interval(0.0));
}

TEST(SetVolume, limitsEndItWithAnHonestBracket)
{
  const Machine machine = orthoglide();
  const Paving paving = paved(machine, reachable(Criterion::Aspect::BOTH), 0.2);
  VolumeQuery query;
  query.accuracy = 1e-3;
  const SetVolume whole = setVolume(machine, paving, query);
  ASSERT_TRUE(whole.complete);
  std::atomic<bool> stop(true);
  for (int limit = 0; limit < 4; ++limit)
  {
    query.budget = Budget();
    query.budget.max_boxes = limit == 0 ? 5000 : 0;
    query.budget.max_memory = limit == 1 ? 5000000 : limit == 2 ? Budget::LEAST_MEMORY : 0;
    query.budget.stop = limit == 3 ? &stop : nullptr;
    const SetVolume part = setVolume(machine, paving, query);
    EXPECT_FALSE(part.complete) << limit;
    EXPECT_TRUE(part.volume.contains(TRICYLINDER)) << limit << ": " << part.volume;
    EXPECT_LT(part.boxes, whole.boxes) << limit;
  }
  PavingQuery cut;
  cut.criterion = reachable(Criterion::Aspect::BOTH);
  cut.budget.max_boxes = 100;
  const Paving pending = pave(machine, cut);
  ASSERT_FALSE(pending.complete);
  EXPECT_TRUE(volumeTo(1.0, machine, pending).volume.contains(TRICYLINDER));
  EXPECT_TRUE(volumeTo(1e-2, machine, pending).complete);
}

TEST(SetVolume, doesNotDependOnThreads)
{
  const Machine machine = test::crooked(2);
  const Paving paving = paved(machine, Criterion(), 0.1);
  VolumeQuery query;
  query.accuracy = 1e-2;
  query.budget.threads = 1;
  const SetVolume one = setVolume(machine, paving, query);
  query.budget.threads = 3;
  const SetVolume three = setVolume(machine, paving, query);
  EXPECT_EQ(one.volume, three.volume);
  EXPECT_EQ(one.boxes, three.boxes);
}

TEST(SetVolume, refusesAnAccuracyThatIsNone)
{
  const Paving paving = paved(orthoglide(), Criterion(), 1.0);
  for (const double accuracy : { 0.0, -1.0, 2.0, std::nan("") })
    test::expectThrow<std::invalid_argument>([&] { volumeTo(accuracy, orthoglide(), paving); }, "accuracy");
}
}  // namespace pkm_workspace
