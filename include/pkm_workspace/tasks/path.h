// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "pkm_workspace/region/beyond_limits.h"
#include "pkm_workspace/region/path_check.h"

namespace pkm_workspace
{
/// A path, and what is asked of it besides its criterion.
struct PathTask
{
  PathQuery query;
  /// Hands out the segments, in their order.
  std::function<void(const std::function<void(const PathSegment&)>& use)> for_each;
  PathChecker::Tell tell;                                 ///< told the answer about each segment, in their order
  std::function<std::string(std::size_t segment)> place;  ///< names a segment by its index: "segment 3"
  std::function<std::string()> stopped_by;  ///< what has set the stop flag: "a request to stop", which it is without it
};

struct PathReport
{
  PathResult result;                    ///< the list of its segments is left empty
  std::optional<JointReaches> reaches;  ///< along a path that is inside, where joint limits are left aside
  std::string message;                  ///< what is proved, and what that means for limits that are left aside
};

/// @throws std::invalid_argument when the query is not valid, and what for_each throws
PathReport checkPath(const PointEvaluator& evaluator, const PathTask& task);
}  // namespace pkm_workspace
