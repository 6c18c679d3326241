// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/paving/set_mesh.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <map>

#include "pkm_workspace/paving/set_volume.h"
#include "support/cases.h"
#include "support/every_criterion.h"
#include "support/expect_throw.h"
#include "support/oracle.h"

namespace pkm_workspace
{
namespace
{
using Eigen::Vector3d;
using test::SEED;

MeshQuery asked(const Criterion& criterion, double resolution, const std::optional<Box>& box = {})
{
  MeshQuery query;
  query.criterion = criterion;
  query.resolution = resolution;
  query.box = box;
  return query;
}

Vector3d corner(const Mesh& mesh, const std::array<std::uint32_t, 3>& triangle, std::size_t k)
{
  return mesh.vertices[triangle[k]].cast<double>();
}

/// Each edge is once in each direction.
void expectClosed(const Mesh& mesh)
{
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
  for (const auto& triangle : mesh.triangles)
    for (std::size_t k = 0; k < 3; ++k)
      ++edges[{ triangle[k], triangle[(k + 1) % 3] }];
  for (const auto& [edge, count] : edges)
  {
    ASSERT_EQ(count, 1);
    ASSERT_EQ(edges.count({ edge.second, edge.first }), 1U);
  }
}

/// Where a vertical line passes the mesh, upwards: 1 where it goes in and -1 where it goes out.
std::vector<std::pair<double, int>> passes(const Mesh& mesh, double x, double y)
{
  std::vector<std::pair<double, int>> found;
  for (const auto& triangle : mesh.triangles)
  {
    const Vector3d a = corner(mesh, triangle, 0), b = corner(mesh, triangle, 1), c = corner(mesh, triangle, 2);
    const auto turn = [&](const Vector3d& p, const Vector3d& q) {
      return (p.x() - x) * (q.y() - y) - (p.y() - y) * (q.x() - x);
    };
    const double in_a = turn(b, c), in_b = turn(c, a), in_c = turn(a, b);
    const bool is_up = in_a > 0.0 && in_b > 0.0 && in_c > 0.0;
    if (is_up || (in_a < 0.0 && in_b < 0.0 && in_c < 0.0))
      found.emplace_back((in_a * a.z() + in_b * b.z() + in_c * c.z()) / (in_a + in_b + in_c), is_up ? -1 : 1);
  }
  std::sort(found.begin(), found.end());
  return found;
}

/// Calls @p take with points of a vertical line, also close to the mesh, and whether they are within it.
template <class Take>
void eachPointAlong(const Mesh& mesh, const Box& space, double x, double y, test::RandomBoxes& random, const Take& take)
{
  std::vector<std::pair<double, int>> ends = passes(mesh, x, y);
  ends.insert(ends.begin(), { space.lower.z(), 0 });
  ends.emplace_back(space.upper.z(), 0);
  int within = 0;
  for (std::size_t k = 1; k < ends.size(); ++k)
  {
    within += ends[k - 1].second;
    ASSERT_TRUE(within == 0 || within == 1) << "at " << x << ", " << y;
    const double low = ends[k - 1].first, high = ends[k].first;
    for (const double share : { 1e-6, random.between(0.0, 1.0), random.between(0.0, 1.0), 1.0 - 1e-6 })
      take(Vector3d(x, y, low + share * (high - low)), within == 1);
  }
  EXPECT_EQ(within, 0);
}

/// No point within the inner mesh is bad, none without the outer one is good. @return how many points were tried
int expectTruth(const test::MachineCase& each, const SetMeshes& meshes, int lines)
{
  expectClosed(meshes.inner);
  expectClosed(meshes.outer);
  const test::Oracle oracle(each.machine, each.criterion);
  test::RandomBoxes random(SEED);
  const Box& box = meshes.box;
  int points = 0;
  for (int line = 0; line < lines; ++line)
  {
    const Vector3d at = random.pointIn(box);
    eachPointAlong(meshes.inner, box, at.x(), at.y(), random, [&](const Vector3d& point, bool is_within) {
      points += is_within ? 1 : 0;
      EXPECT_TRUE(!is_within || oracle.isGood(point)) << each.name << ", seed " << SEED << ", " << point.transpose();
    });
    eachPointAlong(meshes.outer, box, at.x(), at.y(), random, [&](const Vector3d& point, bool is_within) {
      points += is_within ? 0 : 1;
      EXPECT_TRUE(is_within || !oracle.isGood(point)) << each.name << ", seed " << SEED << ", " << point.transpose();
    });
  }
  return points;
}
}  // namespace

TEST(SetMesh, dextrousSetOfTheOrthoglide)
{
  const test::MachineCase each{ "dextrous", orthoglide(), Criterion() };
  const SetMeshes meshes = setMeshes(each.machine, asked(each.criterion, 0.06));
  ASSERT_TRUE(meshes.complete);
  EXPECT_GT(expectTruth(each, meshes, test::cases(1000)), 5000);
  EXPECT_LT(meshes.inner.volume().upper(), 1.6317);  // docs/volumes.md
  EXPECT_GT(meshes.inner.volume().lower(), 0.98 * 1.6315);
  EXPECT_GT(meshes.outer.volume().lower(), 1.6315);
  EXPECT_LT(meshes.outer.volume().upper(), 1.05 * 1.6317);
}

TEST(SetMesh, everyCondition)
{
  for (const test::MachineCase& each : test::everyCondition(test::crooked(1)))
  {
    SCOPED_TRACE(each.name);
    const SetMeshes meshes = setMeshes(each.machine, asked(each.criterion, 0.25));
    ASSERT_TRUE(meshes.complete);
    expectTruth(each, meshes, test::cases(30));
    EXPECT_LE(meshes.inner.volume().lower(), meshes.outer.volume().upper());
    EXPECT_EQ(std::isfinite(meshes.distance), !meshes.inner.triangles.empty() || meshes.outer.triangles.empty());
  }
}

// What is beyond the box does not count, and the surface closes at its faces.
TEST(SetMesh, withinABox)
{
  const test::MachineCase each{ "in a box", orthoglide(), Criterion() };
  // all of both is good; the sides of the second one are no multiples of the resolution
  for (const Box& box :
       { Box{ { -0.1, -0.2, -0.15 }, { 0.2, 0.1, 0.13 } }, Box{ { -0.1, -0.2, -0.15 }, { 0.211, 0.093, 0.127 } } })
  {
    const SetMeshes meshes = setMeshes(each.machine, asked(each.criterion, 0.02, box));
    expectClosed(meshes.inner);
    expectClosed(meshes.outer);
    for (const Eigen::Vector3f& vertex : meshes.inner.vertices)
      EXPECT_TRUE(box.contains(vertex.cast<double>())) << vertex.transpose();
    const double volume = box.volume().mid();
    EXPECT_LT(meshes.inner.volume().upper(), volume);
    EXPECT_GT(meshes.inner.volume().lower(), 0.97 * volume);
    EXPECT_GT(meshes.outer.volume().lower(), volume);
    EXPECT_LT(meshes.outer.volume().upper(), 1.03 * volume);
    EXPECT_LT(meshes.distance, 0.03);
  }
}

// Points of the outer solid, against all corners of the inner one: a corner is no farther than an edge from what is
// between them.
TEST(SetMesh, distanceHolds)
{
  const SetMeshes meshes = setMeshes(test::crooked(2), asked(Criterion(), 0.15));
  test::RandomBoxes random(SEED);
  int tried = 0;
  for (int line = 0; line < test::cases(100); ++line)
  {
    const Vector3d at = random.pointIn(meshes.box);
    eachPointAlong(meshes.outer, meshes.box, at.x(), at.y(), random, [&](const Vector3d& point, bool is_within) {
      if (!is_within)
        return;
      const auto below = passes(meshes.inner, point.x(), point.y());
      int within = 0;
      for (const auto& pass : below)
        within += pass.first < point.z() ? pass.second : 0;
      if (within == 1)
        return;
      double least = INF;
      for (const auto& triangle : meshes.inner.triangles)
        for (const double s : { 0.0, 0.25, 0.5, 0.75, 1.0 })
          for (double t = 0.0; s + t <= 1.0; t += 0.25)
            least = std::min(least, (point - (1.0 - s - t) * corner(meshes.inner, triangle, 0) -
                                     s * corner(meshes.inner, triangle, 1) - t * corner(meshes.inner, triangle, 2))
                                        .norm());
      EXPECT_LE(least, meshes.distance + 0.02);
      ++tried;
    });
  }
  EXPECT_GT(tried, 20);
}

TEST(SetMesh, doesNotDependOnThreads)
{
  MeshQuery query = asked(Criterion(), 0.1);
  query.budget.threads = 1;
  const SetMeshes one = setMeshes(orthoglide(), query);
  query.budget.threads = 3;
  const SetMeshes three = setMeshes(orthoglide(), query);
  EXPECT_TRUE(one.inner.vertices == three.inner.vertices);
  EXPECT_TRUE(one.outer.triangles == three.outer.triangles);
  EXPECT_EQ(one.distance, three.distance);
}

TEST(SetMesh, refusesWhatHasNoSurface)
{
  const double z = uranesx().zero().z();
  test::expectThrow<std::invalid_argument>(
      [&] {
        setMeshes(uranesx(), asked(Criterion(), 0.1, Box{ { -1.0, -1.0, z }, { 1.0, 1.0, z } }));
      },
      "flat");
  test::expectThrow<std::invalid_argument>([] { setMeshes(orthoglide(), asked(Criterion(), 1e-4)); }, "resolution");
  test::expectThrow<std::invalid_argument>([] { setMeshes(orthoglide(), asked(Criterion(), -1.0)); }, "resolution");
  std::atomic<bool> stop(true);
  MeshQuery query = asked(Criterion(), 0.1);
  query.budget.stop = &stop;
  EXPECT_FALSE(setMeshes(orthoglide(), query).complete);
}
}  // namespace pkm_workspace
