// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "pkm_workspace/common/budget.h"
#include "pkm_workspace/dexterity/verdict.h"

namespace pkm_workspace
{
/// A closed surface of triangles: each edge is once in each direction, seen from outside they turn to the left.
struct Mesh
{
  std::vector<Eigen::Vector3f> vertices;                ///< [m]
  std::vector<std::array<std::uint32_t, 3>> triangles;  ///< by their vertices

  /// Encloses the volume within it [m^3].
  Interval volume() const;
};

/// How far a surface is.
struct MeshProgress
{
  bool outer = false;      ///< which one
  std::size_t border = 0;  ///< cubes in which it may end, as far as they are known
  std::size_t open = 0;    ///< of these, cubes whose parts are to be proved yet, or again
};

/// What to mesh. Values with defaults; validate() tells what is wrong.
struct MeshQuery
{
  /// Edges of the lattice's cubes in the longest side of a box, at most.
  static constexpr int MOST_STEPS = 400;

  Criterion criterion;
  double resolution = 0.05;                           ///< edge of the lattice's cubes [m], > 0
  std::optional<Box> box;                             ///< what is looked at [m]; without it, defaultBox()
  Budget budget;                                      ///< time, threads and the stop flag
  bool with_outer = true;                             ///< whether the outer surface and the distance are asked for
  std::function<void(const MeshProgress&)> progress;  ///< called between looks at many cubes, if given

  void validate(Problems& problems) const;
};

/// The criterion's set within a box, between two closed surfaces.
struct SetMeshes
{
  Mesh inner;  ///< all points within it belong to the set, proved
  Mesh outer;  ///< all points of the set are within it, proved; empty where it is not asked for
  /// No point within the outer one is farther from the inner one's solid [m]; INF where that is empty.
  double distance = 0.0;
  Box box;  ///< [m]
  double resolution = 0.0;
  bool complete = false;  ///< otherwise the budget has ended it: there are no meshes
  double seconds = 0.0;
};

/// Cuts the cubes of a lattice into tetrahedra, and these where the set ends: what stays is a union of convex cells,
/// each of which is proved as a whole (docs/surfaces.md). Vertices are numbers of single precision, as files have them:
/// what is proved is proved of these.
/// @throws std::invalid_argument for a query that is not valid, with all reasons, or a flat box
SetMeshes setMeshes(const Machine& machine, const MeshQuery& query);
}  // namespace pkm_workspace
