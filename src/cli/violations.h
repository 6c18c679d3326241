// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "pkm_workspace/dexterity/point_evaluation.h"
#include "values.h"

namespace pkm_workspace
{
namespace cli
{
/// A condition with its value and bound, one phrase for people: "joint 'rail_x' would be at 0.3 m, its limits are ...".
std::string describe(const Machine& machine, const Limit& limit);

/// What of the criterion a point violates, one phrase each. Empty for a good point, and for a bad one that enclosures
/// do not tell from a good one.
Words violations(const Machine& machine, const PointEvaluation& there);
Words violations(const Machine& machine, const Criterion& criterion, const Eigen::Vector3d& p);
}  // namespace cli
}  // namespace pkm_workspace
