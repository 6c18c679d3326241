// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "pkm_workspace/paving/paving.h"

namespace pkm_workspace
{
/// Whether a path of points that satisfy a criterion leads from one point to another one.
struct ConnectionTask
{
  /// Criterion, box and budget. Without a box the answer is about all points of the set.
  PavingQuery query;
  /// The finest that is tried [m], > 0; without it, the default of a paving, halved MOST_HALVINGS times.
  std::optional<double> resolution;
  Eigen::Vector3d from;  ///< [m]
  Eigen::Vector3d to;    ///< [m]

  static constexpr int MOST_HALVINGS = 5;
  /// Appends one sentence for each thing that is wrong with query and points.
  void validate(Problems& problems) const;
};

struct ConnectionReport
{
  enum class Verdict
  {
    CONNECTED,  ///< every point of the path is proved to satisfy the criterion
    APART,      ///< no path in the set, or in its part in the box, joins the points, which are in it
    OUTSIDE,    ///< one of the points is proved not to satisfy the criterion
    OPEN        ///< a finer resolution may settle it
  };
  Verdict verdict = Verdict::OPEN;
  std::vector<Eigen::Vector3d> path = {};         ///< with CONNECTED: from, corners, to [m]
  std::optional<Eigen::Vector3d> bad_point = {};  ///< with OUTSIDE: the one that is [m]
  Paving paving;                                  ///< the last one; in a flat box where nothing changes along the rails
  double seconds = 0.0;
  std::string message;  ///< what is proved
};

/// Paves finer and finer until that settles it.
/// @throws std::invalid_argument for a task that is not valid or a set without bounds, with all reasons
ConnectionReport connect(const Machine& machine, const ConnectionTask& task);
}  // namespace pkm_workspace
