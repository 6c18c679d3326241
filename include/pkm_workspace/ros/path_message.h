// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pkm_workspace/BindingLimit.h>
#include <pkm_workspace/CheckPath.h>
#include <pkm_workspace/EvaluatePoint.h>
#include <pkm_workspace/ToolMotion.h>

#include <functional>
#include <string>
#include <vector>

#include "pkm_workspace/tasks/path.h"

namespace pkm_workspace
{
using UseSegment = std::function<void(const PathSegment&)>;

/// Hands out the segments of a request one by one: those it lists, or lines between its poses.
/// @throws std::invalid_argument naming each segment and value that is wrong; those before the first were handed out
void forEachSegment(const CheckPath::Request& request, const UseSegment& use);

/// What a request asks about the joints' rates. @param joint_acceleration_max where it has none [m/s^2]
PathRatesTask ratesOf(const CheckPath::Request& request, const std::vector<double>& joint_acceleration_max);

/// The frame that a request is made in. @throws std::invalid_argument where it names two
std::string frameOf(const CheckPath::Request& request);

/// @param machine whose legs the limit counts
BindingLimit toMessage(const Limit& limit, const Machine& machine);

ToolMotion toMessage(const PathMotion& motion);

/// Fills all that the evaluation tells.
void fill(const PointEvaluation& evaluation, const PointEvaluator& evaluator, EvaluatePoint::Response& response);
/// Adds what is told of one segment.
void addRates(const SegmentCheck& check, JointRates& rates);
/// All but what is told of each segment.
void fill(const PathReport& report, const Machine& machine, CheckPath::Response& response);
}  // namespace pkm_workspace
