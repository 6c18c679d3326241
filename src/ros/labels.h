// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pkm_workspace/Region.h>

#include <vector>

#include "pkm_workspace/ros/markers.h"

namespace pkm_workspace
{
/// Where what is written about a box stands: on the side of it where no struts are.
/// @param unit a thousandth of the machine's size [m]
Eigen::Vector3d labelOf(const Box& box, const Machine& machine, double unit);

/// Where what is written about a machine and its region stands: around them, so that it covers neither them nor each
/// other when seen from the side or obliquely from above, from any direction around them.
class LabelPlaces
{
public:
  /// @param unit a thousandth of the machine's size [m]
  LabelPlaces(const Region& region, const Machine& machine, const DrawnRails& rails, double unit);

  /// On the side of the region where no struts are.
  Eigen::Vector3d ofRegion() const;
  /// Beyond the end of the rail that is farther from the region.
  const Eigen::Vector3d& ofRail(std::size_t leg) const { return of_rails_[leg]; }
  /// Below all of it.
  Eigen::Vector3d ofHypotheses() const;

private:
  Eigen::Vector3d labelOf(const Leg& leg, const Interval& drawn, const Interval& range);

  double unit_;
  Eigen::Vector3d center_;                  ///< of the region
  std::vector<Eigen::Vector3d> corners_;    ///< of the box around the region; none where there is no region
  bool is_below_ = false;                   ///< the region's label
  std::vector<Eigen::Vector3d> rail_ends_;  ///< with room for what is drawn around them
  std::vector<Eigen::Vector3d> of_rails_;
};
}  // namespace pkm_workspace
