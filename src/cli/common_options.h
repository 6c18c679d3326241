// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "options.h"
#include "pkm_workspace/region/largest_region.h"
#include "pkm_workspace/urdf_io/urdf_reader.h"

namespace pkm_workspace
{
namespace cli
{
/// --urdf, --rails, --tcp-links: read while the options are, so that all problems are told at once.
class MachineOptions
{
public:
  void declare(Options& options);
  /// @pre the options have been parsed
  const Machine& machine() const { return urdf_->machine; }
  /// What is in the URDF and not used.
  const Words& warnings() const { return urdf_->warnings; }

private:
  std::string path_;
  UrdfOptions names_;
  std::optional<UrdfMachine> urdf_;
};

/// --shape, --proportions, --ratio.
class ShapeOptions
{
public:
  /// Sets the shape and ratio of the query.
  void declare(Options& options, RegionQuery& query);

private:
  std::string name_ = "cube";
  std::optional<Eigen::Vector3d> proportions_;
  std::optional<RatioRange> ratio_;
};

/// --psi-min, --psi-max, --joint-limits.
void declareCriterion(Options& options, Criterion& criterion);

constexpr std::int64_t MOST_BOXES = 1000000000000;

/// --time-limit, --max-boxes, --threads.
void declareBudget(Options& options, Budget& budget);
}  // namespace cli
}  // namespace pkm_workspace
