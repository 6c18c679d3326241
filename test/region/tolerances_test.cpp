// SPDX-License-Identifier: BSD-3-Clause
// The largest region that all machines within tolerances have.
#include <gtest/gtest.h>

#include "pkm_workspace/dexterity/fitting_bounds.h"
#include "pkm_workspace/machine/catalogue.h"
#include "pkm_workspace/region/bad_machine.h"
#include "pkm_workspace/region/containment.h"
#include "pkm_workspace/region/joint_ranges.h"
#include "pkm_workspace/region/largest_region.h"
#include "pkm_workspace/region/tolerable_factor.h"
#include "support/built_machines.h"
#include "support/machines.h"

namespace pkm_workspace
{
namespace test
{
namespace
{
using Eigen::Vector3d;

Machine within(const Machine& machine, const std::vector<std::pair<const char*, double>>& some)
{
  Tolerances tolerances;
  for (const auto& [name, value] : some)
    setTolerance(*toleranceKind(name), { value }, tolerances);
  return withTolerances(machine, tolerances);
}

RegionQuery query(const ShapePtr& shape, double accuracy)
{
  RegionQuery query;
  query.shape = shape;
  query.accuracy = accuracy;
  return query;
}

/// Points of the region on seeded machines, the worst one at some of them too.
void expectGoodOnAll(const Machine& machine, const LargestRegion& region, const Shape& shape,
                     const Criterion& criterion, Random& random)
{
  const Vector3d half = shape.halfExtents().at(region.size);
  for (int k = 0; k < cases(300); ++k)
  {
    Vector3d offset;
    for (int axis = 0; axis < 3; ++axis)
      offset[axis] = half[axis] * (random.once(2) ? random.sign() : random.uniform(-1.0, 1.0));
    const Vector3d point = shape.nearest(region.center + offset, region.center, region.size);
    const Vector3d inner = region.center + (1.0 - 1e-12) * (point - region.center);
    const Deviation at = k % 60 == 0 ? worstDeviation(machine, criterion, inner, random, 2) : randomDeviation(random);
    ASSERT_TRUE(isGood(machine, at, criterion, inner)) << inner.transpose();
  }
}
}  // namespace

// Search values, good to 1e-6.
TEST(ToleratedRegion, orthoglideCube)
{
  const auto robust = [](double t, double accuracy) {
    const Machine machine = within(orthoglide(), { { "tolerance_slider", t }, { "tolerance_length", t } });
    const LargestRegion region = findLargestRegion(machine, query(makeCube(), accuracy));
    EXPECT_EQ(region.status, LargestRegion::Status::PROVEN) << region.message;
    EXPECT_LE(region.size_upper_bound - region.size, accuracy * 1.000001);
    EXPECT_LE(region.boxes, 1500);
    return Interval(region.size, region.size_upper_bound);
  };
  const Interval wide = robust(1e-4, 2e-5);
  EXPECT_LE(wide.lower(), 0.6436538);
  EXPECT_GE(wide.upper(), 0.6436518);
  const Interval narrow = robust(1e-6, 1e-5);
  EXPECT_LE(narrow.lower(), 0.6439486);
  EXPECT_GE(narrow.upper(), 0.6439466);
}

/// Tenths of a millimetre and of a degree, of struts of a metre and of a printer's 0.218 m, to a thousandth of them or
/// two.
TEST(ToleratedRegion, closesForMachinesOfTheWorkshop)
{
  struct Row
  {
    Machine machine;
    ShapePtr shape;
    Criterion criterion;
    double accuracy;  ///< in struts
    std::int64_t most_boxes;
  };
  const std::vector<std::pair<const char*, double>> some = { { "tolerance_slider", 1e-4 },
                                                             { "tolerance_length", 1e-4 },
                                                             { "tolerance_direction", 0.2 * M_PI / 180.0 } };
  const Machine printer = uranesx(Interval(0.101), Interval(0.0), 0.218);  // kossel_mini of the machines in test/data
  Criterion wide;
  chooseBounds(printer, wide);
  Random random(SEED + 4);
  for (const Row& row :
       { Row{ orthoglide(), makeCube(), {}, 1e-3, 4000 }, Row{ uranesx(), makeSquare(), {}, 2e-3, 8000 },
         Row{ printer, makeDisc(), wide, 1e-3, 4000 }, Row{ printer, makeSquare(), wide, 1e-3, 4000 } })
  {
    SCOPED_TRACE(row.machine.name() + " " + row.shape->name());
    const Machine machine = within(row.machine, some);
    RegionQuery wanted = query(row.shape, row.accuracy * row.machine.scale());
    wanted.criterion = row.criterion;
    const Vector3d reach = Vector3d(1.0, 1.0, row.machine.hasParallelRails() ? 0.0 : 1.0) * row.machine.scale();
    wanted.search_box =
        Box{ row.machine.zero() - reach, row.machine.zero() + reach };  // their rails are no more parallel
    const LargestRegion region = findLargestRegion(machine, wanted);
    EXPECT_EQ(region.status, LargestRegion::Status::PROVEN) << region.message;
    EXPECT_GT(region.size, 0.1 * row.machine.scale());
    EXPECT_LE(region.boxes, row.most_boxes);
    expectGoodOnAll(machine, region, *row.shape, row.criterion, random);
  }
}

/// Just above the upper bound the machine that is named is bad, in 100 digits.
TEST(ToleratedRegion, namesAMachineThatHasNoLargerOne)
{
  const Machine machine = within(orthoglide(), { { "tolerance_slider", 1e-4 }, { "tolerance_length", 1e-4 } });
  const LargestRegion region = findLargestRegion(machine, query(makeCube(), 1e-5));
  Random random(SEED + 5);
  for (int k = 0; k < cases(10); ++k)
  {
    const Vector3d aside(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
    const Vector3d center = region.center + std::pow(10.0, random.uniform(-7.0, -4.0)) * aside;
    const ContainmentResult found =
        checkContainment(BoxTest(machine, Criterion()), *makeCube(), center, region.size_upper_bound + 2e-5);
    ASSERT_EQ(found.verdict, Containment::OUTSIDE);
    const BadMachine bad = badMachineAt(machine, Criterion(), *found.bad_point);
    ASSERT_TRUE(bad.machine);
    EXPECT_FALSE(Oracle(*bad.machine, Criterion()).isGood(*found.bad_point));
  }
}

TEST(ToleratedRegion, isGoodOnEveryMachine)
{
  Random random(SEED);
  const std::vector<std::pair<const char*, double>> some = { { "tolerance_slider", 1e-4 },
                                                             { "tolerance_platform_ball", 1e-4 },
                                                             { "tolerance_length", 1e-4 },
                                                             { "tolerance_direction", 2e-4 } };
  for (const ShapePtr& shape : { makeCube(), makeSphere() })
    for (const Machine& exact : { orthoglide(), crooked(1), crooked(4) })
    {
      SCOPED_TRACE(exact.name() + " " + shape->name());
      const Machine machine = within(exact, some);
      const RegionQuery wanted = query(shape, 1e-3);
      const LargestRegion region = findLargestRegion(machine, wanted);
      EXPECT_EQ(region.status, LargestRegion::Status::PROVEN) << region.message;
      const LargestRegion meant = findLargestRegion(exact, wanted);
      EXPECT_LT(region.size, meant.size_upper_bound);
      EXPECT_LT(region.size_upper_bound, meant.size_upper_bound + 1e-3);
      expectGoodOnAll(machine, region, *shape, wanted.criterion, random);
    }
}

/// Above the bound some machine is bad in each placement: just above the optimum of the Orthoglide, at centers around.
TEST(ToleratedRegion, aMachineIsBadInEveryLargerOne)
{
  Random random(SEED);
  const Machine machine = within(orthoglide(), { { "tolerance_slider", 1e-4 }, { "tolerance_length", 1e-4 } });
  const LargestRegion region = findLargestRegion(machine, query(makeCube(), 1e-4));
  const double size = region.size_upper_bound + 1e-6;
  for (int k = 0; k < cases(30); ++k)
  {
    const double way = std::pow(10.0, random.uniform(-6.0, -2.0));
    const Vector3d center =
        region.center + way * Vector3d(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
    bool is_bad = false;
    for (int corner = 0; corner < 8 && !is_bad; ++corner)
    {
      const Vector3d half(corner & 1 ? 0.5 : -0.5, corner & 2 ? 0.5 : -0.5, corner & 4 ? 0.5 : -0.5);
      const Vector3d point = center + size * half;
      is_bad = !isGood(machine, worstDeviation(machine, Criterion(), point, random, 2), Criterion(), point);
    }
    EXPECT_TRUE(is_bad) << "center " << center.transpose();
  }
}

TEST(ToleratedRegion, jointRangesHoldThoseOfAllMachines)
{
  Random random(SEED);
  const Machine machine =
      within(crooked(1), { { "tolerance_slider", 1e-3 }, { "tolerance_zero", 1e-3 }, { "tolerance_direction", 1e-3 } });
  const ShapePtr cube = makeCube();
  const Vector3d center = machine.zero();
  const std::array<JointRange, 3> ranges = jointRanges(machine, *cube, center, 0.1);
  for (int k = 0; k < cases(200); ++k)
  {
    const Deviation at = randomDeviation(random);
    const Vector3d point = center + 0.05 * Vector3d(random.sign(), random.sign(), random.sign());
    const auto rho = inverseKinematics(built(machine, at), point);
    ASSERT_TRUE(rho);
    for (int leg = 0; leg < 3; ++leg)
    {
      // the zero is off by so much: it is what the controller reads that has the range
      const double read = (*rho)[leg] - 1e-3 * at.share[static_cast<std::size_t>(leg)][15];
      EXPECT_GE(read, ranges[static_cast<std::size_t>(leg)].lower.lower());
      EXPECT_LE(read, ranges[static_cast<std::size_t>(leg)].upper.upper());
    }
  }
}

TEST(Tolerate, bracketsTheFactorAndNamesAMachine)
{
  const Machine machine = within(orthoglide(), { { "tolerance_slider", 1e-4 }, { "tolerance_length", 1e-4 } });
  FactorQuery task;
  task.solid = makeSolid(makeCube(), 0.64);
  task.center = Vector3d::Constant(0.0862);
  const TolerableFactor report = tolerableFactor(machine, task);
  EXPECT_GT(report.holds, 5.0);
  EXPECT_GT(report.fails, report.holds);
  EXPECT_LT(report.fails, 1.25 * report.holds);
  ASSERT_TRUE(report.bad_machine);
  EXPECT_FALSE(Oracle(*report.bad_machine, task.criterion).isGood(*report.bad_point));
  double sum = 0.0;
  for (const ToleranceShare& share : report.shares)
    sum += share.share;
  EXPECT_NEAR(sum, 1.0, 0.05);
  for (const double factor : { report.holds, report.fails })
  {
    const BoxTest test(withTolerances(machine, scaled(tolerancesOf(machine), factor)), task.criterion);
    EXPECT_EQ(checkContainment(test, *task.solid.shape, task.center, task.solid.size).verdict,
              factor == report.holds ? Containment::INSIDE : Containment::OUTSIDE);
  }
  EXPECT_THROW(tolerableFactor(orthoglide(), task), std::invalid_argument);
  task.solid = makeSolid(makeCube(), 0.65);
  EXPECT_EQ(tolerableFactor(machine, task).fails, 0.0);
}

// Found in review: box and ball of both ends were mixed coordinate by coordinate, so that the ball was left.
TEST(Tolerate, namesAMachineWithinItsTolerances)
{
  const Machine machine = within(orthoglide(), { { "tolerance_slider_ball", 1e-4 }, { "tolerance_platform", 1e-4 } });
  FactorQuery query;
  query.solid = makeSolid(makeCube(), 0.6);
  query.center = Vector3d::Constant(0.08);
  const TolerableFactor found = tolerableFactor(machine, query);
  ASSERT_TRUE(found.bad_machine);
  const double reach = 1e-4 * found.fails;
  for (std::size_t leg = 0; leg < 3; ++leg)
  {
    const SlidingStrut& built = slidingStrut(found.bad_machine->legs()[leg]);
    const SlidingStrut& meant = slidingStrut(machine.legs()[leg]);
    EXPECT_LE((mid(built.origin) - mid(meant.origin)).norm(), reach * (1.0 + 1e-9));
    EXPECT_LE((mid(built.platform) - mid(meant.platform)).cwiseAbs().maxCoeff(), reach * (1.0 + 1e-9));
  }
  // the slopes of three balls of two coordinates and of three boxes: sqrt(2) to 2
  for (const ToleranceShare& share : found.shares)
    EXPECT_NEAR(share.share, std::string(share.kind->name) == "tolerance_platform" ? 0.195 : 0.138, 0.001);
}
}  // namespace test
}  // namespace pkm_workspace
