// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "pkm_workspace/dexterity/point_evaluation.h"

namespace pkm_workspace
{
/// What the enclosures of a limit prove, as one phrase for people: "the largest velocity transmission factor is 2.31,
/// above 2". Where six digits do not tell value and bound apart, it says by how much they differ at the most:
/// "joint 'rail_x' would be below its limit of 0 m, by at most 8.7e-17 m"; and where the enclosures do not tell them
/// apart either, that the value reaches its bound, to within so much.
/// @param machine whose legs the limit counts
std::string describe(const Limit& limit, const Machine& machine);

/// The same in short, for pictures: "tool speed 0.412 m/s, at least 0.4 asked (rail_x)". As describe() where three
/// digits do not tell value and bound apart, and where nothing is asked for by a number.
std::string brief(const Limit& limit, const Machine& machine);

/// A condition as legends have it: "tool speed at least 0.4 m/s", "joint upper limit".
std::string briefly(Limit::Kind kind, const Criterion& criterion);

/// What of the criterion a point violates, one phrase each. Empty for a good point, and for a bad one that enclosures
/// do not tell from a good one.
std::vector<std::string> violations(const PointEvaluation& there, const Machine& machine);
}  // namespace pkm_workspace
