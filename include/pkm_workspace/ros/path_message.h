// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pkm_workspace/BindingLimit.h>
#include <pkm_workspace/CheckPath.h>
#include <pkm_workspace/EvaluatePoint.h>

#include <functional>
#include <string>

#include "pkm_workspace/tasks/path.h"

namespace pkm_workspace
{
using UseSegment = std::function<void(const PathSegment&)>;

/// Hands out the segments of a request one by one: those it lists, or lines between its poses.
/// @throws std::invalid_argument naming each segment and value that is wrong; those before the first were handed out
void forEachSegment(const CheckPath::Request& request, const UseSegment& use);

/// The frame that a request is made in. @throws std::invalid_argument where it names two
std::string frameOf(const CheckPath::Request& request);

/// @param machine whose legs the limit counts
BindingLimit toMessage(const Limit& limit, const Machine& machine);

/// Fills all that the evaluation tells.
void fill(const PointEvaluation& evaluation, const PointEvaluator& evaluator, EvaluatePoint::Response& response);
/// All but the verdicts on the segments.
void fill(const PathReport& report, const Machine& machine, CheckPath::Response& response);
}  // namespace pkm_workspace
