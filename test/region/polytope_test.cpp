// SPDX-License-Identifier: BSD-3-Clause
// Polytopes from their vertices: what they are follows from convex combinations of these alone.
#include <gtest/gtest.h>

#include "pkm_workspace/region/containment.h"
#include "pkm_workspace/region/convex_hull.h"
#include "pkm_workspace/region/growing_prisms.h"
#include "pkm_workspace/region/joint_ranges.h"
#include "pkm_workspace/region/polytope.h"
#include "pkm_workspace/region/region_wish.h"
#include "region/parallel_rails.h"
#include "support/body_points.h"
#include "support/expect_throw.h"
#include "support/octahedron.h"
#include "support/oracle.h"

namespace pkm_workspace
{
namespace
{
using Eigen::Vector3d;
using test::cases;
using test::Oracle;
using test::RandomBoxes;
using test::SEED;
using Points = std::vector<Vector3d>;

Points boxCorners(const Vector3d& half)
{
  Points corners;
  for (const double x : { -1.0, 1.0 })
    for (const double y : { -1.0, 1.0 })
      for (const double z : { -1.0, 1.0 })
        corners.push_back(Vector3d(x, y, z).cwiseProduct(half));
  return corners;
}

/// A workpiece without symmetry, about a point within.
Points randomPoints(RandomBoxes& random, int count)
{
  Points points = { { 0.5, 0.0, -0.2 }, { -0.4, 0.3, -0.2 }, { -0.3, -0.4, -0.2 }, { 0.05, 0.02, 0.6 } };
  for (int k = 0; k < count; ++k)
    points.push_back(random.pointIn({ Vector3d(-0.4, -0.3, -0.2), Vector3d(0.4, 0.5, 0.4) }));
  return points;
}

/// A convex combination of some of the points, times the size, less than rounding inside; often of one or two of them.
Vector3d combined(const Points& points, const Vector3d& center, double size, RandomBoxes& random)
{
  Vector3d sum = Vector3d::Zero();
  double weights = 0.0;
  const int count = static_cast<int>(random.between(1.0, 4.99));
  for (int k = 0; k < count; ++k)
  {
    const double weight = random.between(0.0, 1.0);
    sum +=
        weight *
        points[static_cast<std::size_t>(random.between(0.0, 1.0) * static_cast<double>(points.size())) % points.size()];
    weights += weight;
  }
  return center + (1.0 - 1e-12) * size / weights * sum;
}

std::vector<std::pair<Points, const char*>> bodies()
{
  RandomBoxes random(SEED);
  return { { randomPoints(random, 12), "workpiece" },
           { { { 0, 0, 0 }, { 0.4, 0.1, 0 }, { -0.1, 0.5, 0.1 }, { 0.1, 0, 0.7 } }, "about a corner" },
           { boxCorners({ 0.25, 0.5, 0.1 }), "box" } };
}

std::vector<Machine> threeMachines()
{
  return { orthoglide(), test::withParallelRails(SEED), test::crooked(4) };
}
}  // namespace

TEST(Polytope, regionsAreGoodAndLargerOnesAreNot)
{
  for (const Machine& machine : threeMachines())
    for (const auto& [points, what] : bodies())
    {
      SCOPED_TRACE(machine.name() + ", " + what + ", seed " + std::to_string(SEED));
      const RegionQuery query = test::queryFor(makePolytope(points), 5e-3 * machine.scale());
      const LargestRegion region = test::expectProven(machine, query);
      EXPECT_GT(region.size, 0.05 * machine.scale());
      const Oracle oracle(machine, query.criterion);
      RandomBoxes random(SEED);
      for (int k = 0; k < cases(300); ++k)
        ASSERT_TRUE(oracle.isGood(combined(points, region.center, region.size, random))) << "case " << k;
      for (int k = 0; k < cases(40); ++k)
      {
        const Vector3d reach = Vector3d::Constant((k % 3 == 0   ? 0.5
                                                   : k % 3 == 1 ? 0.05
                                                                : 5e-3) *
                                                  (k > 0 ? 1.0 : 0.0) * machine.scale());
        const Vector3d center = random.pointIn({ region.center - reach, region.center + reach });
        bool is_bad = false;
        for (int point = 0; point < 3000 && !is_bad; ++point)
          is_bad = !oracle.isGood(combined(points, center, region.size_upper_bound * (1.0 + 1e-9), random));
        ASSERT_TRUE(is_bad) << "case " << k << ", center (" << center.transpose() << ") m";
      }
    }
}

// The same sets of points by other families.
TEST(Polytope, ofTheCornersOfABoxIsThatBox)
{
  for (const Machine& machine : threeMachines())
  {
    const auto solve = [&](const ShapePtr& shape) {
      return test::expectProven(machine, test::queryFor(shape, 2e-3 * machine.scale()));
    };
    const LargestRegion box = solve(makeBox({ 1.0, 2.0, 0.5 }));
    const LargestRegion hull = solve(makePolytope(boxCorners({ 0.5, 1.0, 0.25 })));
    EXPECT_LE(box.size, hull.size_upper_bound) << machine.name();
    EXPECT_LE(hull.size, box.size_upper_bound) << machine.name();
    EXPECT_LE(hull.volume, hull.size * hull.size * hull.size * (1.0 + 1e-12));
    EXPECT_GE(hull.volume, hull.size * hull.size * hull.size * (1.0 - 1e-12));
  }
  const auto octahedron = std::make_shared<test::Octahedron>();
  Points corners;
  for (const GrowingVector& vertex : octahedron->extremePoints())
    corners.push_back(vertex.per_size);
  const LargestRegion own = test::expectProven(orthoglide(), test::queryFor(octahedron, 1e-3));
  const LargestRegion hull = test::expectProven(orthoglide(), test::queryFor(makePolytope(corners), 1e-3));
  EXPECT_LE(own.size, hull.size_upper_bound);
  EXPECT_LE(hull.size, own.size_upper_bound);
}

TEST(Polytope, containmentAndJointRangesAgreeWithTheOracle)
{
  int inside = 0, outside = 0;
  for (const Machine& machine : threeMachines())
    for (const auto& [points, what] : bodies())
    {
      SCOPED_TRACE(machine.name() + ", " + what + ", seed " + std::to_string(SEED));
      const ShapePtr shape = makePolytope(points);
      const BoxTest test(machine, Criterion());
      const Oracle oracle(machine, Criterion());
      RandomBoxes random(SEED);
      for (int k = 0; k < cases(30); ++k)
      {
        const Vector3d center = random.pointIn(test::spaceOf(machine));
        const double size = machine.scale() * random.between(0.01, 0.5);
        const ContainmentResult result = checkContainment(test, *shape, center, size, 20000);
        outside += result.verdict == Containment::OUTSIDE;
        EXPECT_FALSE(result.bad_point && oracle.isGood(*result.bad_point)) << "case " << k;
        EXPECT_TRUE(!result.bad_point || shape->contains(*result.bad_point, { center, center }, size));
        if (result.verdict != Containment::INSIDE)
          continue;
        ++inside;
        const auto ranges = jointRanges(machine, *shape, center, size);
        for (int sample = 0; sample < 30; ++sample)
        {
          const Vector3d p = combined(points, center, size, random);
          EXPECT_TRUE(oracle.isGood(p)) << "case " << k;
          for (std::size_t leg = 0; leg < 3; ++leg)
          {
            const Oracle::Number rho = oracle.joint(static_cast<int>(leg), { p.x(), p.y(), p.z() });
            EXPECT_TRUE(rho >= ranges[leg].lower.lower() && rho <= ranges[leg].upper.upper()) << "case " << k;
          }
        }
      }
    }
  EXPECT_GT(inside, 5);
  EXPECT_GT(outside, 10);
}

// Against what defines it: combinations of the vertices are within, what a plane parts from all vertices is not.
TEST(Polytope, isTheHullOfItsVertices)
{
  RandomBoxes random(SEED);
  for (int body = 0; body < cases(20); ++body)
  {
    SCOPED_TRACE("seed " + std::to_string(SEED) + ", body " + std::to_string(body));
    Points points = randomPoints(random, 4 * body);
    const Points once = points;
    points.insert(points.end(), once.begin(), once.end());  // twice each
    const ShapePtr shape = makePolytope(points);
    const Vector3d center = random.pointIn({ Vector3d::Constant(-3.0), Vector3d::Constant(3.0) });
    const double size = random.between(0.01, 2.0);
    const Box here{ center, center };
    for (int k = 0; k < cases(50); ++k)
    {
      const Vector3d within = combined(points, center, size * (1.0 - 1e-9), random);
      EXPECT_TRUE(shape->contains(within, here, size));
      EXPECT_FALSE(shape->misses({ within, within }, center, size));
      const Vector3d n = random.pointIn({ Vector3d::Constant(-1.0), Vector3d::Constant(1.0) });
      double most = -1e300;
      for (const Vector3d& point : points)
        most = std::max(most, n.dot(point));
      EXPECT_NEAR(shape->support(n).at(size), size * most, 1e-14);
      const Vector3d parted = random.pointIn({ center.array() - 2.0, center.array() + 2.0 });
      if (n.dot(parted - center) > size * most + 1e-9)
      {
        EXPECT_FALSE(shape->contains(parted, here, size));
        const Vector3d nearest = shape->nearest(parted, center, size);
        EXPECT_TRUE(shape->contains(nearest, here, size));
        for (const Vector3d& point : points)  // the angle at the nearest point is not acute
          EXPECT_LE((center + size * point - nearest).dot(parted - nearest), 1e-9);
      }
    }
  }
}

TEST(Polytope, hasVerticesThatTheHullDoesNotNeed)
{
  RandomBoxes random(SEED);
  Points points = boxCorners({ 0.5, 0.25, 0.125 });
  for (int k = 0; k < 200; ++k)
    points.push_back(random.pointIn({ Vector3d(-0.5, -0.25, -0.125), Vector3d(0.5, 0.25, 0.125) }));
  points.emplace_back(0.5, 0.0, 0.0);    // on a face
  points.emplace_back(0.5, 0.25, 0.01);  // on an edge
  const ShapePtr shape = makePolytope(points);
  EXPECT_EQ(shape->name(), "polytope of 8 corners");
  EXPECT_EQ(shape->kind(), "polytope");
  EXPECT_EQ(shape->extremePoints().size(), 8u);
  EXPECT_LE(shape->volume(1.0).lower(), 0.125);
  EXPECT_GE(shape->volume(1.0).upper(), 0.125);
  EXPECT_LT(shape->volume(1.0).width(), 1e-14);
  EXPECT_EQ(convexHull(points).size(), 12u);
}

TEST(Polytope, standsOnItsLowestFace)
{
  RegionQuery query = test::queryFor(makePolytope(boxCorners({ 0.5, 1.0, 0.25 })), 2e-3);
  PlaceWish place;
  place.base_z = -0.25;
  setPlace(place, query);
  const LargestRegion standing = test::expectProven(orthoglide(), query);
  EXPECT_EQ(standing.center.z(), -0.25);
  EXPECT_EQ(standing.shape->lower().at(1.0).z(), 0.0);
  query = test::queryFor(makeBox({ 1.0, 2.0, 0.5 }), 2e-3);
  setPlace(place, query);
  const LargestRegion box = test::expectProven(orthoglide(), query);
  EXPECT_LE(box.size, standing.size_upper_bound);
  EXPECT_LE(standing.size, box.size_upper_bound);
  query.shape = makePolytope({ { 0, 0, 1 }, { 1, 0, -1 }, { -1, 1, -0.5 }, { -1, -1, -0.5 } });  // on one corner
  test::expectThrow<std::invalid_argument>(
      [&] { setPlace(place, query); },
      "base_z asks for a polytope about a point of its lowest face, and moves it there where that is exact: give");
}

TEST(Polytope, refusesWhatIsNone)
{
  const auto refused = [](const Points& points, const std::string& why) {
    test::expectThrow<std::invalid_argument>([&] { makePolytope(points); }, why);
  };
  refused({}, "vertices are 0: a polytope has at least 4");
  refused({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 } }, "vertices are 3: a polytope has at least 4");
  refused({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 1, 1, 0 }, { 0.5, 0.5, 1e-9 } }, "vertices lie in one plane");
  refused(Points(5, Vector3d::Ones()), "vertices lie in one plane");
  refused({ { 0, 0, 0 }, { 1, 1, 1 }, { 2, 2, 2 }, { 3, 3, 3 } }, "vertices lie in one plane");
  refused({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, NAN, 0 }, { 0, 0, 1 } }, "\\(0, nan, 0\\) m; they must be finite");
  refused({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1e10, 0 }, { 0, 0, 1 } }, "must be finite, within 1e9 m");
  refused(
      { { 1, 1, 1 }, { 2, 1, 1 }, { 1, 2, 1 }, { 1, 1, 2 } },
      "lie around another point than \\(0, 0, 0\\) m.*as seen from a point of it, such as \\(1.25, 1.25, 1.25\\) m");
  refused({ { 0, 0, 0 }, { 1e-10, 0, 0 }, { 0, 1e-10, 0 }, { 0, 0, 1e-10 } }, "measure 1e-10 m; allowed: from 1e-9 m");
  RandomBoxes random(SEED);
  Points ball;
  for (int k = 0; k < 600; ++k)
    ball.push_back(random.pointIn({ Vector3d::Constant(-1.0), Vector3d::Constant(1.0) }).normalized());
  refused(ball, "vertices have a hull of more than 256 corners.*coarser mesh");
  refused(Points(MOST_VERTICES + 1, Vector3d::Ones()), "vertices are 100001; allowed: 4 to 100000");
}
}  // namespace pkm_workspace
