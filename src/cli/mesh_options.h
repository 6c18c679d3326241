// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "options.h"
#include "output.h"
#include "pkm_workspace/paving/octree_map.h"
#include "pkm_workspace/paving/set_mesh.h"
#include "progress.h"

namespace pkm_workspace
{
namespace cli
{
/// A set in files for others: its surfaces, its map.
class MeshOptions
{
public:
  /// @param other file that will be written, too
  void declare(Options& options, const std::string& other);
  /// How many computations are asked for.
  int count() const { return (hasMeshes() ? 1 : 0) + (map_file_.empty() ? 0 : 1); }

  /// Where there are none, save() says why.
  void compute(const Machine& machine, const PavingQuery& query, const std::function<Progress()>& progress);
  /// Nothing where they are not asked for.
  void addTo(Json& json) const;
  std::vector<Words> rows() const;
  /// @throws std::invalid_argument where there are none, or a file cannot be written
  void save(const Machine& machine) const;

private:
  bool hasMeshes() const { return !inner_.empty() || !outer_.empty(); }
  void computeMeshes(const Machine& machine, const PavingQuery& query, Progress progress);
  void computeMap(const Machine& machine, PavingQuery query, Progress progress);

  std::string inner_;
  std::string outer_;
  std::string map_file_;
  std::optional<SetMeshes> meshes_;
  std::optional<OctreeMap> map_;
  std::string why_no_mesh_;
  std::string why_no_map_;
  Criterion criterion_;
};
}  // namespace cli
}  // namespace pkm_workspace
