// SPDX-License-Identifier: BSD-3-Clause
// Regions that keep within and out of zones, held against the definitions at their points, and at those of larger ones.
#include <gtest/gtest.h>

#include <cmath>

#include "pkm_workspace/paving/paving.h"
#include "pkm_workspace/paving/set_volume.h"
#include "pkm_workspace/region/largest_region.h"
#include "pkm_workspace/region/path_check.h"
#include "pkm_workspace/region/turned_region.h"
#include "support/cases.h"
#include "support/expect_throw.h"
#include "support/machines.h"
#include "support/oracle.h"

namespace pkm_workspace
{
namespace test
{
namespace
{
using Eigen::Vector3d;

/// How far a point is within all that is asked, in floating point; negative where it is not.
double slackAt(const Machine& machine, const Criterion& criterion, const Vector3d& p)
{
  double least = 1e3;
  for (const Zone& zone : criterion.zones)
    least = std::min(least,
                     static_cast<double>(ZoneOracle(zone, criterion.tool_radius).clearance({ p.x(), p.y(), p.z() })));
  const auto here = jacobians(machine, p);
  if (!here || here->a.determinant() * machine.aspect() <= 0.0)
    return -1.0;
  const Vector3d psi = transmissionFactors(*here);
  return std::min({ least, psi[0] / criterion.psi_min - 1.0, 1.0 - psi[2] / criterion.psi_max });
}

/// Points of a region nearest to corners of zones, its own corners and random ones.
std::vector<Vector3d> startsIn(const Shape& shape, const Vector3d& center, double size, const Criterion& criterion,
                               Random& random)
{
  std::vector<Vector3d> starts;
  for (const Zone& zone : criterion.zones)
    for (int corner = 0; corner < 9; ++corner)  // of a box, or nearly where the surface is; and the center
    {
      const Vector3d half = corner == 8 ? Vector3d::Zero() : Vector3d(0.5 * zone.sides);
      const auto sign = [corner](int bit) { return (corner & bit) != 0 ? 1.0 : -1.0; };
      const Vector3d signs(sign(1), sign(2), sign(4));
      starts.push_back(shape.nearest(zone.pose.translation + half.cwiseProduct(signs), center, size));
    }
  for (const Vector3d& corner : pointsOf(shape.extremePoints(), center, size))
    starts.push_back(corner);
  const double reach = shape.halfExtents().at(size).maxCoeff();
  for (int k = 0; k < 200; ++k)
  {
    const Vector3d way(random.uniform(-reach, reach), random.uniform(-reach, reach), random.uniform(-reach, reach));
    starts.push_back(shape.nearest(center + 3.0 * way, center, size));
  }
  return starts;
}

/// The worst point of a region, downhill from the worst of those.
double worstOf(const Machine& machine, const Criterion& criterion, const Shape& shape, const Vector3d& center,
               double size, Random& random)
{
  std::vector<std::pair<double, Vector3d>> rated;
  for (const Vector3d& start : startsIn(shape, center, size, criterion, random))
    rated.emplace_back(slackAt(machine, criterion, start), start);
  std::sort(rated.begin(), rated.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  double worst = rated.front().first;
  for (std::size_t start = 0; start < 8 && worst > 0.0; ++start)
  {
    auto [least, at] = rated[start];
    double step = 0.3 * shape.halfExtents().at(size).maxCoeff();
    for (int k = 0; least > 0.0 && k < 3000 && step > 1e-9; ++k)
    {
      const Vector3d way(random.uniform(-step, step), random.uniform(-step, step), random.uniform(-step, step));
      const Vector3d next = shape.nearest(at + way, center, size);
      const double value = slackAt(machine, criterion, next);
      step *= value < least ? 1.5 : 0.9;
      if (value < least)
        at = next;
      least = std::min(least, value);
    }
    worst = std::min(worst, least);
  }
  return worst;
}

struct ZoneCase
{
  std::string name;
  Machine machine;
  ShapePtr shape;
  Criterion criterion;
};

Zone zoneAt(Zone::Use use, Zone::Kind kind, const Vector3d& place, double size)
{
  Zone zone;
  zone.use = use;
  zone.kind = kind;
  zone.pose.translation = place;
  zone.sides = Vector3d(1.0, 1.2, 1.5) * size;
  zone.radius = 0.5 * size;
  zone.height = 2.0 * size;
  zone.normal = { 0.1, 0.2, 1.0 };
  return zone;
}

/// Pillars within the region that would be there without them, floors and ceilings, turned boxes, tools.
std::vector<ZoneCase> zoneCases()
{
  using Use = Zone::Use;
  using Kind = Zone::Kind;
  std::vector<ZoneCase> all;
  const auto add = [&all](const std::string& name, const Machine& machine, const ShapePtr& shape,
                          const std::vector<Zone>& zones, double tool_radius = 0.0) {
    all.push_back({ name, machine, shape, {} });
    all.back().criterion.zones = zones;
    all.back().criterion.tool_radius = tool_radius;
  };
  Zone turned = zoneAt(Use::KEEP_OUT, Kind::BOX, { 0.2, 0.1, 0.1 }, 0.15);
  turned.pose.orientation = { 0.1, 0.2, 0.3, std::sqrt(1.0 - 0.14) };
  Zone column = zoneAt(Use::KEEP_OUT, Kind::CYLINDER, { 0.05, 0.02, 0.0 }, 0.1);
  column.height = INF;
  const Zone floor = zoneAt(Use::KEEP_IN, Kind::HALF_SPACE, { 0.0, 0.0, -0.2 }, 1.0);
  const Zone pillar = zoneAt(Use::KEEP_OUT, Kind::BOX, { 0.1, 0.0, 0.1 }, 0.1);
  const Zone ball = zoneAt(Use::KEEP_OUT, Kind::SPHERE, { 0.1, 0.1, 0.1 }, 0.2);
  const Zone room = zoneAt(Use::KEEP_IN, Kind::CYLINDER, { 0.05, 0.05, 0.0 }, 0.8);
  add("cube beside a pillar", orthoglide(), makeCube(), { pillar });
  add("cube beside a turned box, with a tool", orthoglide(), makeCube(), { turned, floor }, 0.03);
  add("sphere in a cylinder, beside a ball", orthoglide(), makeSphere(), { room, ball });
  add("cylinder beside a pillar, above a floor", orthoglide(), makeCylinder(0.6), { pillar, floor }, 0.02);
  add("square around a hole", orthoglide(), makeSquare(), { ball });
  add("square beside a column along the rails", uranesx(), makeSquare(), { column });
  add("cube of a crooked machine", crooked(1), makeCube(), { pillar, ball });
  add("sphere of a crooked machine", crooked(1), makeSphere(), { turned });
  return all;
}

LargestRegion largest(const ZoneCase& zone_case, double accuracy)
{
  RegionQuery query;
  query.shape = zone_case.shape;
  query.criterion = zone_case.criterion;
  query.accuracy = accuracy;
  return findLargestRegion(zone_case.machine, query);
}
}  // namespace

TEST(ZoneRegion, holdsAtItsPointsAndNoneIsLarger)
{
  for (const ZoneCase& each : zoneCases())
  {
    SCOPED_TRACE(each.name + ", seed " + std::to_string(SEED));
    const LargestRegion region = largest(each, 1e-3);
    ASSERT_GT(region.size, 0.1) << region.message;
    ASSERT_LE(region.size_upper_bound - region.size, 1.001e-3) << region.message;
    const Oracle oracle(each.machine, each.criterion);
    Random random(SEED);
    const Vector3d half = each.shape->halfExtents().at(region.size);
    for (int k = 0; k < cases(300) && !testing::Test::HasFailure(); ++k)
    {
      const Vector3d share(random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0));
      const Vector3d wanted = region.center + half.cwiseProduct(k % 4 == 0 ? Vector3d(share.cwiseSign()) : share);
      const auto p = nearestInside(*each.shape, each.shape->nearest(wanted, region.center, region.size), region.center,
                                   region.size);
      ASSERT_TRUE(!p || oracle.isGood(*p)) << p->transpose();
    }
    for (int k = 0; k < cases(40); ++k)
    {
      const double away = each.machine.scale() * std::pow(10.0, random.uniform(-5.0, -0.3));
      const Vector3d way(random.uniform(-away, away), random.uniform(-away, away), random.uniform(-away, away));
      ASSERT_LT(worstOf(each.machine, each.criterion, *each.shape, region.center + way,
                        1.000001 * region.size_upper_bound, random),
                1e-9)
          << (region.center + way).transpose();
    }
  }
}

/// Faces that lie on each other are proved without a box for each of their places, whatever the accuracy.
TEST(ZoneRegion, touchingFacesCostLittle)
{
  ZoneCase pillar = zoneCases().front();
  for (const double accuracy : { 1e-5, 1e-7 })
  {
    const LargestRegion region = largest(pillar, accuracy);
    EXPECT_EQ(region.status, LargestRegion::Status::PROVEN) << region.message;
    EXPECT_LE(region.boxes, 4000) << accuracy;
    EXPECT_LE(region.verification_boxes, 2000) << accuracy;
  }
}

/// Parallel rails slide past a zone that has ends: the largest square is as large as without it, at another height.
TEST(ZoneRegion, liesAtAnotherHeightThanAZoneWithEnds)
{
  Machine::Legs legs = uranesx().legs();
  for (Leg& leg : legs)
    leg.limits = Interval(-1.0, 1.0);
  ZoneCase passed{ "", Machine("limited", legs, uranesx().zero()), makeSquare(), {} };
  passed.criterion.joint_limits = true;
  const LargestRegion free = largest(passed, 1e-2);
  const Zone beam = zoneAt(Zone::Use::KEEP_OUT, Zone::Kind::BOX, free.center, 0.2);
  passed.criterion.zones = { beam };
  const LargestRegion region = largest(passed, 1e-2);
  EXPECT_GT(std::abs(region.center.z() - free.center.z()), 0.14);
  EXPECT_GE(region.size_upper_bound, free.size);
  EXPECT_GE(region.size, free.size_upper_bound - 2.1e-2);
}

/// A region that fills a zone: what it may measure is known.
TEST(ZoneRegion, fillsTheZoneItKeepsWithin)
{
  ZoneCase filled{ "", orthoglide(), makeCube(), {} };
  Zone zone = zoneAt(Zone::Use::KEEP_IN, Zone::Kind::BOX, { 0.01, 0.02, 0.03 }, 0.3);
  zone.sides = { 0.4, 0.3, 0.35 };
  filled.criterion.zones = { zone };
  LargestRegion region = largest(filled, 1e-6);
  EXPECT_LE(region.size, 0.3);
  EXPECT_GE(region.size, 0.3 - 1e-6);
  EXPECT_GE(region.size_upper_bound, 0.3);
  filled.criterion.tool_radius = 0.02;
  region = largest(filled, 1e-6);
  EXPECT_NEAR(region.size, 0.26, 1e-6);
  EXPECT_GE(region.size_upper_bound, 0.26 - 1e-12);
}

TEST(ZoneRegion, volumesOfZonesWithinReachAreKnown)
{
  const Machine machine = orthoglide();
  const auto volume = [&machine](const Zone& zone) {
    PavingQuery query;
    query.criterion.set = Criterion::Set::REACHABLE;
    query.criterion.aspect = Criterion::Aspect::BOTH;
    query.criterion.zones = { zone };
    query.resolution = 0.05;
    return setVolume(machine, pave(machine, query), {}).volume;
  };
  const auto holds = [](const Interval& bracket, double exact, double width) {
    EXPECT_LE(bracket.lower(), exact);
    EXPECT_GE(bracket.upper(), exact);
    EXPECT_LE(bracket.width(), width);
  };
  Zone zone = zoneAt(Zone::Use::KEEP_IN, Zone::Kind::BOX, { 0.01, 0.02, 0.03 }, 0.3);
  holds(volume(zone), 0.3 * 0.36 * 0.45, 1e-3);
  zone.kind = Zone::Kind::SPHERE;
  holds(volume(zone), 4.0 / 3.0 * M_PI * std::pow(0.15, 3.0), 2e-3);
  const double all = 8.0 * (2.0 - std::sqrt(2.0));
  zone.use = Zone::Use::KEEP_OUT;
  const Interval without = volume(zone);
  EXPECT_LE(without.lower(), all - 4.0 / 3.0 * M_PI * std::pow(0.15, 3.0));
  EXPECT_GE(without.upper(), all - 4.0 / 3.0 * M_PI * std::pow(0.15, 3.0));
}

TEST(ZoneRegion, pathsThroughAZoneAreOutside)
{
  const Machine machine = orthoglide();
  Criterion criterion;
  criterion.zones = { zoneAt(Zone::Use::KEEP_OUT, Zone::Kind::SPHERE, { 0.1, 0.1, 0.1 }, 0.1) };
  const auto verdict = [&](const Vector3d& from, const Vector3d& to, double tool_radius) {
    criterion.tool_radius = tool_radius;
    return checkPath(machine, criterion, { PathSegment::line(from, to) }).verdict;
  };
  const Vector3d from(0.1, -0.1, 0.1), to(0.1, 0.3, 0.1), aside(0.06, 0.0, 0.0);
  EXPECT_EQ(verdict(from, to, 0.0), Containment::OUTSIDE);
  EXPECT_EQ(verdict(from + aside, to + aside, 0.0), Containment::INSIDE);
  EXPECT_EQ(verdict(from + aside, to + aside, 0.02), Containment::OUTSIDE);
}
}  // namespace test
}  // namespace pkm_workspace
