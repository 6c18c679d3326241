// SPDX-License-Identifier: BSD-3-Clause
// What proofs cost, as counts that no machine and no load changes. Each limit is the mark, or what was measured and a
// good half more.
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cstdlib>
#include <new>

#include "pkm_workspace/paving/paving.h"
#include "pkm_workspace/region/center_test.h"
#include "pkm_workspace/region/containment.h"
#include "pkm_workspace/region/region_wish.h"
#include "support/machines.h"

namespace
{
std::atomic<long> allocations(0);
}  // namespace

[[gnu::noinline]] void* operator new(std::size_t size)
{
  ++allocations;
  void* const memory = std::malloc(size == 0 ? 1 : size);
  if (memory == nullptr)
    throw std::bad_alloc();
  return memory;
}

[[gnu::noinline]] void operator delete(void* memory) noexcept
{
  std::free(memory);
}

[[gnu::noinline]] void operator delete(void* memory, std::size_t) noexcept
{
  std::free(memory);
}

namespace pkm_workspace
{
namespace
{
LargestRegion solveFor(const Machine& machine, const ShapePtr& shape, double accuracy)
{
  RegionQuery query;
  query.shape = shape;
  query.accuracy = accuracy;
  const LargestRegion region = findLargestRegion(machine, query);
  EXPECT_EQ(region.status, LargestRegion::Status::PROVEN) << region.message;
  return region;
}
}  // namespace

TEST(SearchCost, aCubeThatNearlyTouchesTheBound)
{
  const BoxTest test(orthoglide(), Criterion());
  const auto proof = checkContainment(test, *makeCube(), Eigen::Vector3d::Constant(0.086273015), 0.6439);
  EXPECT_EQ(proof.verdict, Containment::INSIDE);
  EXPECT_LE(proof.boxes, 100);
}

TEST(SearchCost, growsHardlyWithTheAccuracy)
{
  const LargestRegion coarse = solveFor(orthoglide(), makeCube(), 1e-3);
  EXPECT_LE(coarse.boxes, 400);
  EXPECT_LE(coarse.verification_boxes, 400);
  const LargestRegion fine = solveFor(orthoglide(), makeCube(), 1e-7);
  EXPECT_LE(fine.boxes, coarse.boxes + coarse.boxes / 2);
  EXPECT_LE(fine.verification_boxes, 400);
  const LargestRegion square = solveFor(uranesx(), makeSquare(), 1e-6);
  EXPECT_LE(square.boxes, 150);
  EXPECT_LE(square.verification_boxes, 300);
}

// The largest cube touches the zone with the middle of a face, or with an edge.
TEST(SearchCost, zonesCostLittleMore)
{
  for (const Zone::Kind kind : { Zone::Kind::CYLINDER, Zone::Kind::SPHERE, Zone::Kind::BOX })
    for (const double beside : { 0.0, 0.2 })
    {
      Zone zone;
      zone.kind = kind;
      zone.pose.translation = { beside, beside, 0.0 };
      zone.sides = Eigen::Vector3d::Constant(0.1);
      zone.radius = 0.05;
      zone.height = 1.0;
      RegionQuery query;
      query.shape = makeCube();
      query.accuracy = 1e-3;
      query.criterion.zones = { zone };
      const LargestRegion region = findLargestRegion(orthoglide(), query);
      EXPECT_EQ(region.status, LargestRegion::Status::PROVEN) << describe(zone) << region.message;
      EXPECT_LE(region.boxes, 1100) << describe(zone);
      EXPECT_LE(region.verification_boxes, 1000) << describe(zone);
    }
}

// The square's inside nearly touches the bound, from one side and from the other.
TEST(SearchCost, aSpotWithinTheSquare)
{
  const LargestRegion clear = solveFor(uranesx(Interval(0.3850), Interval(0.0)), makeSquare(), 1e-4);
  EXPECT_LE(clear.boxes, 150);
  EXPECT_LE(clear.verification_boxes, 3000);
  const LargestRegion bad = solveFor(uranesx(Interval(0.3848), Interval(0.0)), makeSquare(), 1e-4);
  EXPECT_LE(bad.boxes, 700);
  EXPECT_LE(bad.verification_boxes, 15000);
}

// The condition number is near to its bound all along a curve on the sphere, or the sphere next to that on which the
// struts are one: proofs take many parts, and a bad point is hardly worse than its neighbours.
TEST(SearchCost, spheresThatNearlyTouchAllAlongACurve)
{
  Criterion criterion;
  criterion.set = Criterion::Set::REACHABLE;
  criterion.kappa_max = 20.0;
  const auto proof =
      checkContainment(BoxTest(orthoglide(), criterion), *makeSphere(), Eigen::Vector3d::Constant(0.0757), 0.8018);
  EXPECT_EQ(proof.verdict, Containment::OUTSIDE);
  EXPECT_LE(proof.boxes, 2000);
  for (const double kappa_max : { 20.0, 0.0 })
  {
    RegionQuery query;
    query.shape = makeSphere();
    query.accuracy = 1e-3;
    query.criterion = criterion;
    query.criterion.kappa_max = kappa_max;
    query.budget.max_boxes = 1000;
    const LargestRegion sphere = findLargestRegion(orthoglide(), query);
    EXPECT_EQ(sphere.status, LargestRegion::Status::PROVEN) << kappa_max << ": " << sphere.message;
    EXPECT_LE(sphere.verification_boxes, 600000) << kappa_max;
  }
}

// Nothing but joint values changes along parallel rails: a cylinder costs what a disc does, with limits and without.
TEST(SearchCost, cylindersAlongParallelRails)
{
  Machine::Legs legs = uranesx().legs();
  for (Leg& leg : legs)
    leg.limits = Interval(-0.4, 0.4);
  for (const Machine& machine : { uranesx(), Machine("limited", legs, uranesx().zero()) })
    for (const RatioRange& range : { RatioRange{ 0.5, 0.5 }, RatioRange{ 0.5, 0.8 } })
    {
      RegionQuery query;
      setShape({ "cylinder", std::nullopt, range }, query);
      query.accuracy = 1e-3;
      query.criterion.joint_limits = true;
      query.budget.max_boxes = 4000;
      const LargestRegion cylinder = findLargestRegion(machine, query);
      EXPECT_EQ(cylinder.status, LargestRegion::Status::PROVEN)
          << machine.name() << ", " << range.upper << ": " << cylinder.message;
      EXPECT_LE(cylinder.verification_boxes, range.upper > 0.5 ? 150000 : 20000) << machine.name();
    }
}

// Limits that the reach of the struts implies, as a URDF has to have some.
TEST(SearchCost, limitsThatBindNothing)
{
  Machine::Legs legs = orthoglide().legs();
  for (Leg& leg : legs)
    leg.limits = Interval(-1.3, 2.3);
  const Machine machine("with wide limits", legs, Eigen::Vector3d::Zero());
  for (const ShapePtr& shape : { makeCube(), makeSphere() })
  {
    RegionQuery query;
    query.shape = shape;
    const LargestRegion without = findLargestRegion(machine, query);
    query.criterion.joint_limits = true;
    const LargestRegion with = findLargestRegion(machine, query);
    EXPECT_EQ(with.boxes, without.boxes);
    EXPECT_EQ(with.verification_boxes, without.verification_boxes);
    EXPECT_EQ(with.size, without.size);
    EXPECT_EQ(with.size_upper_bound, without.size_upper_bound);
  }
  PavingQuery query;
  query.resolution = 0.05;
  const Paving without = pave(machine, query);
  query.criterion.joint_limits = true;
  const Paving with = pave(machine, query);
  EXPECT_EQ(with.boxes, without.boxes);
  EXPECT_EQ(with.box.lower, without.box.lower);
  EXPECT_EQ(with.box.upper, without.box.upper);
}

// Limits of parallel rails: those that leave every place enough travel cost nothing, those that bind little.
TEST(SearchCost, limitsOfParallelRails)
{
  for (const ShapePtr& shape : { makeSquare(), makeDisc() })
  {
    const LargestRegion free = solveFor(uranesx(), shape, 1e-3);
    for (const double limit : { 1.0, 0.4, 0.2 })
    {
      Machine::Legs legs = uranesx().legs();
      for (Leg& leg : legs)
        leg.limits = Interval(-limit, limit);
      RegionQuery query;
      query.shape = shape;
      query.criterion.joint_limits = true;
      const LargestRegion limited = findLargestRegion(Machine("limited", legs, uranesx().zero()), query);
      EXPECT_EQ(limited.status, LargestRegion::Status::PROVEN) << shape->name() << ", " << limit;
      EXPECT_LE(limited.boxes, limit == 1.0 ? free.boxes : 2 * free.boxes) << shape->name() << ", " << limit;
    }
  }
}

TEST(SearchCost, machinesWithoutSymmetry)
{
  std::vector<std::int64_t> boxes;
  for (unsigned seed = 1; seed <= 20; ++seed)
  {
    const LargestRegion region = solveFor(test::crooked(seed), makeCube(), 1e-4);
    boxes.push_back(region.boxes);
    EXPECT_LE(region.verification_boxes, 7000) << "seed " << seed;
  }
  std::sort(boxes.begin(), boxes.end());
  EXPECT_LE(boxes[10], 800);
  EXPECT_LE(boxes.back(), 1700);
}

// Cranks, struts of variable length, and one of each kind.
TEST(SearchCost, machinesOfOtherLegs)
{
  struct Cost
  {
    ShapePtr shape;
    std::int64_t boxes;
    std::int64_t verification_boxes;
  };
  Machine::Legs cranks = delta().legs();
  for (Leg& leg : cranks)
    leg.limits = Interval(-0.6, 1.5);
  const std::vector<std::pair<Machine, std::vector<Cost>>> machines = {
    { Machine("delta", cranks, delta().zero()),
      { { makeCube(), 3500, 7000 }, { makeSphere(), 3700, 67000 }, { makeCylinder(0.5), 3300, 43000 } } },
    { tripod(), { { makeCube(), 450, 800 }, { makeSphere(), 350, 18000 }, { makeCylinder(0.5), 400, 13000 } } },
    { test::mixed(), { { makeCube(), 900, 6600 }, { makeSphere(), 500, 40000 }, { makeCylinder(0.5), 800, 17000 } } },
  };
  for (const auto& [machine, costs] : machines)
    for (const Cost& cost : costs)
    {
      RegionQuery query;
      query.shape = cost.shape;
      query.accuracy = 1e-3;
      query.criterion.joint_limits = true;
      const LargestRegion region = findLargestRegion(machine, query);
      EXPECT_EQ(region.status, LargestRegion::Status::PROVEN) << machine.name() << ": " << region.message;
      EXPECT_LE(region.boxes, cost.boxes) << machine.name() << ", " << cost.shape->name();
      EXPECT_LE(region.verification_boxes, cost.verification_boxes) << machine.name() << ", " << cost.shape->name();
    }
}

TEST(SearchCost, pavingOfTheOrthoglide)
{
  PavingQuery query;
  query.box = Box{ Eigen::Vector3d::Constant(-1.0), Eigen::Vector3d::Constant(1.0) };
  query.resolution = 0.01;
  const Paving paving = pave(orthoglide(), query);
  EXPECT_GE(paving.volume_inside.lower(), 1.589);
  EXPECT_LE(paving.volume_boundary.upper(), 0.09);
  EXPECT_LE(paving.boxes, 700000);
  const auto leaves = paving.tree.count(CellState::INSIDE) + paving.tree.count(CellState::OUTSIDE) +
                      paving.tree.count(CellState::BOUNDARY);
  EXPECT_LE(static_cast<std::int64_t>(paving.tree.bytes()), 16 * leaves);
}

TEST(SearchCost, looksAtCentersAllocateNothing)
{
  const BoxTest test(orthoglide(), Criterion());
  const ShapePtr cube = makeCube();
  WitnessPoints witnesses(*cube, test.zonesToKeepOut());
  witnesses.learn(Eigen::Vector3d::Zero(), 0.7, Eigen::Vector3d(0.3, 0.3, 0.3));
  CenterTest center_test(test, *cube, witnesses);
  const Box centers{ Eigen::Vector3d::Constant(0.05), Eigen::Vector3d::Constant(0.12) };
  const auto first = center_test.excludes(centers, 0.645);
  const long before = allocations;
  for (const double size : { 0.645, 0.66, 0.7, 0.645 })
    center_test.excludes(centers, size);
  EXPECT_EQ(allocations, before);
  EXPECT_EQ(center_test.excludes(centers, 0.645), first);
}
}  // namespace pkm_workspace
