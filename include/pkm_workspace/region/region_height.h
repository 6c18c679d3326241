// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "pkm_workspace/region/largest_region.h"

namespace pkm_workspace
{
/// Moves a region of a machine with parallel rails along them, to where its center has the height of the zero
/// configuration, or of the middle of the search box; as near to it as the joint limits and the search box leave it, to
/// 1e-7 of the longest strut. The height is the coordinate along which the rails run most. Only where the region is
/// proved anew; otherwise, and for other machines, it stays where it is. Sets the joint ranges.
/// @param budget of the whole search; when its time is over, the region stays where it is
/// @pre the region is proved, or its size is 0: then nothing happens
void settleHeight(const Machine& machine, const RegionQuery& query, const RunningBudget& budget, LargestRegion& region);
}  // namespace pkm_workspace
