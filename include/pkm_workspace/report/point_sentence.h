// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "pkm_workspace/dexterity/point_evaluation.h"

namespace pkm_workspace
{
/// Says what is proved about one tool point: which limit is nearest where the point is good, which ones it violates
/// where it is bad, and what a good point means for joint limits that were not asked for.
/// @param evaluator that the evaluation is from
std::string describe(const PointEvaluation& there, const PointEvaluator& evaluator);
}  // namespace pkm_workspace
