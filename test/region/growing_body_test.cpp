// SPDX-License-Identifier: BSD-3-Clause
// Families of bodies that grow from some given measures, and what every family has to keep.
#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_bin_float.hpp>

#include "pkm_workspace/region/containment.h"
#include "pkm_workspace/region/growing_prisms.h"
#include "pkm_workspace/region/polytope.h"
#include "region/parallel_rails.h"
#include "support/body_points.h"
#include "support/cases.h"
#include "support/expect_throw.h"
#include "support/octahedron.h"
#include "support/oracle.h"

namespace pkm_workspace
{
namespace
{
using Eigen::Vector3d;
using test::cases;
using test::RandomBoxes;
using test::SEED;
using Exact = boost::multiprecision::cpp_bin_float_100;
using Offset = std::array<Exact, 3>;

/// A family, and its definition apart from it: whether K(h) holds a point.
struct GrowingFamily
{
  ShapePtr shape;
  bool (*holds)(const Offset& k, const Exact& h);
};

bool isBetween(const Exact& low, const Exact& x, const Exact& high)
{
  return low <= x && x <= high;
}

bool isRound(const Offset& k, const Exact& radius)
{
  return k[0] * k[0] + k[1] * k[1] <= radius * radius;
}

const Exact RADIUS = 0.25, HEIGHT = 0.375, SIDE_X = 0.5, SIDE_Y = 0.125;

std::vector<GrowingFamily> givenMeasures()
{
  return {
    { makeCylinderOfRadius(0.25, Stand::ON_BASE),
      [](const Offset& k, const Exact& h) { return isRound(k, RADIUS) && isBetween(0, k[2], h); } },
    { makeCylinderOfRadius(0.25, Stand::ABOUT_CENTER),
      [](const Offset& k, const Exact& h) { return isRound(k, RADIUS) && isBetween(-h / 2, k[2], h / 2); } },
    { makeCylinderOfHeight(0.375),
      [](const Offset& k, const Exact& h) { return isRound(k, h) && isBetween(-HEIGHT / 2, k[2], HEIGHT / 2); } },
    { makeBoxOnBase(0.5, 0.125),
      [](const Offset& k, const Exact& h) {
        return isBetween(-SIDE_X / 2, k[0], SIDE_X / 2) && isBetween(-SIDE_Y / 2, k[1], SIDE_Y / 2) &&
               isBetween(0, k[2], h);
      } },
    { makeBoxOfFootprint(0.5, 0.125),
      [](const Offset& k, const Exact& h) {
        return isBetween(-SIDE_X / 2, k[0], SIDE_X / 2) && isBetween(-SIDE_Y / 2, k[1], SIDE_Y / 2) &&
               isBetween(-h / 2, k[2], h / 2);
      } },
    { makeCylinderOfHeight(0.375)->standing(),
      [](const Offset& k, const Exact& h) { return isRound(k, h) && isBetween(0, k[2], HEIGHT); } },
  };
}

std::vector<GrowingFamily> growingFamilies()
{
  std::vector<GrowingFamily> all = givenMeasures();
  const GrowingFamily scaling[] = {
    { makeCube(),
      [](const Offset& k, const Exact& h) {
        return isBetween(-h / 2, k[0], h / 2) && isBetween(-h / 2, k[1], h / 2) && isBetween(-h / 2, k[2], h / 2);
      } },
    { makeSquare(),
      [](const Offset& k, const Exact& h) {
        return isBetween(-h / 2, k[0], h / 2) && isBetween(-h / 2, k[1], h / 2) && k[2] == 0;
      } },
    { makeSphere(), [](const Offset& k, const Exact& h) { return k[0] * k[0] + k[1] * k[1] + k[2] * k[2] <= h * h; } },
    { makeDisc(), [](const Offset& k, const Exact& h) { return isRound(k, h) && k[2] == 0; } },
    { makeCylinder(0.5),
      [](const Offset& k, const Exact& h) { return isRound(k, h / 2) && isBetween(-h / 2, k[2], h / 2); } },
    { makeCylinder(0.25, 0.375),
      [](const Offset& k, const Exact& h) {
        return isRound(k, h * RADIUS) && isBetween(-h * HEIGHT / 2, k[2], h * HEIGHT / 2);
      } },
    { makeCube()->standing(),
      [](const Offset& k, const Exact& h) {
        return isBetween(-h / 2, k[0], h / 2) && isBetween(-h / 2, k[1], h / 2) && isBetween(0, k[2], h);
      } },
    { makeDisc()->standing(), [](const Offset& k, const Exact& h) { return isRound(k, h) && k[2] == 0; } },
    { makeCylinder(0.5)->standing(),
      [](const Offset& k, const Exact& h) { return isRound(k, h / 2) && isBetween(0, k[2], h); } },
    { makePolytope({ { 0.5, 0, 0 }, { -0.5, 0, 0 }, { 0, 0.5, 0 }, { 0, -0.5, 0 }, { 0, 0, 0.5 }, { 0, 0, -0.5 } }),
      [](const Offset& k, const Exact& h) { return abs(k[0]) + abs(k[1]) + abs(k[2]) <= h / 2; } },
    { makePolytope(
          { { 0, 0, 0 }, { 0.5, 0, 0 }, { 0, 0.25, 0 }, { 0, 0, 1 }, { 0.125, 0.0625, 0.125 } }),  // at a corner
      [](const Offset& k, const Exact& h) {
        return k[0] >= 0 && k[1] >= 0 && k[2] >= 0 && 2 * k[0] + 4 * k[1] + k[2] <= h;
      } },
    { std::make_shared<test::Octahedron>(),
      [](const Offset& k, const Exact& h) { return abs(k[0]) + abs(k[1]) + abs(k[2]) <= h / 2; } },
  };
  all.insert(all.end(), std::begin(scaling), std::end(scaling));
  return all;
}

Offset offsetOf(const Vector3d& point, const Vector3d& center)
{
  return { Exact(point.x()) - center.x(), Exact(point.y()) - center.y(), Exact(point.z()) - center.z() };
}

Offset placeAt(const GrowingVector& k, double size)
{
  Offset place;
  for (const int axis : { 0, 1, 2 })
    place[static_cast<std::size_t>(axis)] = Exact(size) * k.per_size[axis] + k.fixed[axis];
  return place;
}

Exact dotOf(const Vector3d& n, const Offset& k)
{
  return n.x() * k[0] + n.y() * k[1] + n.z() * k[2];
}

/// Calls check(family, center, size) with numbers of many kinds.
template <class Check>
void forEachRegion(const std::vector<GrowingFamily>& of, int count, const Check& check)
{
  RandomBoxes random(SEED);
  for (const GrowingFamily& family : of)
    for (int k = 0; k < cases(count); ++k)
    {
      SCOPED_TRACE(family.shape->name() + ", " + family.shape->sizeMeaning() + ", seed " + std::to_string(SEED) +
                   ", case " + std::to_string(k));
      const Vector3d center =
          k == 0 ? Vector3d::Zero() : random.pointIn({ Vector3d::Constant(-3.0), Vector3d::Constant(3.0) });
      check(family, center, k % 10 == 1 ? 1e-9 : random.between(0.01, 2.0), random);
    }
}
}  // namespace

TEST(EveryFamily, isNested)
{
  forEachRegion(growingFamilies(), 100,
                [](const GrowingFamily& family, const Vector3d& center, double size, RandomBoxes& random) {
                  const Shape& shape = *family.shape;
                  const Box here{ center, center };
                  const double larger = size * (1.0 + random.between(0.0, 2.0));
                  const Vector3d point = test::pointOf(shape, center, size, random);
                  EXPECT_TRUE(shape.contains(point, here, size));
                  EXPECT_TRUE(shape.contains(point, here, larger));
                  EXPECT_TRUE(shape.boundingBox(center, larger).contains(point));
                  EXPECT_FALSE(shape.misses({ point, point }, center, larger));
                  EXPECT_TRUE(shape.contains(center, here, size)) << "a region holds its center";
                  const Vector3d n = random.pointIn({ Vector3d::Constant(-1.0), Vector3d::Constant(1.0) });
                  EXPECT_LE(shape.support(n).at(size), shape.support(n).at(larger));
                  EXPECT_LE(shape.volume(size).lower(), shape.volume(larger).upper());
                  for (const GrowingVector& k : shape.extremePoints())
                    EXPECT_TRUE(family.holds(placeAt(k, size), larger));
                });
}

TEST(EveryFamily, holdsWhatItsDefinitionSays)
{
  forEachRegion(growingFamilies(), 300,
                [](const GrowingFamily& family, const Vector3d& center, double size, RandomBoxes& random) {
                  const Shape& shape = *family.shape;
                  const Box bounds = shape.boundingBox(center, size);
                  const Vector3d more = Vector3d::Constant(0.1 * (bounds.upper - bounds.lower).maxCoeff());
                  const Vector3d anywhere = random.pointIn({ bounds.lower - more, bounds.upper + more });
                  const bool holds = family.holds(offsetOf(anywhere, center), size);
                  EXPECT_TRUE(holds || !shape.contains(anywhere, { center, center }, size));
                  EXPECT_TRUE(!holds || !shape.misses({ anywhere, anywhere }, center, size));
                  EXPECT_TRUE(!holds || bounds.contains(anywhere));
                  const Vector3d inside = test::pointOf(shape, center, size, random);
                  EXPECT_TRUE(family.holds(offsetOf(inside, center), size)) << inside.transpose();
                  const auto place = shape.placeOf(inside - center, size);
                  ASSERT_TRUE(place);
                  EXPECT_NEAR((place->at(size) - (inside - center)).norm(), 0.0, 1e-11 * (1.0 + size));
                  for (const double other : { size, 0.0, 1e-9, 0.3, 5.0 })
                  {
                    EXPECT_TRUE(family.holds(placeAt(*place, other), other)) << other;
                    for (const GrowingVector& k : shape.extremePoints())
                      EXPECT_TRUE(family.holds(placeAt(k, other), other)) << other;
                  }
                });
}

TEST(EveryFamily, hasItsSupportsHalfSpacesAndCircles)
{
  forEachRegion(growingFamilies(), 100,
                [](const GrowingFamily& family, const Vector3d& center, double size, RandomBoxes& random) {
                  const Shape& shape = *family.shape;
                  const Vector3d n = random.pointIn({ Vector3d::Constant(-1.0), Vector3d::Constant(1.0) });
                  const Interval support = shape.support(enclose(n)).at(size);
                  EXPECT_NEAR(shape.support(n).at(size), support.mid(), 1e-14 * (1.0 + size));
                  const Offset offset = offsetOf(test::pointOf(shape, center, size, random), center);
                  EXPECT_TRUE(dotOf(n, offset) <= support.upper());
                  const Vector3d far = center + 1e3 * n;
                  EXPECT_NEAR(n.dot(shape.nearest(far, center, size) - center), support.mid(),
                              1e-2 * (1.0 + size) * (1.0 + size));
                  const Vector3d elsewhere = random.pointIn({ Vector3d::Constant(-3.0), Vector3d::Constant(3.0) });
                  const HalfSpace half = shape.halfSpace({ elsewhere, elsewhere }, center, size);
                  const Offset absolute = { offset[0] + center.x(), offset[1] + center.y(), offset[2] + center.z() };
                  EXPECT_TRUE(dotOf(half.normal, absolute) <= half.offset);
                  for (const Circle& circle : shape.extremeCircles(center, size))
                    for (const double angle : { 0.3, 2.0, 4.0 })
                    {
                      const Vector3d rim(std::cos(angle), std::sin(angle), 0.0);
                      const Vector3d point = mid(circle.center) + (1.0 - 1e-9) * circle.radius.mid() * rim;
                      EXPECT_TRUE(nearestInside(shape, point, center, size));
                      EXPECT_NEAR((shape.nearest(point, center, size) - point).norm(), 0.0, 1e-14);
                    }
                });
}

TEST(EveryFamily, avoidsPointsWhereItSaysSo)
{
  int said = 0;
  forEachRegion(growingFamilies(), 300,
                [&](const GrowingFamily& family, const Vector3d& center, double size, RandomBoxes& random) {
                  const Shape& shape = *family.shape;
                  const double width = random.between(0.0, 0.3) * size;
                  const Box centers{ center.array() - width, center.array() + width };
                  const Vector3d point = test::pointOf(shape, center, 0.9 * size, random);
                  const auto form = shape.avoidance(point, centers, size);
                  if (!form)
                    return;
                  ++said;
                  const Vector3d other = random.pointIn(centers);
                  double value = form->center + form->radius;
                  for (const int axis : { 0, 1, 2 })
                    value += form->gradient[static_cast<std::size_t>(axis)] * (other[axis] - center[axis]) /
                             std::max(width, 1e-300);
                  EXPECT_TRUE(family.holds(offsetOf(point, other), size) || value >= -1e-12)
                      << "the region avoids the point";
                });
  EXPECT_GT(said, 100);
}

TEST(EveryFamily, isLeftThroughTheNearestSide)
{
  forEachRegion(growingFamilies(), 100,
                [](const GrowingFamily& family, const Vector3d& center, double size, RandomBoxes& random) {
                  const Shape& shape = *family.shape;
                  if (shape.name() == "octahedron")
                    return;  // any side of it does
                  const Vector3d point = center + 0.9 * (test::pointOf(shape, center, size, random) - center);
                  const Vector3d normal = shape.exit(point, center, size);
                  const double depth = shape.support(normal).at(size) - normal.dot(point - center);
                  EXPECT_NEAR(normal.norm(), 1.0, 1e-15);
                  EXPECT_GE(depth, -1e-15);
                  const Vector3d thickness = shape.halfExtents().at(size);
                  for (const int axis : { 0, 1, 2 })
                    for (const Vector3d& side : { Vector3d(Vector3d::Unit(axis)), Vector3d(-Vector3d::Unit(axis)) })
                    {
                      const double way = shape.support(side).at(size) - side.dot(point - center);
                      EXPECT_TRUE(thickness[axis] == 0.0 || depth <= way * (1.0 + 1e-12) + 1e-15) << side.transpose();
                    }
                });
}

TEST(GivenMeasures, volumesDimensionsAndNames)
{
  const ShapePtr high = makeCylinderOfRadius(0.25, Stand::ON_BASE);
  EXPECT_EQ(high->dimensions(0.5), (std::vector<double>{ 0.5, 0.25 }));
  EXPECT_NEAR(high->volume(0.5).mid(), 0.09817477042468103, 1e-16);
  EXPECT_EQ(high->name(), "cylinder of radius 0.25 m on its base");
  const ShapePtr wide = makeCylinderOfHeight(0.375);
  EXPECT_EQ(wide->dimensions(0.5), (std::vector<double>{ 0.375, 0.5 }));
  EXPECT_NEAR(wide->volume(0.5).mid(), 0.2945243112740431, 1e-15);
  const ShapePtr box = makeBoxOnBase(0.5, 0.125);
  EXPECT_EQ(box->dimensions(3.0), (std::vector<double>{ 0.5, 0.125, 3.0 }));
  EXPECT_EQ(box->volume(3.0), Interval(0.1875));
  EXPECT_TRUE(box->isBox());
  EXPECT_EQ(box->name(), "box on a base of 0.5 m x 0.125 m");
  using Bad = std::invalid_argument;
  for (const double length : { 0.0, -1.0, 1e-200, std::nan("") })
  {
    test::expectThrow<Bad>([&] { makeCylinderOfRadius(length, Stand::ON_BASE); }, "radius = .* m must be positive");
    test::expectThrow<Bad>([&] { makeCylinderOfHeight(length); }, "height = .* m must be positive");
    test::expectThrow<Bad>([&] { makeBoxOnBase(1.0, length); }, "side along y = .* m must be positive");
  }
}
}  // namespace pkm_workspace
