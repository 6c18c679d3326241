// SPDX-License-Identifier: BSD-3-Clause
#include "mesh_shading.h"

#include <Eigen/Geometry>

namespace pkm_workspace
{
namespace
{
constexpr float DARKEST = 0.2F;
/// Cosine of the angle between faces from which on an edge is seen between them.
constexpr double CREASE = 0.75;

/// Twice the area, along the direction outwards.
Eigen::Vector3d areaOf(const PaintedTriangle& triangle)
{
  const auto& [a, b, c] = triangle.corners;
  return (b - a).cross(c - a);
}

/// Of a lamp above and to the left of whoever looks along -x and -y, as rviz does at first: nothing is without light.
float lightOn(const Eigen::Vector3d& normal)
{
  static const Eigen::Vector3d LAMP = Eigen::Vector3d(0.75, 0.15, 0.65).normalized();
  const auto light = static_cast<float>(0.5 + 0.5 * normal.dot(LAMP));
  return DARKEST + (1.0F - DARKEST) * light;
}

/// The triangles at each vertex, by their numbers.
std::vector<std::vector<std::uint32_t>> trianglesAt(const Mesh& mesh)
{
  std::vector<std::vector<std::uint32_t>> at(mesh.vertices.size());
  for (std::size_t n = 0; n < mesh.triangles.size(); ++n)
    for (const std::uint32_t vertex : mesh.triangles[n])
      at[vertex].push_back(static_cast<std::uint32_t>(n));
  return at;
}
}  // namespace

Eigen::Vector3d outwards(const PaintedTriangle& triangle)
{
  return areaOf(triangle).normalized();
}

PaintedSurface shaded(const Mesh& mesh)
{
  std::vector<PaintedTriangle> all;
  std::vector<Eigen::Vector3d> areas;
  for (const auto& triangle : mesh.triangles)
  {
    PaintedTriangle& next = all.emplace_back();
    for (std::size_t k = 0; k < 3; ++k)
      next.corners[k] = mesh.vertices[triangle[k]].cast<double>();
    areas.push_back(areaOf(next));
  }
  const auto around = trianglesAt(mesh);
  PaintedSurface surface;
  for (std::size_t n = 0; n < all.size(); ++n)
  {
    if (!(areas[n].norm() > 0.0))
      continue;
    for (std::size_t k = 0; k < 3; ++k)
    {
      Eigen::Vector3d normal = Eigen::Vector3d::Zero();
      for (const std::uint32_t other : around[mesh.triangles[n][k]])
        if (areas[other].dot(areas[n]) >= CREASE * areas[other].norm() * areas[n].norm())
          normal += areas[other];
      all[n].shades[k] = lightOn(normal.normalized());
    }
    surface.push_back(all[n]);
  }
  return surface;
}
}  // namespace pkm_workspace
