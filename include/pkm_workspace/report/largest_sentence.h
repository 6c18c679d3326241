// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "pkm_workspace/region/largest_region.h"

namespace pkm_workspace
{
/// Digits after the point with which the bracket of a size is told.
int decimalsOf(const LargestRegion& region, double accuracy);

/// Says what is proved: that every point of the region is good, where there is one, and which regions are not, with
/// their centers where they were looked for.
/// @param query that the region is the answer to @param at_center whether only one center was looked at
std::string describe(const LargestRegion& region, const Machine& machine, const RegionQuery& query,
                     bool at_center = false);
}  // namespace pkm_workspace
