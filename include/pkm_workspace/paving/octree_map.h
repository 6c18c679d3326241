// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>

#include "pkm_workspace/paving/paving.h"

namespace pkm_workspace
{
/// A set as a map for planners, in the binary format of OctoMap (Hornung et al., "OctoMap: An Efficient Probabilistic
/// 3D Mapping Framework Based on Octrees", 2013). A voxel is free where all points that the library takes for points of
/// it are proved to belong to the set, occupied where not; around the box there is a layer of occupied voxels, one to
/// nine thick, and beyond that nothing is known.
struct OctreeMap
{
  /// Voxels in the longest side of a box, at most.
  static constexpr int MOST_STEPS = 400;

  double resolution = 0.0;  ///< edge of a voxel, as the file has it: with six digits [m]
  std::int64_t free_voxels = 0;
  std::int64_t occupied_voxels = 0;
  std::int64_t nodes = 0;  ///< of the tree, in which eight alike are one
  std::string tree;        ///< its bytes
  bool complete = false;   ///< otherwise the budget has ended it: there is no map
  double seconds = 0.0;

  /// Upper and lower bound in one of what the free voxels take [m^3].
  Interval freeVolume() const;
};

/// @param query with the edge of a voxel as its resolution, rounded down to six digits; boxes do not count in its
/// budget
/// @throws std::invalid_argument for a query that is not valid, a flat box, one with too many voxels or too far away
OctreeMap octreeMap(const Machine& machine, const PavingQuery& query);

/// Whether the name of a file ends in .bt, in letters of any case.
bool isOctreeFile(const std::string& path);
/// Writes the map; the file appears, or replaces the one of that name, only when all of it is on the disk.
/// @param title a comment in the file @throws std::invalid_argument with the file's name and the reason
void saveOctree(const std::string& path, const OctreeMap& map, std::string title);
}  // namespace pkm_workspace
