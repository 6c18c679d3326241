// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "pkm_workspace/region/largest_region.h"
#include "pkm_workspace/region/rail_travel.h"

namespace pkm_workspace
{
/// Where the centers of a query's regions may lie, and how large a region can be at all.
struct CenterSpace
{
  Box centers;                       ///< contains every center that has to be looked at, or its place [m]
  double size_bound;                 ///< certified: no region of the query is larger
  std::optional<RailTravel> travel;  ///< where centers have places: parallel rails whose centers are bounded along them
};

/// @throws std::invalid_argument with all reasons when either is unbounded
CenterSpace centerSpace(const Machine& machine, const RegionQuery& query);
}  // namespace pkm_workspace
