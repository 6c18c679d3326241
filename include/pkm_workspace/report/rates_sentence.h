// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <string>

#include "pkm_workspace/region/path_check.h"

namespace pkm_workspace
{
/// Says what is proved about the speeds and accelerations of the joints along a path: whether they keep within their
/// limits, between what the largest feed is and which joint binds, and which speeds are held against no limit. Empty
/// where neither limits nor rates are asked for.
/// @param place names a segment by its index: "segment 3" @param speeds_off whether limits of speeds are left aside
std::string describeRates(const PathResult& result, const PathQuery& query, const Machine& machine,
                          const std::function<std::string(std::size_t segment)>& place, bool speeds_off = false);

/// Which joint speeds are held against no limit: "Joint speeds are not held against a limit: they are left aside.";
/// empty where all are held.
std::string speedsNotHeld(const JointRateLimits& limits, const Machine& machine, bool speeds_off);
}  // namespace pkm_workspace
