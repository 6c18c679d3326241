// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/paving/set_mesh.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>

#include "pkm_workspace/interval/text_stream.h"
#include "pkm_workspace/paving/paving.h"
#include "proved_solid.h"

namespace pkm_workspace
{
namespace
{
using Eigen::Vector3d;
using Id = Lattice::Id;
using Tetrahedron = std::array<Id, 4>;

/// The solid of the inner surface, and how far what may belong to the set is from it.
class Gap
{
public:
  Gap(const ProvedSolid& inner, const ProvedSolid& complement, const Mesh& inner_mesh)
    : lattice_(inner.lattice()), inner_(inner), complement_(complement)
  {
    for (const Eigen::Vector3f& vertex : inner_mesh.vertices)
      near_[lattice_.cubeOf(vertex.cast<double>())].push_back(vertex.cast<double>());
  }

  /// An upper bound of the distance.
  double largest() const
  {
    std::vector<Id> cubes = inner_.borderCubes();
    cubes.insert(cubes.end(), complement_.borderCubes().begin(), complement_.borderCubes().end());
    sortUnique(cubes);
    double largest = 0.0;
    for (const Id cube : cubes)
      lattice_.eachTetrahedron(
          cube, [&](const Tetrahedron& each) { largest = std::max(largest, distanceIn(cube, each, largest)); });
    constexpr double ROUNDINGS = 0x1p-40;
    return std::isfinite(largest) ? (Interval(largest) * Interval(1.0 + ROUNDINGS)).upper() : largest;
  }

private:
  /// What of a tetrahedron is not proved to be out of the set, by its corners.
  std::vector<Vector3d> outerPart(const Tetrahedron& tetrahedron) const
  {
    std::vector<Vector3d> corners;
    for (const Id a : tetrahedron)
      if (!complement_.has(a))
      {
        corners.push_back(lattice_.point(a));
        for (const Id b : tetrahedron)
          if (complement_.has(b))
            corners.push_back(complement_.crossing(lattice_.edge(a, b)).cast<double>());
      }
    return corners;
  }

  /// A distance from a convex set is largest at a corner. @param known no more than this is of no interest
  double distanceIn(Id cube, const Tetrahedron& tetrahedron, double known) const
  {
    const std::vector<Vector3d> outer = outerPart(tetrahedron);
    SmallHull inner;
    const std::size_t count = outer.empty() ? 0 : inner_.part(tetrahedron, inner);
    double largest = count > 0 || outer.empty() ? 0.0 : INF;
    for (const Vector3d& corner : outer)
    {
      double least = INF;
      for (std::size_t k = 0; k < count; ++k)
        least = std::min(least, (corner - inner[k]).norm());
      largest = std::max(largest, least);
    }
    return largest > known ? std::min(largest, distanceAround(cube, outer)) : largest;
  }

  /// From one point of the solid, in the nearest cubes that have any of its surface.
  double distanceAround(Id cube, const std::vector<Vector3d>& outer) const
  {
    const LatticePoint at = lattice_.place(cube);
    const int most = *std::max_element(lattice_.cubes().begin(), lattice_.cubes().end());
    double least = INF;
    for (int ring = 1; ring <= most && least == INF; ++ring)
      for (int x = at[0] - ring; x <= at[0] + ring; ++x)
        for (int y = at[1] - ring; y <= at[1] + ring; ++y)
          for (int z = at[2] - ring; z <= at[2] + ring; ++z)
          {
            const LatticePoint place{ x, y, z };
            const auto found = lattice_.isCube(place) ? near_.find(lattice_.id(place)) : near_.end();
            for (std::size_t k = 0; found != near_.end() && k < found->second.size(); ++k)
            {
              double farthest = 0.0;
              for (const Vector3d& corner : outer)
                farthest = std::max(farthest, (corner - found->second[k]).norm());
              least = std::min(least, farthest);
            }
          }
    return least;
  }

  const Lattice& lattice_;
  const ProvedSolid& inner_;
  const ProvedSolid& complement_;
  std::unordered_map<Id, std::vector<Vector3d>> near_;  ///< vertices of its surface, by cubes
};
}  // namespace

Interval Mesh::volume() const
{
  Interval sum;
  for (const auto& triangle : triangles)
  {
    std::array<IntervalVector, 3> corner;
    for (std::size_t k = 0; k < 3; ++k)
      corner[k] = enclose(Vector3d(vertices[triangle[k]].cast<double>()));
    sum += dot(corner[0], cross(corner[1], corner[2]));
  }
  return sum / Interval(6.0);
}

void MeshQuery::validate(Problems& problems) const
{
  criterion.validate(problems);
  validatePositive("resolution", resolution, "m", problems);
  budget.validate(problems);
  if (box)
    validateBox("box", *box, problems);
}

SetMeshes setMeshes(const Machine& machine, const MeshQuery& query)
{
  validated(query);
  const RunningBudget budget(query.budget);
  SetMeshes meshes;
  meshes.box = query.box ? *query.box : defaultBox(machine, query.criterion);
  meshes.resolution = query.resolution;
  if (!((meshes.box.upper - meshes.box.lower).array() > 0.0).all())
    throw std::invalid_argument("a surface needs a box with three sides: this one is flat");
  if (meshes.box.maxWidth() > MeshQuery::MOST_STEPS * query.resolution)
  {
    TextStream text;
    text << "resolution = " << query.resolution << " m must be at least 1/" << MeshQuery::MOST_STEPS
         << " of the longest side of the box, " << meshes.box.maxWidth() << " m, for a surface";
    throw std::invalid_argument(text.str());
  }
  const BoxTest test(machine, query.criterion);
  // the set ends at the faces of a box that is asked for, and a little before those of another one
  const Vector3d around = Vector3d::Constant(query.box ? 0.0 : 0.5 * query.resolution);
  const Box limit{ meshes.box.lower - around, meshes.box.upper + around };
  const Lattice lattice = query.box ? Lattice::fitted(limit, query.resolution) : Lattice(limit, query.resolution);
  ThreadPool pool(query.budget.threads);
  ProvedSolid inner(test, limit, lattice, BoxVerdict::INSIDE, pool, budget);
  ProvedSolid complement(test, limit, lattice, BoxVerdict::OUTSIDE, pool, budget);
  meshes.complete = inner.prove(query.progress) && (!query.with_outer || complement.prove(query.progress));
  if (meshes.complete)
    meshes.inner = inner.surface();
  if (meshes.complete && query.with_outer)
  {
    meshes.outer = complement.surface();
    for (auto& triangle : meshes.outer.triangles)
      std::swap(triangle[1], triangle[2]);
    meshes.distance = Gap(inner, complement, meshes.inner).largest();
  }
  meshes.seconds = budget.seconds();
  return meshes;
}
}  // namespace pkm_workspace
