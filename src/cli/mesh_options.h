// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "options.h"
#include "output.h"
#include "pkm_workspace/paving/paving.h"
#include "pkm_workspace/paving/set_mesh.h"

namespace pkm_workspace
{
namespace cli
{
/// The surfaces of a set in files.
class MeshOptions
{
public:
  void declare(Options& options);
  bool areAsked() const { return !inner_.empty() || !outer_.empty(); }

  /// @throws std::invalid_argument where there are none
  void compute(const Machine& machine, const PavingQuery& query);
  /// Nothing where they are not asked for.
  void addTo(Json& json) const;
  std::vector<Words> rows() const;
  void save(const Machine& machine) const;

private:
  std::string inner_;
  std::string outer_;
  std::optional<SetMeshes> meshes_;
  Criterion criterion_;
};
}  // namespace cli
}  // namespace pkm_workspace
