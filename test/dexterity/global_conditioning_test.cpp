// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/dexterity/global_conditioning.h"

#include <gtest/gtest.h>

#include <atomic>

#include "support/cases.h"
#include "support/expect_throw.h"
#include "support/machines.h"
#include "support/random.h"

namespace pkm_workspace
{
namespace
{
using test::SEED;

/// psi_1 / psi_3 in floating point, 0 out of reach.
double indexAt(const Machine& machine, const Eigen::Vector3d& p)
{
  const auto jacobian = jacobians(machine, p);
  if (!jacobian)
    return 0.0;
  const Eigen::Vector3d psi = transmissionFactors(*jacobian);
  return psi[0] / psi[2];
}

MachineModel<double> modelOf(const Machine& machine)
{
  Criterion criterion;
  criterion.set = Criterion::Set::REACHABLE;
  criterion.aspect = Criterion::Aspect::BOTH;
  return { machine, criterion };
}

BoxVerdict everything(const Box&)
{
  return BoxVerdict::INSIDE;
}
}  // namespace

TEST(ConditioningBounds, holdTheIndexAtEveryPoint)
{
  for (const Machine& machine : test::everyKind())
  {
    const MachineModel<double> model = modelOf(machine);
    test::RandomBoxes random(SEED);
    int informative = 0;
    for (int k = 0; k < test::cases(300); ++k)
    {
      const Box box = random.boxIn(test::spaceOf(machine), 0.5 * machine.scale());
      const ConditioningBounds bounds = conditioningOver(model, box);
      informative += bounds.range.width() < 0.2 ? 1 : 0;
      for (int sample = 0; sample < 5; ++sample)
      {
        const Eigen::Vector3d p = sample == 0 ? box.lower : random.pointIn(box);
        const double index = indexAt(machine, p);
        EXPECT_LE(bounds.range.lower(), index + 1e-9) << machine.name() << ", seed " << SEED << ", box " << k;
        EXPECT_GE(bounds.range.upper(), index - 1e-9) << machine.name() << ", seed " << SEED << ", box " << k;
      }
    }
    EXPECT_GT(informative, 10) << machine.name();
  }
}

// The mean over a box by Gauss-Legendre of order 6 along each axis, exact to far below the enclosure's width.
TEST(ConditioningBounds, holdTheMean)
{
  constexpr double NODES[] = { 0.2386191860831969, 0.6612093864662645, 0.9324695142031521 };
  constexpr double WEIGHTS[] = { 0.4679139345726910, 0.3607615730481386, 0.1713244923791704 };
  const Machine machine = orthoglide();
  const Eigen::Vector3d center(0.1, -0.05, 0.2);
  const double half = 0.01;
  double mean = 0.0;
  for (int k = 0; k < 216; ++k)
  {
    Eigen::Vector3d p = center;
    double weight = 1.0 / 8.0;
    for (int axis = 0, rest = k; axis < 3; ++axis, rest /= 6)
    {
      p[axis] += half * (rest % 2 ? 1.0 : -1.0) * NODES[rest % 6 / 2];
      weight *= WEIGHTS[rest % 6 / 2];
    }
    mean += weight * indexAt(machine, p);
  }
  const Eigen::Vector3d halves = Eigen::Vector3d::Constant(half);
  const ConditioningBounds bounds = conditioningOver(modelOf(machine), { center - halves, center + halves });
  EXPECT_LE(bounds.mean.lower(), mean);
  EXPECT_GE(bounds.mean.upper(), mean);
  EXPECT_LT(bounds.mean.width(), 0.25 * bounds.range.width()) << "of second order";
}

TEST(GlobalConditioning, bracketsCloseInOnOneValue)
{
  const Box box{ Eigen::Vector3d::Constant(-0.15), Eigen::Vector3d::Constant(0.35) };
  Interval last(0.0, 1.0);
  for (const double accuracy : { 0.1, 0.03, 0.01 })
  {
    ConditioningQuery query;
    query.accuracy = accuracy;
    const GlobalConditioning result = globalConditioning(orthoglide(), everything, box, query);
    EXPECT_TRUE(result.complete);
    EXPECT_LE(result.index.width(), accuracy);
    EXPECT_TRUE(result.measure.contains(0.125));
    EXPECT_FALSE(intersection(result.index, last).isEmpty());
    last = intersection(result.index, last);
  }
}

TEST(GlobalConditioning, doesNotDependOnThreadsAndHeedsItsBudget)
{
  const Box box{ Eigen::Vector3d::Constant(-0.2), Eigen::Vector3d::Constant(0.2) };
  ConditioningQuery query;
  query.budget.threads = 1;
  const GlobalConditioning one = globalConditioning(orthoglide(), everything, box, query);
  query.budget.threads = 3;
  const GlobalConditioning three = globalConditioning(orthoglide(), everything, box, query);
  EXPECT_EQ(one.index, three.index);
  EXPECT_EQ(one.boxes, three.boxes);
  query.accuracy = 1e-9;
  query.budget.max_boxes = 300;
  const GlobalConditioning stopped = globalConditioning(orthoglide(), everything, box, query);
  EXPECT_FALSE(stopped.complete);
  EXPECT_LE(stopped.boxes, 300 + 128);
  EXPECT_FALSE(intersection(stopped.index, one.index).isEmpty());
}

TEST(GlobalConditioning, moreBoxesNeverTellLess)
{
  const Box box{ Eigen::Vector3d(-0.3, -0.2, -0.4), Eigen::Vector3d(0.5, 0.6, 0.7) };
  const BoxTest set(orthoglide(), Criterion());
  ConditioningQuery query;
  query.accuracy = 1e-6;
  Interval index(0.0, 1.0);
  Interval measure(0.0, 1.0);
  for (query.budget.max_boxes = 1; query.budget.max_boxes < 4000; query.budget.max_boxes += 97)
  {
    const GlobalConditioning found = globalConditioning(orthoglide(), set, box, query);
    ASSERT_TRUE(found.index.isSubsetOf(index)) << found.index << " after " << index << ", boxes " << found.boxes;
    ASSERT_TRUE(found.measure.isSubsetOf(measure)) << found.measure << " after " << measure;
    index = found.index;
    measure = found.measure;
  }
  EXPECT_LT(index.width(), 0.2);
  EXPECT_LT(measure.width(), 0.2);
}

TEST(GlobalConditioning, isZeroOutOfReachAndSoAtOnce)
{
  const Eigen::Vector3d center = Eigen::Vector3d::Constant(9.0);
  const BoxClassifier ball = [&center](const Box& box) {
    const bool is_beside = ((box.lower - center).array() > 0.1).any() || ((center - box.upper).array() > 0.1).any();
    const double reach = (box.center() - center).norm() + (box.upper - box.lower).norm();
    return is_beside ? BoxVerdict::OUTSIDE : reach < 0.1 ? BoxVerdict::INSIDE : BoxVerdict::UNDECIDED;
  };
  const Eigen::Vector3d radii = Eigen::Vector3d::Constant(0.1);
  ConditioningQuery query;
  query.budget.max_boxes = 20000;
  const GlobalConditioning result = globalConditioning(orthoglide(), ball, { center - radii, center + radii }, query);
  EXPECT_TRUE(result.complete) << result.boxes;
  EXPECT_EQ(Interval(0.0), result.index);
}

TEST(GlobalConditioning, keepsToItsMemory)
{
  const Box box{ Eigen::Vector3d::Constant(-0.2), Eigen::Vector3d::Constant(0.2) };
  ConditioningQuery query;
  const GlobalConditioning enough = globalConditioning(orthoglide(), everything, box, query);
  EXPECT_FALSE(enough.out_of_memory);
  query.accuracy = 1e-9;
  query.budget.max_boxes = 1000000;
  std::int64_t last = 0;
  for (const std::int64_t memory : { 4096, 65536, 262144 })
  {
    query.budget.max_memory = memory;
    const GlobalConditioning full = globalConditioning(orthoglide(), everything, box, query);
    EXPECT_TRUE(full.out_of_memory);
    EXPECT_FALSE(full.complete);
    EXPECT_GT(full.boxes, last);
    // all boxes that are kept came from a bisection: there are twice as many looks, and one
    EXPECT_LE((full.boxes + 1) / 2 * static_cast<std::int64_t>(sizeof(Box)), memory);
    EXPECT_FALSE(intersection(full.index, enough.index).isEmpty());
    last = full.boxes;
  }
}

TEST(GlobalConditioning, endsWhereItIsStopped)
{
  std::atomic<bool> stop(false);
  std::atomic<int> looks(0);
  const BoxClassifier stopping = [&](const Box&) {
    stop = ++looks >= 5000;
    return BoxVerdict::INSIDE;
  };
  ConditioningQuery query;
  query.accuracy = 1e-12;
  query.budget.stop = &stop;
  const Box box{ Eigen::Vector3d::Constant(-0.2), Eigen::Vector3d::Constant(0.2) };
  const GlobalConditioning stopped = globalConditioning(orthoglide(), stopping, box, query);
  EXPECT_FALSE(stopped.complete);
  EXPECT_FALSE(stopped.out_of_memory);
  EXPECT_LE(looks, 5000 + 128);
  EXPECT_LT(stopped.index.width(), 0.1);
}

TEST(GlobalConditioning, refusesWhatIsOutOfRange)
{
  ConditioningQuery query;
  query.accuracy = 0.0;
  query.budget.max_memory = 4095;
  const Box reversed{ Eigen::Vector3d::Constant(1.0), Eigen::Vector3d::Constant(-1.0) };
  const auto compute = [&] { globalConditioning(orthoglide(), everything, reversed, query); };
  test::expectThrow<std::invalid_argument>(compute, "accuracy = 0 .*must be from 1e-15 to 1");
  test::expectThrow<std::invalid_argument>(compute, "max_memory = 4095 bytes must be at least 4096");
  test::expectThrow<std::invalid_argument>(compute, "box x = \\[1, -1\\] m");
}
}  // namespace pkm_workspace
