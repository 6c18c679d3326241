// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "pkm_workspace/dexterity/point_evaluation.h"
#include "pkm_workspace/machine/tolerances.h"

namespace pkm_workspace
{
/// What one kind of tolerance of one leg takes off the margin at the place that binds.
struct ToleranceShare
{
  const ToleranceKind* kind;
  int leg;
  double share;  ///< of all that is lost there, 0 to 1
};

/// Of all machines within tolerances one that is bad at a point.
struct BadMachine
{
  std::optional<Machine> machine;      ///< proved to be bad there, where one could be named
  std::optional<Limit> limit;          ///< what it breaks there
  std::vector<ToleranceShare> shares;  ///< the largest first; those that matter
};

/// @param point [m] at which one of them is bad
BadMachine badMachineAt(const Machine& all, const Criterion& criterion, const Eigen::Vector3d& point);
}  // namespace pkm_workspace
