// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/region/path.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "support/cases.h"
#include "support/expect_throw.h"
#include "support/random.h"

namespace pkm_workspace
{
namespace test
{
namespace
{
using Eigen::Vector3d;

const Box SPACE{ Vector3d::Constant(-2.0), Vector3d::Constant(2.0) };
const double PI = pkm_workspace::pi().mid();
}  // namespace

TEST(PathSegment, goesFromItsStartToItsEnd)
{
  RandomBoxes random(SEED);
  for (int k = 0; k < cases(200); ++k)
  {
    const Vector3d start = random.pointIn(SPACE), center = random.pointIn(SPACE), axis = random.pointIn(SPACE);
    const double angle = random.between(-9.0, 9.0), lift = random.between(-1.0, 1.0);
    SCOPED_TRACE("seed " + std::to_string(SEED) + ", case " + std::to_string(k));
    const PathSegment arc = PathSegment::arc(start, center, axis, angle, lift);
    for (const double t : { 0.0, 0.3, 1.0 })
    {
      const Eigen::AngleAxisd turn(t * angle, axis.normalized());
      const Vector3d expected = center + turn * (start - center) + t * lift * axis.normalized();
      EXPECT_LE((arc.point(t) - expected).norm(), 1e-13);
    }
    const PathSegment circle = PathSegment::circle(start, center, axis);
    EXPECT_LE((circle.point(1.0) - start).norm(), 1e-14);
    EXPECT_TRUE(circle.curve().angle().intersects(Interval(2.0) * pkm_workspace::pi()));
    const Vector3d end = random.pointIn(SPACE);
    EXPECT_LE((PathSegment::line(start, end).point(1.0) - end).norm(), 1e-14);
  }
}

TEST(PathSegment, threePointsAndATurnMeanTheSameArc)
{
  RandomBoxes random(SEED);
  for (int k = 0; k < cases(200); ++k)
  {
    const Vector3d start = random.pointIn(SPACE), center = random.pointIn(SPACE), axis = random.pointIn(SPACE);
    const double angle = random.between(0.1, 6.2), via = random.between(0.05, 0.95);
    SCOPED_TRACE("seed " + std::to_string(SEED) + ", case " + std::to_string(k));
    const PathSegment arc = PathSegment::arc(start, center, axis, angle);
    const PathSegment through = PathSegment::arcThrough(start, arc.point(via), arc.point(1.0));
    const PathSegment to = PathSegment::arcTo(start, center, axis, arc.point(1.0));
    EXPECT_NEAR(through.curve().angle().mid(), angle, 1e-8);
    EXPECT_NEAR(to.curve().angle().mid(), angle, 1e-12);
    EXPECT_LE(to.curve().angle().width(), 1e-11);
    for (const double t : { 0.2, 0.5, 0.8 })
    {
      EXPECT_LE((through.point(t) - arc.point(t)).norm(), 1e-8);
      EXPECT_LE((to.point(t) - arc.point(t)).norm(), 1e-12);
    }
  }
}

TEST(PathSegment, anArcBackToItsStartIsTheWholeCircle)
{
  const PathSegment arc =
      PathSegment::arcTo({ 1.0, 0.0, 0.0 }, { 0.0, 0.0, 0.0 }, { 0.0, 0.0, -2.0 }, { 1.0, 0.0, 0.0 });
  EXPECT_NEAR(arc.curve().length().mid(), 2.0 * PI, 1e-14);
  EXPECT_LE((arc.point(0.25) - Vector3d(0.0, -1.0, 0.0)).norm(), 1e-15) << "clockwise about z";
}

TEST(PathSegment, refusesWhatIsNoSegment)
{
  const double nan = std::nan("");
  const Vector3d o(0.0, 0.0, 0.0), x(1.0, 0.0, 0.0), y(0.0, 1.0, 0.0), z(0.0, 0.0, 1.0);
  using Bad = std::invalid_argument;
  expectThrow<Bad>(
      [&] {
        PathSegment::line({ nan, 0.0, 0.0 }, { 0.0, 2e9, 0.0 });
      },
      "line: start .nan, 0, 0. m must be finite.*\nline: end .0, 2000000000, 0. m must");
  expectThrow<Bad>([&] { PathSegment::arc(x, o, o, nan); }, "axis .0, 0, 0. must be .*not 0\narc: angle = nan rad");
  expectThrow<Bad>([&] { PathSegment::arc(x, o, z, 1e5); }, "angle = 100000 rad must be from -10000 to 10000 rad");
  expectThrow<Bad>([&] { PathSegment::arc(x, o, z, 1.0, nan); }, "lift = nan m");
  expectThrow<Bad>([&] { PathSegment::arc(z, o, z, 1.0); }, "start .0, 0, 1. m lies on the axis");
  expectThrow<Bad>([&] { PathSegment::circle(z, o, z); }, "circle: start .* lies on the axis");
  expectThrow<Bad>([&] { PathSegment::arcThrough(x, o, -x); }, "must be farther off a line.* more than 1e-06");
  expectThrow<Bad>([&] { PathSegment::arcThrough(x, y, x); }, "must be farther off a line.* more than 1e-06");
  expectThrow<Bad>([&] { PathSegment::arcThrough(x, y, y); }, "must be farther off a line.* more than 1e-06");
  expectThrow<Bad>([&] { PathSegment::arcThrough(x, { nan, 0.0, 0.0 }, y); }, "via .nan, 0, 0. m must be finite");
  expectThrow<Bad>(
      [&] {
        PathSegment::arcTo(x, o, z, { 0.0, 1.0002, 0.0 });
      },
      "end .0, 1.000.*, 0. m is 0.000200001 m beside the circle .* radius 1 m; allowed are 1e-05 m");
  expectThrow<Bad>([&] { PathSegment::arcTo(x, o, z, { 0.0, 1.0, 0.1 }); }, "is 0.1.* m beside the circle");
  expectThrow<Bad>([&] { PathSegment::arcTo(x, o, z, { 1.0 + 1e-7, 0.0, 0.0 }); }, "in another direction");
  EXPECT_NO_THROW(PathSegment::arcTo(x, o, z, { 0.0, 1.000009, 0.0 }));
}
}  // namespace test
}  // namespace pkm_workspace
