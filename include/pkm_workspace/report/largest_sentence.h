// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

#include "pkm_workspace/region/beyond_limits.h"
#include "pkm_workspace/region/largest_region.h"

namespace pkm_workspace
{
/// How far each rail goes over a region; nothing where none was found.
std::optional<JointReaches> reachOver(const LargestRegion& region);

/// Says what ended the search, what can be done about it, and what the region means for joint limits that were not
/// asked for.
/// @param criterion that it is the largest region of
std::string endingOf(const LargestRegion& region, const Machine& machine, const Criterion& criterion);

/// Digits after the point with which the bracket of a size is told.
int decimalsOf(const LargestRegion& region, double accuracy);

/// Says what is proved: that every point of the region is good, where there is one, and which regions are not, with
/// their centers where they were looked for.
/// @param query that the region is the answer to
std::string describe(const LargestRegion& region, const Machine& machine, const RegionQuery& query);
}  // namespace pkm_workspace
