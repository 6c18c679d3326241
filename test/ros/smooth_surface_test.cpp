// SPDX-License-Identifier: BSD-3-Clause
// Surfaces of sets as they are drawn: their colours by the definitions, their sections, their light.
#include "pkm_workspace/ros/smooth_surface.h"

#include <gtest/gtest.h>

#include <map>

#include "../../src/ros/mesh_shading.h"
#include "set_faces.h"
#include "support/cases.h"

namespace pkm_workspace
{
namespace test
{
namespace
{
using Eigen::Vector3d;

SetMeshes meshesOf(const Case& each, double resolution)
{
  MeshQuery query;
  query.criterion = each.criterion;
  query.resolution = resolution * each.machine.scale();
  return setMeshes(each.machine, query);
}

/// Where a vertical line goes into what triangles enclose (1) or out of it (-1), upwards.
std::vector<std::pair<double, int>> passesOf(const Marker& surface, double x, double y)
{
  std::vector<std::pair<double, int>> found;
  for (std::size_t i = 0; i + 2 < surface.points.size(); i += 3)
  {
    const Vector3d a = vectorOf(surface.points[i]), b = vectorOf(surface.points[i + 1]);
    const Vector3d c = vectorOf(surface.points[i + 2]);
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

int windingAt(const std::vector<std::pair<double, int>>& passes, double z)
{
  int winding = 0;
  for (const auto& [height, turn] : passes)
    winding += height < z ? turn : 0;
  return winding;
}

/// The passes of a surface that is cut off at a height, by those of the whole one. @param free whether the section is
std::vector<std::pair<double, int>> cutAt(double height, const std::vector<std::pair<double, int>>& whole, bool is_free)
{
  std::vector<std::pair<double, int>> expected;
  for (const auto& pass : whole)
    if (pass.first <= height)
      expected.push_back(pass);
  if (windingAt(whole, height) != 0 && !is_free)
    expected.emplace_back(height, -1);
  return expected;
}
}  // namespace

TEST(SmoothSurface, hasTheColorsOfWhatEndsTheSetByTheDefinitions)
{
  for (const Case& each : pictures())
  {
    if (each.name == "flat")
      continue;
    SCOPED_TRACE(each.name);
    const SetMeshes meshes = meshesOf(each, 0.08);
    const SmoothSurface set(meshes, each.machine, each.criterion, SetColors::CONDITION);
    const std::vector<Face> faces = facesOf(inNamespace(shown(set, each, 1e9), "inside")[0], each.kinds, true);
    EXPECT_EQ(meshes.inner.triangles.size(), faces.size());
    double whole = 0.0, colored = 0.0;
    int exact = 0, tried = 0;
    for (std::size_t k = 0; k < faces.size(); ++k)
    {
      whole += faces[k].area;
      colored += faces[k].kind ? faces[k].area : 0.0;
      if (k % 9 != 0 || !faces[k].kind || firstViolated(each, faces[k], meshes.resolution).empty())
        continue;
      ++tried;
      exact += firstViolated(each, faces[k], meshes.resolution).count(*faces[k].kind) > 0 ? 1 : 0;
      EXPECT_TRUE(isFirstNear(each, faces[k], meshes.resolution))
          << name(*faces[k].kind) << " at " << faces[k].middle.transpose();
    }
    EXPECT_GT(tried, 100);
    EXPECT_GE(exact, 0.97 * tried);
    EXPECT_GE(colored, each.share * whole);
    std::set<std::string> told;
    for (const LegendRow& row : set.legend())
      told.insert(row.text);
    EXPECT_EQ(each.kinds.size(), told.size());
  }
}

TEST(SmoothSurface, isCutOffAndClosedAtAHeight)
{
  const Case psi = pictures()[0];
  const SetMeshes meshes = meshesOf(psi, 0.12);
  const SmoothSurface set(meshes, psi.machine, psi.criterion, SetColors::VERDICT);
  const auto whole = shown(set, psi, 1e9);
  RandomBoxes random(SEED);
  int closed = 0, ringed = 0;
  for (const double height : { -0.5, -0.123, 0.0, 0.05, 0.4 })
  {
    const auto cut = shown(set, psi, height);
    const Marker inner = inNamespace(cut, "inside")[0], outer = inNamespace(cut, "boundary")[0];
    for (const Marker* marker : { &inner, &outer })
      for (const auto& point : marker->points)
        ASSERT_LE(point.z, height + 1e-12);
    for (int line = 0; line < cases(200); ++line)
    {
      const Vector3d at = random.pointIn(meshes.box);
      const auto in = passesOf(inNamespace(whole, "inside")[0], at.x(), at.y());
      const auto out = passesOf(inNamespace(whole, "boundary")[0], at.x(), at.y());
      const bool is_in = windingAt(in, height) != 0;
      const auto matches = [&](const auto& expected, const auto& found) {
        ASSERT_EQ(expected.size(), found.size()) << "height " << height << ", seed " << SEED << ", " << at.transpose();
        for (std::size_t k = 0; k < expected.size(); ++k)
        {
          EXPECT_EQ(expected[k].second, found[k].second);
          EXPECT_NEAR(expected[k].first, found[k].first, 1e-9);
        }
      };
      matches(cutAt(height, in, false), passesOf(inner, at.x(), at.y()));
      matches(cutAt(height, out, is_in), passesOf(outer, at.x(), at.y()));
      closed += is_in ? 1 : 0;
      ringed += !is_in && windingAt(out, height) != 0 ? 1 : 0;
    }
  }
  EXPECT_GT(closed, 100);
  EXPECT_GT(ringed, 5) << "between the two surfaces";
  EXPECT_TRUE(inNamespace(shown(set, psi, -1e9), "inside").empty());
}

TEST(SmoothSurface, showsWhatIsUndecidedOnlyWithAnOuterSurface)
{
  const Case psi = pictures()[0];
  MeshQuery query;
  query.resolution = 0.15;
  query.with_outer = false;
  const SetMeshes meshes = setMeshes(psi.machine, query);
  ASSERT_TRUE(meshes.complete);
  EXPECT_TRUE(meshes.outer.triangles.empty());
  const auto array = shown(SmoothSurface(meshes, psi.machine, psi.criterion, SetColors::CONDITION), psi, 1e9);
  EXPECT_EQ(1U, inNamespace(array, "inside").size());
  EXPECT_TRUE(inNamespace(array, "boundary").empty());
}

namespace
{
/// The unit sphere by rings of triangles.
Mesh sphere(int rings)
{
  Mesh mesh;
  const auto number = [rings](int ring, int k) {
    return static_cast<std::uint32_t>(2 * rings * ring + k % (2 * rings));
  };
  for (int ring = 0; ring <= rings; ++ring)
    for (int k = 0; k < 2 * rings; ++k)
    {
      const double up = M_PI * ring / rings, around = M_PI * k / rings;
      mesh.vertices.emplace_back(std::sin(up) * std::cos(around), std::sin(up) * std::sin(around), -std::cos(up));
    }
  for (int ring = 0; ring < rings; ++ring)
    for (int k = 0; k < 2 * rings; ++k)
    {
      mesh.triangles.push_back({ number(ring, k), number(ring, k + 1), number(ring + 1, k + 1) });
      mesh.triangles.push_back({ number(ring, k), number(ring + 1, k + 1), number(ring + 1, k) });
    }
  return mesh;
}
}  // namespace

// What is lit depends on the direction out of the solid alone, and changes smoothly with it.
TEST(SmoothSurface, isLitFromOneSideAndSmooth)
{
  std::map<std::array<double, 3>, std::pair<float, float>> seen;
  for (const PaintedTriangle& triangle : shaded(sphere(24)))
    for (std::size_t k = 0; k < 3; ++k)
    {
      const Vector3d& at = triangle.corners[k];
      const float shade = triangle.shades[k];
      const auto [place, is_new] =
          seen.emplace(std::array<double, 3>{ at.x(), at.y(), at.z() }, std::make_pair(shade, shade));
      if (!is_new && std::abs(at.z()) < 0.99)
        place->second = { std::min(place->second.first, shade), std::max(place->second.second, shade) };
    }
  float darkest = 1.0F, lightest = 0.0F;
  for (const auto& [at, shades] : seen)
  {
    EXPECT_LT(shades.second - shades.first, 1e-6F) << "an edge is seen";
    darkest = std::min(darkest, shades.first);
    lightest = std::max(lightest, shades.first);
    EXPECT_TRUE(at[2] < 0.7 || shades.first > 0.5F) << "from above";
    EXPECT_TRUE(at[2] > -0.99 || shades.first < 0.4F) << "from below";
  }
  EXPECT_GT(darkest, 0.1F);
  EXPECT_LT(darkest, 0.25F);
  EXPECT_GT(lightest, 0.95F);
  EXPECT_LE(lightest, 1.0F);
}

TEST(SmoothSurface, hasEdgesBetweenFacesOfACube)
{
  Mesh cube;
  for (int k = 0; k < 8; ++k)
    cube.vertices.emplace_back(float(k & 1), float(k >> 1 & 1), float(k >> 2 & 1));
  for (const auto& [a, b, c, d] : std::vector<std::array<std::uint32_t, 4>>{
           { 0, 2, 3, 1 }, { 4, 5, 7, 6 }, { 0, 1, 5, 4 }, { 2, 6, 7, 3 }, { 0, 4, 6, 2 }, { 1, 3, 7, 5 } })
  {
    cube.triangles.push_back({ a, b, c });
    cube.triangles.push_back({ a, c, d });
  }
  std::set<float> shades;
  for (const PaintedTriangle& triangle : shaded(cube))
  {
    EXPECT_GT(outwards(triangle).dot(triangle.corners[0] - Vector3d::Constant(0.5)), 0.0);
    EXPECT_EQ(triangle.shades[0], triangle.shades[1]);
    EXPECT_EQ(triangle.shades[0], triangle.shades[2]);
    shades.insert(triangle.shades[0]);
  }
  EXPECT_EQ(6U, shades.size());
  cube.triangles.push_back({ 0, 1, 1 });
  EXPECT_EQ(12U, shaded(cube).size()) << "what has no area has no light";
}
}  // namespace test
}  // namespace pkm_workspace
