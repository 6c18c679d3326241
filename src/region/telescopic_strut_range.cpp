// SPDX-License-Identifier: BSD-3-Clause
#include "leg_range.h"
#include "region_distance.h"

namespace pkm_workspace
{
/// Its length is the distance of the platform point from the foot.
JointRange rangeOver(const EnclosedTelescope& leg, const PlacedShape& region)
{
  const RegionDistance distance(region);
  JointRange range;
  range.lower = distance.least(leg.center) - leg.length;
  range.upper = distance.largest(leg.center) - leg.length;
  range.stroke = intersection(range.upper - range.lower, Interval(0.0, INF));
  range.across = Interval(0.0);
  return range;
}
}  // namespace pkm_workspace
