// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/region/joint_ranges.h"

#include <gtest/gtest.h>

#include "support/cases.h"
#include "support/expect_throw.h"
#include "support/machines.h"
#include "support/oracle.h"

namespace pkm_workspace
{
namespace
{
constexpr unsigned SEED = 20260604;
}

// docs/values.md: over the largest cube the stroke is 1 + 1/(3 sqrt 2) - 1/sqrt 6 and its part Delta f is 1 -
// sqrt(2/3). Between the cubes a little smaller and a little larger than the largest one lie the exact values.
TEST(JointRanges, orthoglideCube)
{
  const Interval a = Interval(1.0) / sqrt(Interval(6.0));
  const Interval b = Interval(1.0) / (Interval(3.0) * sqrt(Interval(2.0)));
  const double center = ((a - b) / Interval(2.0)).mid();
  for (const int leg : { 0, 1, 2 })
  {
    const auto over = [&](double edge) {
      return jointRanges(orthoglide(), *makeCube(), Eigen::Vector3d::Constant(center),
                         edge)[static_cast<std::size_t>(leg)];
    };
    const JointRange smaller = over((a + b).lower() - 4e-16);
    const JointRange larger = over((a + b).upper() + 4e-16);
    const Interval stroke = Interval(1.0) + b - a;
    EXPECT_TRUE(hull(smaller.stroke, larger.stroke).contains(stroke.mid())) << larger.stroke << stroke;
    EXPECT_LT(larger.stroke.upper() - smaller.stroke.lower(), 1e-11);
    const Interval across = Interval(1.0) - sqrt(Interval(2.0) / Interval(3.0));
    EXPECT_TRUE(hull(smaller.across, larger.across).contains(across.mid())) << larger.across << across;
    EXPECT_NEAR(larger.stroke.mid(), 0.827453970, 1e-9);  // docs/values.md prints 0.827454012 beside this formula
    EXPECT_NEAR(larger.across.mid(), 0.183503419, 1e-9);
  }
}

// docs/values.md: Delta f of the paper's square at its printed center, at (-0.018, 0), and of the optimum; no
// thickness, so it is the stroke.
TEST(JointRanges, uranesxSquares)
{
  const Machine machine = uranesx();
  struct Row
  {
    double x, y, edge, across;
  };
  for (const Row& row : { Row{ -0.0178, -0.0045, 0.510, 0.3554 }, Row{ -0.018, 0.0, 0.510, 0.3514 },
                          Row{ -0.01329, 0.0, 0.51949, 0.3633 } })
  {
    const auto ranges = jointRanges(machine, *makeSquare(), { row.x, row.y, machine.zero().z() }, row.edge);
    double largest = 0.0;
    for (const JointRange& range : ranges)
    {
      EXPECT_TRUE(range.stroke.intersects(range.across)) << "nothing but eta changes in a plane across the rails";
      largest = std::max(largest, range.across.mid());
    }
    EXPECT_NEAR(largest, row.across, 1e-4);
  }
}

TEST(JointRanges, encloseTheJointValuesOfEveryPoint)
{
  for (const Machine& machine : test::everyKind())
  {
    const ShapePtr shape = makeBox(machine.scale() * Eigen::Vector3d(0.2, 0.3, 0.1));
    const double accuracy = 1e-12 * (machine.scale() + machine.zero().norm());
    const auto ranges = jointRanges(machine, *shape, machine.zero(), 1.0);
    const test::Oracle oracle(machine, Criterion());
    test::RandomBoxes random(SEED);
    const Box region = shape->boundingBox(machine.zero(), 1.0);
    for (int i = 0; i < 3; ++i)
    {
      const JointRange& range = ranges[static_cast<std::size_t>(i)];
      EXPECT_LE(range.lower.width(), 2 * accuracy);
      EXPECT_LE(range.upper.width(), 2 * accuracy);
      for (int k = 0; k < test::cases(200); ++k)
      {
        const Eigen::Vector3d point = random.pointIn(region);
        const test::Oracle::Number rho = oracle.joint(i, { point.x(), point.y(), point.z() });
        EXPECT_TRUE(range.lower.lower() <= rho && rho <= range.upper.upper())
            << machine.name() << ", seed " << SEED << ", point " << point.transpose();
      }
    }
  }
}

TEST(JointRanges, refuseARegionThatIsOutOfReach)
{
  test::expectThrow<std::domain_error>(
      [] { jointRanges(orthoglide(), *makeCube(), Eigen::Vector3d::Constant(2.0), 0.1); }, "does not reach");
}
}  // namespace pkm_workspace
