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
  /// @param other file that will be written, too
  void declare(Options& options, const std::string& other);
  bool areAsked() const { return !inner_.empty() || !outer_.empty(); }

  /// Where there are none, save() says why.
  void compute(const Machine& machine, const PavingQuery& query);
  /// Nothing where they are not asked for.
  void addTo(Json& json) const;
  std::vector<Words> rows() const;
  /// @throws std::invalid_argument where there are none, or a file cannot be written
  void save(const Machine& machine) const;

private:
  std::string inner_;
  std::string outer_;
  std::optional<SetMeshes> meshes_;
  std::string why_none_;
  Criterion criterion_;
};
}  // namespace cli
}  // namespace pkm_workspace
