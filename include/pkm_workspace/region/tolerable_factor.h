// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>

#include "pkm_workspace/dexterity/point_evaluation.h"
#include "pkm_workspace/region/bad_machine.h"
#include "pkm_workspace/region/containment.h"
#include "pkm_workspace/region/solid.h"

namespace pkm_workspace
{
/// How exactly a machine has to be built for a region: asked by `pkm tolerate`.
struct FactorQuery
{
  Criterion criterion;
  Solid solid;
  Eigen::Vector3d center = Eigen::Vector3d::Zero();  ///< [m]
  double accuracy = 1e-3;                            ///< wanted ratio of the bounds, less 1
  Budget budget;
  /// Called with the best factors so far, that holds and that fails, if given.
  std::function<void(double, double)> tell = {};
};

/// The machine's tolerances times a factor: the region is good on all machines within `holds` of them, and bad on one
/// within `fails`.
struct TolerableFactor
{
  double holds = 0.0;                        ///< 0: not even the machine that was meant is proved to have it
  double fails = INF;                        ///< INF: none is proved bad within what tolerances may be
  bool is_closed = false;                    ///< whether both are as close as asked for
  std::optional<Eigen::Vector3d> bad_point;  ///< for `fails` [m]
  std::optional<Machine> bad_machine;        ///< proved to be bad there, where one could be named
  std::optional<Limit> bad_limit;            ///< what it breaks there
  std::vector<ToleranceShare> shares;        ///< the largest first; those that matter
  std::int64_t boxes = 0;
  double seconds = 0.0;
};

/// @param machine with tolerances @throws std::invalid_argument where it has none, or the question is not valid
TolerableFactor tolerableFactor(const Machine& machine, const FactorQuery& query);

/// The same tolerances times a factor. Angles at most as large as is allowed.
Tolerances scaled(Tolerances tolerances, double factor);
}  // namespace pkm_workspace
