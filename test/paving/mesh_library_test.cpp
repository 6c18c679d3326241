// SPDX-License-Identifier: BSD-3-Clause
// Surfaces as a library for meshes sees them, and points of their solids against the definitions.
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/orientation.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Side_of_triangle_mesh.h>
#include <CGAL/Surface_mesh.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "pkm_workspace/machine/catalogue.h"
#include "pkm_workspace/paving/set_mesh.h"
#include "support/cases.h"
#include "support/every_criterion.h"
#include "support/oracle.h"

namespace pkm_workspace
{
namespace
{
namespace pmp = CGAL::Polygon_mesh_processing;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Surface = CGAL::Surface_mesh<Kernel::Point_3>;
using SideOf = CGAL::Side_of_triangle_mesh<Surface, Kernel>;
using test::SEED;

/// @return the mesh as the library has it, which is found to be closed, oriented outwards and free of intersections
Surface checkedSurface(const Mesh& mesh)
{
  std::vector<Kernel::Point_3> points;
  for (const Eigen::Vector3f& vertex : mesh.vertices)
    points.emplace_back(vertex.x(), vertex.y(), vertex.z());
  Surface surface;
  const bool is_manifold = pmp::is_polygon_soup_a_polygon_mesh(mesh.triangles);
  EXPECT_TRUE(is_manifold);
  if (!is_manifold || mesh.triangles.empty())
    return surface;
  pmp::polygon_soup_to_polygon_mesh(points, mesh.triangles, surface);
  EXPECT_EQ(mesh.triangles.size(), surface.number_of_faces());
  EXPECT_TRUE(surface.is_valid(false));
  EXPECT_TRUE(CGAL::is_closed(surface));
  EXPECT_FALSE(pmp::does_self_intersect(surface));
  EXPECT_TRUE(pmp::does_bound_a_volume(surface));
  return surface;
}

Kernel::Point_3 fromEigen(const Eigen::Vector3d& point)
{
  return { point.x(), point.y(), point.z() };
}

/// @param points of the inner solid that are tried, at most @return how many were
int expectSurfaces(const test::MachineCase& each, double resolution, int points)
{
  SCOPED_TRACE(each.name);
  MeshQuery query;
  query.criterion = each.criterion;
  query.resolution = resolution;
  const SetMeshes meshes = setMeshes(each.machine, query);
  EXPECT_TRUE(meshes.complete);
  const Surface inner = checkedSurface(meshes.inner), outer = checkedSurface(meshes.outer);
  if (inner.is_empty() || outer.is_empty())
    return 0;
  Eigen::AlignedBox<double, 3> around;
  for (const Eigen::Vector3f& vertex : meshes.inner.vertices)
    around.extend(vertex.cast<double>());
  const SideOf inner_side(inner), outer_side(outer);
  const test::Oracle oracle(each.machine, each.criterion);
  test::RandomBoxes random(SEED);
  int found = 0;
  for (long tries = 0; found < points && tries < 50L * points; ++tries)
  {
    const Eigen::Vector3d point = random.pointIn({ around.min(), around.max() });
    const bool is_in = inner_side(fromEigen(point)) == CGAL::ON_BOUNDED_SIDE;
    found += is_in ? 1 : 0;
    EXPECT_TRUE(!is_in || oracle.isGood(point)) << "seed " << SEED << ", " << point.transpose();
    EXPECT_TRUE(!is_in || outer_side(fromEigen(point)) == CGAL::ON_BOUNDED_SIDE) << point.transpose();
  }
  for (const Eigen::Vector3f& vertex : meshes.inner.vertices)
    EXPECT_EQ(CGAL::ON_BOUNDED_SIDE, outer_side(fromEigen(vertex.cast<double>()))) << vertex.transpose();
  return found;
}
}  // namespace

TEST(MeshLibrary, dextrousSetOfTheOrthoglide)
{
  const int points = test::cases(10000);
  EXPECT_EQ(points, expectSurfaces({ "dextrous", orthoglide(), Criterion() }, 0.06, points));
}

TEST(MeshLibrary, everyCondition)
{
  int points = 0;
  for (const test::MachineCase& each : test::everyCondition(test::crooked(1)))
    points += expectSurfaces(each, 0.3, test::cases(50));
  EXPECT_GT(points, test::cases(500));
}
}  // namespace pkm_workspace
