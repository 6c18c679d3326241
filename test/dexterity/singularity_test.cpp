// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/dexterity/singularity.h"

#include <gtest/gtest.h>

#include <cmath>

#include "pkm_workspace/dexterity/unbounded.h"
#include "pkm_workspace/paving/range_workspace.h"
#include "pkm_workspace/region/joint_ranges.h"
#include "pkm_workspace/region/region_parts.h"
#include "support/cases.h"
#include "support/expect_throw.h"
#include "support/machines.h"
#include "support/random.h"

namespace pkm_workspace
{
namespace
{
using Status = SingularityAnswer::Status;
using Eigen::Vector3d;

using test::SEED;

/// The machine with the equalised joint ranges of a region for limits.
Machine withRangesOf(const Machine& machine, const Shape& shape, const Vector3d& center, double size)
{
  const auto over = jointRanges(machine, shape, center, size);
  const JointIntervals ranges = equalisedRanges({ over[0].lower, over[1].lower, over[2].lower },
                                                { over[0].stroke, over[1].stroke, over[2].stroke });
  return withJointLimits(machine, ranges.outer);
}

/// docs/values.md: the largest cube, its edge rounded inward.
const Vector3d CUBE_CENTER = Vector3d::Constant(0.086273015);
constexpr double CUBE_EDGE = 0.64395;

SingularityQuery withinLimits()
{
  SingularityQuery query;
  query.joint_limits = true;
  return query;
}

/// Each joint value within its limits, up to rounding.
bool withinLimits(const Machine& machine, const Configuration& at)
{
  for (std::size_t i = 0; i < 3; ++i)
    if (!at.rho[i].intersects(machine.leg(static_cast<int>(i)).limits))
      return false;
  return true;
}

/// No point of a seeded choice has a smaller measure than what is proved to be the least.
void expectBounds(const Machine& machine, const Box& space, const Singularities& found,
                  const std::function<bool(const Configuration&)>& counts)
{
  test::RandomBoxes random(SEED);
  for (int k = 0; k < test::cases(2000); ++k)
  {
    const Vector3d point = random.pointIn(space);
    const auto at = configurationAt(machine, point);
    if (!at || !counts(*at))
      continue;
    for (std::size_t i = 0; i < 3; ++i)
      EXPECT_GE(abs(at->eta[i]).upper(), found.serial[i].least.lower())
          << machine.name() << ", seed " << SEED << ", point " << point.transpose();
    EXPECT_GE(abs(at->det_a).upper(), found.parallel.least.lower())
        << machine.name() << ", seed " << SEED << ", point " << point.transpose();
  }
}
}  // namespace

// In the upper corner, at t = 1/sqrt 6, eta = sqrt(1 - 2 t^2) is least, and det A = (1 + 2k) (1 - k)^2 eta^3 with
// k = 1/2 (docs/values.md).
TEST(Singularity, noneInTheOrthoglidesCube)
{
  const SingularityQuery query = singularitiesOver(makeCube(), CUBE_CENTER, CUBE_EDGE);
  const Singularities found = findSingularities(orthoglide(), query);
  for (const SingularityAnswer& answer : found.serial)
  {
    EXPECT_EQ(answer.status, Status::NONE);
    EXPECT_NEAR(answer.least.lower(), std::sqrt(2.0 / 3.0), 1e-3);
    EXPECT_NEAR(answer.least.upper(), std::sqrt(2.0 / 3.0), 1e-3);
  }
  EXPECT_EQ(found.parallel.status, Status::NONE);
  EXPECT_NEAR(found.parallel.least.lower(), 0.5 * std::pow(2.0 / 3.0, 1.5), 1e-3);
  EXPECT_NEAR(found.parallel.least.upper(), 0.5 * std::pow(2.0 / 3.0, 1.5), 1e-3);
  expectBounds(orthoglide(), *query.box, found, [](const Configuration&) { return true; });
}

// docs/values.md: p = -(1, 1, 1)/sqrt 6 is one, against the paper's sentence.
TEST(Singularity, parallelInTheJointRangesOfTheOrthoglidesCube)
{
  const Machine machine = withRangesOf(orthoglide(), *makeCube(), CUBE_CENTER, CUBE_EDGE);
  for (const Criterion::Aspect aspect : { Criterion::Aspect::OWN, Criterion::Aspect::BOTH })
  {
    SingularityQuery query = withinLimits();
    query.aspect = aspect;
    const SingularityAnswer found = findSingularities(machine, query).parallel;
    ASSERT_EQ(found.status, Status::PROVED);
    EXPECT_EQ(found.least, Interval(0.0));
    EXPECT_LE(found.box->maxWidth(), 1e-5);
    const auto at = configurationAt(machine, enclose(*found.box));
    ASSERT_TRUE(at);
    EXPECT_TRUE(at->det_a.contains(0.0)) << at->det_a;
    EXPECT_TRUE(withinLimits(machine, *at));
  }
}

// docs/values.md: the UraneSX has no parallel singularity in the ranges of its square extruded by its edge, but serial
// ones.
TEST(Singularity, serialInTheJointRangesOfTheUranesx)
{
  const Machine uranes = uranesx();
  const Machine machine = withRangesOf(uranes, *makeCube(), { -0.01329, 0.0, uranes.zero().z() }, 0.51949);
  const Singularities found = findSingularities(machine, withinLimits());
  EXPECT_EQ(found.parallel.status, Status::NONE);
  EXPECT_GE(found.parallel.least.lower(), 0.42);
  EXPECT_EQ(found.serial[0].status, Status::NONE)
      << found.serial[0].least << found.serial[1].least << found.serial[2].least;
  for (const std::size_t leg : { 1, 2 })
  {
    ASSERT_EQ(found.serial[leg].status, Status::PROVED);
    const IntervalVector point = enclose(found.serial[leg].box->center());
    EXPECT_NEAR(reachAt(machine.enclosed(static_cast<int>(leg)), point).value.mid(), 1.0, 1e-5);
  }
  expectBounds(machine, test::spaceOf(machine), found,
               [&](const Configuration& at) { return withinLimits(machine, at); });
}

// Where limits are enclosures, what lies between the inner and the outer ones is neither proved nor excluded.
TEST(Singularity, limitsThatAreEnclosuresProveNothingBetweenThem)
{
  const Machine machine = withRangesOf(orthoglide(), *makeCube(), CUBE_CENTER, CUBE_EDGE);
  SingularityQuery query = withinLimits();
  const SingularityAnswer exact = findSingularities(machine, query).parallel;
  ASSERT_EQ(exact.status, Status::PROVED);
  const auto answerWithin = [&](double kept) {
    std::array<Interval, 3> sure;
    for (std::size_t i = 0; i < 3; ++i)
      sure[i] = Interval(machine.leg(static_cast<int>(i)).limits.lower() + kept,
                         machine.leg(static_cast<int>(i)).limits.upper());
    query.surely_within = sure;
    query.budget.max_boxes = 20000;
    return findSingularities(machine, query).parallel;
  };
  const SingularityAnswer nearly = answerWithin(1e-9);
  EXPECT_EQ(nearly.status, Status::PROVED);
  const SingularityAnswer within = answerWithin(0.4);
  EXPECT_EQ(within.status, Status::UNDECIDED) << "the singularities have smaller joint values";
  EXPECT_TRUE(within.least.contains(0.0));
  query.surely_within = { Interval::empty(), Interval::empty(), Interval::empty() };
  const SingularityAnswer none = findSingularities(machine, query).parallel;
  EXPECT_EQ(none.status, Status::UNDECIDED);
  EXPECT_EQ(none.least.upper(), std::numeric_limits<double>::infinity());
  query.joint_limits = false;
  test::expectThrow<std::invalid_argument>([&] { findSingularities(machine, query); }, "surely_within");
}

TEST(Singularity, noneInTheUranesxSquare)
{
  const SingularityQuery query = singularitiesOver(makeSquare(), { -0.01329, 0.0, uranesx().zero().z() }, 0.5194);
  const Singularities found = findSingularities(uranesx(), query);
  EXPECT_EQ(found.parallel.status, Status::NONE);
  for (const SingularityAnswer& answer : found.serial)
    EXPECT_EQ(answer.status, Status::NONE);
  expectBounds(uranesx(), *query.box, found, [](const Configuration&) { return true; });
}

// docs/values.md: the largest sphere. The bounds are those of the sphere, not of the box around it.
TEST(Singularity, noneInTheOrthoglidesSphere)
{
  const Vector3d center = Vector3d::Constant(0.0705);
  const ShapePtr sphere = makeSphere();
  const Singularities found = findSingularities(orthoglide(), singularitiesOver(sphere, center, 0.5303));
  SingularityQuery whole;
  whole.box = sphere->boundingBox(center, 0.5303);
  const Singularities around = findSingularities(orthoglide(), whole);
  EXPECT_EQ(found.parallel.status, Status::NONE);
  EXPECT_GT(found.parallel.least.lower(), around.parallel.least.upper());
  test::RandomBoxes random(SEED);
  for (int k = 0; k < test::cases(2000); ++k)
  {
    const Vector3d point = random.pointIn(*whole.box);
    if ((point - center).norm() > 0.5303)
      continue;
    const auto at = configurationAt(orthoglide(), point);
    ASSERT_TRUE(at);
    EXPECT_GE(at->det_a.upper(), found.parallel.least.lower()) << "seed " << SEED << ", point " << point.transpose();
    for (std::size_t i = 0; i < 3; ++i)
      EXPECT_GE(abs(at->eta[i]).upper(), found.serial[i].least.lower());
  }
}

TEST(Singularity, noPointWithinLimitsBeatsTheBounds)
{
  for (const Machine& kind : test::everyKind())
  {
    const Machine machine = test::limited(kind);
    for (const Criterion::Aspect aspect : { Criterion::Aspect::OWN, Criterion::Aspect::OTHER, Criterion::Aspect::BOTH })
    {
      SingularityQuery query = withinLimits();
      query.aspect = aspect;
      query.budget.max_boxes = 5000;
      const int sign = aspect == Criterion::Aspect::OTHER ? -machine.aspect() : machine.aspect();
      expectBounds(machine, test::spaceOf(machine), findSingularities(machine, query), [&](const Configuration& at) {
        return withinLimits(machine, at) && (aspect == Criterion::Aspect::BOTH || sign * at.det_a.mid() >= 0.0);
      });
    }
  }
}

TEST(Singularity, nothingIsClaimedOfAnEmptySetOrBeyondTheBudget)
{
  SingularityQuery query;
  query.box = Box{ Vector3d::Constant(2.0), Vector3d::Constant(3.0) };
  const SingularityAnswer empty = findSingularities(orthoglide(), query).parallel;
  EXPECT_EQ(empty.status, Status::NONE);
  EXPECT_TRUE(empty.least.isEmpty());
  query.box.reset();
  query.budget.max_boxes = 1;
  const SingularityAnswer stopped = findSingularities(orthoglide(), query).parallel;
  EXPECT_EQ(stopped.status, Status::UNDECIDED);
  EXPECT_EQ(stopped.boxes, 1);
  EXPECT_TRUE(stopped.least.contains(0.0));
}

TEST(Singularity, keepsToItsMemory)
{
  SingularityQuery query;
  query.joint_limits = true;
  query.budget.max_boxes = 3000;
  const Machine machine = test::limited(test::crooked(1));
  const Singularities free = findSingularities(machine, query);
  query.budget.max_memory = Budget::LEAST_MEMORY;
  const Singularities kept = findSingularities(machine, query);
  const auto compare = [](const SingularityAnswer& few, const SingularityAnswer& many) {
    EXPECT_FALSE(many.out_of_memory);
    EXPECT_TRUE(few.out_of_memory);
    EXPECT_EQ(few.status, Status::UNDECIDED);
    EXPECT_LT(few.boxes, many.boxes);
    EXPECT_TRUE(many.least.isSubsetOf(few.least)) << many.least << few.least;
  };
  for (std::size_t k = 0; k < 3; ++k)
    compare(kept.serial[k], free.serial[k]);
  compare(kept.parallel, free.parallel);
}

TEST(Singularity, answersDoNotDependOnThreads)
{
  SingularityQuery query;
  query.budget.threads = 1;
  const Singularities one = findSingularities(test::crooked(1), query);
  query.budget.threads = 3;
  const Singularities three = findSingularities(test::crooked(1), query);
  EXPECT_EQ(one.parallel.boxes, three.parallel.boxes);
  EXPECT_EQ(one.parallel.least, three.parallel.least);
  EXPECT_EQ(one.serial[0].least, three.serial[0].least);
}

TEST(Singularity, refusesWhatHasNoAnswer)
{
  SingularityQuery query;
  test::expectThrow<Unbounded>([&] { findSingularities(uranesx(), query); }, "parallel");
  query.accuracy = 0.0;
  query.budget.threads = 0;
  test::expectThrow<std::invalid_argument>([&] { findSingularities(orthoglide(), query); }, "accuracy");
}
}  // namespace pkm_workspace
