// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "pkm_workspace/region/largest_region.h"

namespace pkm_workspace
{
/// Finds the cylinder of the largest volume whose ratio of radius over height lies in the query's range (paper, section
/// 2.5): bisection of the ratio, highest upper bound first, with a search over all centers for each part.
///
/// A cylinder of ratio a and height H contains one of ratio rho and height min(H, a H / rho). So where none of ratio
/// rho is higher than u, no ratio in [lower, upper] gives a volume above pi u^3 max(upper^2, rho^3 / lower).
/// @return the region as of its shape, the cylinder of the ratio found
LargestRegion findLargestCylinder(const Machine& machine, const RegionQuery& query);
}  // namespace pkm_workspace
