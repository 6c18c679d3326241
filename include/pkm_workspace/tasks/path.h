// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "pkm_workspace/region/beyond_limits.h"
#include "pkm_workspace/region/path_check.h"

namespace pkm_workspace
{
/// How fast a path is gone along, and what is asked about that.
struct PathRatesTask
{
  /// Constant along the path [m/s]: the joints have to keep their limits then. Without it none is held, and joint
  /// speeds are those for 1 m/s.
  std::optional<double> tool_speed = {};
  bool largest_feed = false;  ///< the largest feed is asked for, which a tool speed asks for too
  /// The largest speeds of the joints are left aside: those of the criterion, and the machine's where it has none.
  bool joint_speeds_off = false;
  bool steps_have_speeds = false;  ///< the segments bring the tool's speeds themselves, at which limits are held
  std::vector<double> joint_acceleration_max = {};  ///< one number for all joints, one for each, or none [m/s^2]

  bool isHeld() const { return steps_have_speeds || tool_speed.has_value(); }
  bool isAsked() const { return largest_feed || tool_speed.has_value(); }
  /// Appends one sentence for each value that is out of range or without effect.
  void validate(Problems& problems) const;
};

/// What the joints are held against: the largest speeds that the criterion has in place of the machine's, and these.
/// @throws std::invalid_argument when the rates are not valid
JointRateLimits limitsOf(const PathRatesTask& rates, const Machine& machine, const Criterion& criterion);

/// A path, and what is asked of it besides its criterion.
struct PathTask
{
  PathQuery query;  ///< but for speed and limits, which follow from the rates
  PathRatesTask rates;
  /// Hands out the segments, in their order.
  std::function<void(const std::function<void(const PathStep&)>& use)> for_each;
  PathChecker::Tell tell;                                 ///< told the answer about each segment, in their order
  std::function<std::string(std::size_t segment)> place;  ///< names a segment by its index, or id: "segment 3"
  std::function<std::string()> stopped_by;  ///< what has set the stop flag: "a request to stop", which it is without it
};

struct PathReport
{
  PathQuery query;                      ///< as it was asked
  PathResult result;                    ///< the list of its segments is left empty
  std::optional<JointReaches> reaches;  ///< along a path that is inside, where joint limits are left aside
  std::string message;                  ///< what is proved, and what that means for limits that are left aside
};

/// @throws std::invalid_argument when the query is not valid, and what for_each throws
PathReport checkPath(const PointEvaluator& evaluator, const PathTask& task);
}  // namespace pkm_workspace
