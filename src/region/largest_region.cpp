// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/region/largest_region.h"

#include "pkm_workspace/region/center_search.h"

namespace pkm_workspace
{
void RegionQuery::validate(Problems& problems) const
{
  if (!shape)
    problems.push_back("a shape is missing");
  criterion.validate(problems);
  if (criterion.aspect == Criterion::Aspect::BOTH)
    problems.push_back("a region lies in one aspect: ask for the machine's own or for the other one");
  validatePositive("accuracy", accuracy, "(in the unit of the size, m for edges)", problems);
  budget.validate(problems);
  if (search_box)
    validateBox("search_box", *search_box, problems);
}

LargestRegion findLargestRegion(const Machine& machine, const RegionQuery& query)
{
  LargestRegion region = CenterSearch(machine, validated(query)).run();
  if (region.size > 0.0)
    region.joint_ranges = jointRanges(machine, *query.shape, region.center, region.size);
  return region;
}

LargestRegion largestRegionAt(const Machine& machine, const RegionQuery& query, const Eigen::Vector3d& center)
{
  RegionQuery at_center = query;
  at_center.search_box = Box{ center, center };
  return findLargestRegion(machine, at_center);
}
}  // namespace pkm_workspace
