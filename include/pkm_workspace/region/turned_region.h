// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "pkm_workspace/machine/machine.h"
#include "pkm_workspace/region/largest_region.h"

namespace pkm_workspace
{
/// Allows the region to be turned about the vertical, by every angle that makes a difference.
/// @pre shape, ratio and place are set @throws std::invalid_argument for a shape that no turn changes
void setTurned(RegionQuery& query);
/// Whether turns change anything about shapes of a kind.
bool canTurn(const std::string& kind);

/// A machine, and what is asked of it.
struct SeenFrom
{
  Machine machine;
  Criterion criterion;
};

/// The machine and the criterion's zones in a frame that stands on the vertical through the center, at z = 0, and is
/// turned by the angle from x to y [rad], or by any other within 2^-50 of it, relative: what is proved of K(h) about
/// (0, 0, center.z) there is proved of K(h) turned about the center. @throws std::invalid_argument where rounding loses
/// the machine
SeenFrom seenFrom(const Machine& machine, const Criterion& criterion, const Eigen::Vector3d& center, double angle);

/// settleHeight() of a region that is turned: it moves along rails that are vertical, exactly. Fills in its joint
/// ranges.
void settleTurned(const Machine& machine, const RegionQuery& query, const RunningBudget& budget, LargestRegion& region);

/// Enclosures that together hold all turns about z by up to half of one.
std::vector<IntervalMatrix> halfTurns();

/// How wide a region is at the least along a horizontal direction, whatever that is; rounded down [m].
Growing<double> leastWidth(const Shape& shape);
}  // namespace pkm_workspace
