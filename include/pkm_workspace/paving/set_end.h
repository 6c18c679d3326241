// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "pkm_workspace/dexterity/point_evaluation.h"

namespace pkm_workspace
{
/// Where a set ends on a straight line, and by which condition.
struct SetEnd
{
  ConditionKind kind;    ///< what is not satisfied any more at bad
  Eigen::Vector3d good;  ///< the last point on the line that satisfies the criterion [m]
  Eigen::Vector3d bad;   ///< the next one, which does not [m]
};

/// What ends the criterion's set near a point of its border: the first condition that is not satisfied any more on a
/// line outwards. In floating point and at a few points of the line: good for a picture, and a proof of nothing.
/// @param from a point near the border [m]; where it is bad itself, the line begins at a good point behind it
/// @param step outwards; the line is as long as four of these [m]
/// @return nothing where the points of the line are all good or all bad
std::optional<SetEnd> endOfSet(const PointEvaluator& evaluate, const Eigen::Vector3d& from,
                               const Eigen::Vector3d& step);
}  // namespace pkm_workspace
