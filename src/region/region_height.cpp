// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/region/region_height.h"

#include <algorithm>
#include <cmath>

#include "pkm_workspace/dexterity/workspace_bounds.h"
#include "pkm_workspace/machine/rails.h"
#include "pkm_workspace/region/containment.h"

namespace pkm_workspace
{
namespace
{
using Eigen::Vector3d;

/// Distance to the limits that lets a proof end [longest strut].
constexpr double SLACK = 1e-7;
/// Boxes that a proof may take.
constexpr std::int64_t MOVING_BOXES = 20000;
/// How far the region is moved, as shares of the way; the first that is proved counts.
constexpr double SHARES[] = { 1.0, 0.999, 0.99, 0.9, 0.5 };

/// What can be added to all of the values without leaving the room: rounded inwards, and with 0 in any case.
Interval travelWithin(const Interval& room, const Interval& values)
{
  const double down = std::isfinite(room.lower()) ? (Interval(room.lower()) - Interval(values.lower())).upper() : -INF;
  const double up = std::isfinite(room.upper()) ? (Interval(room.upper()) - Interval(values.upper())).lower() : INF;
  return { std::min(down, 0.0), std::max(up, 0.0) };
}

/// The t for which the center + t e is left by the limits and the search box: they guide, the proof is another one.
Interval travelOf(const Machine& machine, const RegionQuery& query, const LargestRegion& region)
{
  Interval travel = Interval::entire();
  for (int i = 0; query.criterion.joint_limits && i < 3; ++i)
  {
    const JointRange& range = region.joint_ranges[static_cast<std::size_t>(i)];
    const Interval sense(parallelSense(machine.leg(0), machine.leg(i)));
    travel = intersection(travel, travelWithin(sense * machine.leg(i).limits, sense * hull(range.lower, range.upper)));
  }
  for (std::size_t k = 0; query.search_box && k < 3; ++k)
  {
    const Interval e(directionOfRails(machine)[k].mid());
    const int axis = static_cast<int>(k);
    if (e != Interval(0.0))
      travel = intersection(travel, travelWithin(query.search_box->side(axis), region.center[axis]) / e);
  }
  return travel;
}

bool isProved(const BoxTest& test, const RunningBudget& budget, const Vector3d& center, LargestRegion& region)
{
  Budget left = budget.rest();
  left.max_boxes = MOVING_BOXES;
  const ContainmentResult proof = checkContainment(test, *region.shape, center, region.size, left);
  region.verification_boxes += proof.boxes;
  return proof.verdict == Containment::INSIDE;
}
}  // namespace

void settleHeight(const Machine& machine, const RegionQuery& query, const RunningBudget& budget, LargestRegion& region)
{
  if (!(region.size > 0.0))
    return;
  region.joint_ranges = jointRanges(machine, *region.shape, region.center, region.size);
  if (!machine.hasParallelRails())
    return;
  const int axis = mainAxisOfRails(machine);
  const Vector3d e = mid(directionOfRails(machine));
  const double height = query.levelAlong(axis, machine);
  const double wanted = (height - region.center[axis]) / e[axis];
  const Interval travel = travelOf(machine, query, region);
  const double slack = query.criterion.joint_limits ? SLACK * machine.scale() : 0.0;
  const double way = std::clamp(wanted, std::min(0.0, travel.lower() + slack), std::max(0.0, travel.upper() - slack));
  if (way == 0.0)
    return;
  const BoxTest test(machine, query.criterion, query.precision);
  for (const double share : SHARES)
  {
    Vector3d center = region.center + share * way * e;
    if (share * way == wanted)
      center[axis] = height;
    if (query.search_box)
      center = center.cwiseMax(query.search_box->lower).cwiseMin(query.search_box->upper);
    if (budget.isOver())
      return;
    if (!isProved(test, budget, center, region))
      continue;
    region.center = center;
    region.joint_ranges = jointRanges(machine, *region.shape, region.center, region.size);
    return;
  }
}
}  // namespace pkm_workspace
