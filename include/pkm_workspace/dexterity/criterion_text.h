// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <functional>
#include <string>

#include "pkm_workspace/dexterity/criterion.h"
#include "pkm_workspace/machine/machine.h"

namespace pkm_workspace
{
/// Where a value of this name comes from that nobody gave, "the default" for instance; empty for one that was given.
using Origin = std::function<std::string(const std::string& name)>;

/// The same as Criterion::validate(), with the origin of values that nobody gave.
void validateCriterion(const Criterion& criterion, const Origin& origin, Problems& problems);

/// What options, parameters and answers call them, in the order of the enumerations.
inline constexpr std::array<const char*, 2> SET_NAMES = { "dextrous", "reachable" };
inline constexpr std::array<const char*, 3> ASPECT_NAMES = { "own", "other", "both" };

std::string name(Criterion::Set set);
std::string name(Criterion::Aspect aspect);

/// "dextrous" or "reachable", and in which aspect: "dextrous in the machine's own aspect".
std::string quality(const Criterion& criterion);
/// The same of points of all machines within tolerances, where it has any: ".. on every machine within its tolerances".
std::string quality(const Machine& machine, const Criterion& criterion);
}  // namespace pkm_workspace
