// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/region/joint_ranges.h"

#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

#include "support/cases.h"
#include "support/expect_throw.h"
#include "support/machines.h"
#include "support/oracle.h"
#include "support/random.h"

namespace pkm_workspace
{
namespace
{
using test::SEED;
using Number = test::Oracle::Number;

test::Oracle::Vector exactly(const Eigen::Vector3d& point)
{
  return { point.x(), point.y(), point.z() };
}

/// Joint values over points of a region, each exact to 100 digits: the least and the largest that a search finds.
struct Found
{
  Number least, largest;
};

/// From the best of seeded points in steps that get shorter, in both directions.
Found search(const Machine& machine, int leg, const Shape& shape, const Eigen::Vector3d& center, double size)
{
  const test::Oracle oracle(machine, Criterion());
  test::RandomBoxes random(SEED);
  const auto inside = [&](const Eigen::Vector3d& point) {
    return nearestInside(shape, point, center, size).value_or(center);
  };
  const auto* const strut = std::get_if<SlidingStrut>(&machine.leg(leg).kind);
  using Wide = Eigen::Matrix<long double, 3, 1>;
  const Wide c = mid(machine.center(leg)).cast<long double>();
  const Wide e = strut ? Wide(mid(strut->axis).cast<long double>().normalized()) : Wide(Wide::UnitX());
  const auto jointAt = [&](const Eigen::Vector3d& point) -> long double {
    if (strut == nullptr)
      return (*inverseKinematics(machine, point))[leg];
    const Wide x = point.cast<long double>() - c;
    const long double along = e.dot(x);
    const long double length = strut->length.mid();
    const long double radicand = length * length - (x - along * e).squaredNorm();
    return along - strut->working_mode * std::sqrt(std::max(0.0L, radicand));
  };
  const auto best = [&](int sign) {
    Eigen::Vector3d at = center;
    long double value = sign * jointAt(at);
    const auto attempt = [&](const Eigen::Vector3d& point) {
      const long double there = sign * jointAt(point);
      at = there < value ? point : at;
      value = there < value ? there : value;
    };
    for (const Eigen::Vector3d& point : pointsOf(shape.extremePoints(), center, size))
      attempt(inside(point));
    const Eigen::Vector3d reach = shape.halfExtents().at(size);
    for (double step = 1.0; step > 1e-11; step *= 0.8)
      for (int k = 0; k < test::cases(40); ++k)
        attempt(inside(at + step * random.pointIn(Box{ -reach, reach })));
    return oracle.joint(leg, exactly(at));
  };
  return { best(1), best(-1) };
}

void expectTight(const Machine& machine, const Shape& shape, double size, double rounding)
{
  const auto ranges = jointRanges(machine, shape, machine.zero(), size);
  for (int leg = 0; leg < 3; ++leg)
  {
    const JointRange& range = ranges[static_cast<std::size_t>(leg)];
    const Found found = search(machine, leg, shape, machine.zero(), size);
    const auto message = [&] {
      std::ostringstream text;
      text << machine.name() << ", leg " << leg << ", " << shape.name() << " of size " << size << ", seed " << SEED
           << ": " << range.lower << " found " << found.least << ", " << range.upper << " found " << found.largest;
      return text.str();
    };
    EXPECT_LE(range.lower.width(), rounding) << message();
    EXPECT_LE(range.upper.width(), rounding) << message();
    EXPECT_LE(range.across.width(), 2 * rounding) << message();
    const Number digits = 1e-90;  // of the oracle's own roundings
    EXPECT_TRUE(range.lower.lower() <= found.least + digits && found.largest - digits <= range.upper.upper())
        << message();
    const double searched = 1e-5 * shape.halfExtents().at(size).maxCoeff();
    EXPECT_TRUE(found.least <= range.lower.upper() + searched) << message();
    EXPECT_TRUE(found.largest >= range.upper.lower() - searched) << message();
  }
}
}  // namespace

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
  std::vector<Machine> machines = test::everyKind();
  Machine::Legs inward = delta().legs();
  for (Leg& leg : inward)
  {
    std::get<Crank>(leg.kind).working_mode = -1;
    std::get<Crank>(leg.kind).reference = -2.9;
  }
  machines.emplace_back("delta with its cranks inward", inward, delta().zero());
  for (const Machine& machine : machines)
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

// Rails along z: rho = z - eta, and eta follows from the distance of the axis from the nearest and the farthest point
// of the square, whose corner comes as near to the border of reach as doubles can.
TEST(JointRanges, squaresNearTheBorderOfReach)
{
  const Machine machine = uranesx();
  const double z = machine.zero().z();
  const Eigen::Vector3d axis = mid(machine.center(1)).cwiseAbs();  // the corner across from it is the farthest of all
  for (const double margin : { 1e-1, 1e-2, 1e-3, 1e-5, 1e-8, 1e-12, 1e-15 })
  {
    const double reach = 1.0 - margin;
    const double sum = axis.x() + axis.y();
    const double half = 0.5 * (std::sqrt(sum * sum - 2.0 * (axis.squaredNorm() - reach * reach)) - sum);
    const JointRange range = jointRanges(machine, *makeSquare(), { 0.0, 0.0, z }, 2.0 * half)[1];
    const auto squaredDistance = [&](int side) {
      const Number x = std::max(Number(0), Number(axis.x()) + side * Number(half));
      const Number y = std::max(Number(0), Number(axis.y()) + side * Number(half));
      return Number(x * x + y * y);
    };
    ASSERT_LE(squaredDistance(1), 1) << "beyond reach";
    const Number least = z + sqrt(1 - squaredDistance(1));
    const Number largest = z + sqrt(1 - squaredDistance(-1));
    EXPECT_TRUE(range.lower.lower() <= least && least <= range.lower.upper()) << range.lower << ' ' << least;
    EXPECT_TRUE(range.upper.lower() <= largest && largest <= range.upper.upper()) << range.upper << ' ' << largest;
    const double root = 1e-14 + 4e-15 / std::sqrt(2.0 * margin);  // of the roundings of the squared distance
    EXPECT_LE(range.lower.width(), root) << "margin " << margin;
    EXPECT_LE(range.upper.width(), 1e-14) << "margin " << margin;
    EXPECT_LE(range.stroke.width(), 2e-14 + root) << "margin " << margin;
  }
}

// Angles of a crank go on over the one that is half a turn from its reference.
TEST(JointRanges, goOnOverTheEndOfATurn)
{
  const auto rangesAbout = [](double reference) {
    Machine::Legs legs = delta().legs();
    for (Leg& leg : legs)
      std::get<Crank>(leg.kind).reference = reference;
    const Machine machine("delta", legs, delta().zero());
    return jointRanges(machine, *makeCube(), machine.zero(), 0.3);
  };
  const auto expected = rangesAbout(0.0);
  for (const double reference : { 3.0, -3.0, 3.2, -3.1 })
  {
    const auto found = rangesAbout(reference);
    for (std::size_t leg = 0; leg < 3; ++leg)
    {
      const double turn = 2.0 * M_PI * std::round((found[leg].upper.mid() - expected[leg].upper.mid()) / (2.0 * M_PI));
      EXPECT_NEAR(found[leg].upper.mid() - turn, expected[leg].upper.mid(), 1e-12) << reference;
      EXPECT_NEAR(found[leg].lower.mid() - turn, expected[leg].lower.mid(), 1e-12) << reference;
      EXPECT_LE(found[leg].stroke.width(), 1e-11) << reference;
    }
  }
}

TEST(JointRanges, holdAndMeetWhatASearchFinds)
{
  for (const Machine& machine : test::everyKind())
  {
    const double scale = machine.scale();
    const double rounding = 1e-13 * (scale + machine.zero().norm());
    const bool is_sliding = std::holds_alternative<SlidingStrut>(machine.leg(1).kind);
    for (const ShapePtr& shape : { makeCube(), makeSquare(), makeBox({ 0.1, 0.3, 2.0 }), makeSphere() })
      for (const double size : { 0.02 * scale, is_sliding ? 0.3 * scale : 0.1 * scale })
        expectTight(machine, *shape, size, rounding);
    for (const ShapePtr& shape : { makeDisc(), makeCylinder(0.3), makeCylinder(5.0) })
      expectTight(machine, *shape, 0.05 * scale, 1e-12 * 0.05 * scale + rounding);
  }
}

// A strut that just reaches has unbounded derivatives; the ranges are known all the same. Beyond, they are refused.
TEST(JointRanges, regionsThatTouchTheBorderOfReach)
{
  for (const Machine& machine : { test::crooked(1), test::crooked(5), test::cone() })
    for (const ShapePtr& shape : { makeCube(), makeSphere() })
    {
      double size = 0.01 * machine.scale();
      double beyond = 4.0 * machine.scale();
      for (int k = 0; k < 60; ++k)
      {
        const double middle = 0.5 * (size + beyond);
        try
        {
          jointRanges(machine, *shape, machine.zero(), middle);
          size = middle;
        }
        catch (const std::domain_error&)
        {
          beyond = middle;
        }
      }
      EXPECT_LT(size, 3.0 * machine.scale());
      expectTight(machine, *shape, (1.0 - 1e-14) * size, 1e-6 * machine.scale());
    }
}

TEST(JointRanges, roundRegionsThatTouchTheBorderOfReach)
{
  const Machine machine = uranesx();
  const double reach = 1.0 - std::abs(mid(machine.center(0)).x()) - 2e-16;
  expectTight(machine, *makeDisc(), reach, 1e-6);
  expectTight(machine, *makeCylinder(0.5), 2.0 * reach, 1e-6);
  expectTight(machine, *makeSphere(), reach, 1e-6);
}

TEST(JointRanges, refuseARegionThatIsOutOfReach)
{
  test::expectThrow<std::domain_error>(
      [] { jointRanges(orthoglide(), *makeCube(), Eigen::Vector3d::Constant(2.0), 0.1); }, "does not reach");
}
}  // namespace pkm_workspace
