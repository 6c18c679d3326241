// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <vector>

#include "pkm_workspace/dexterity/zone_forms.h"
#include "pkm_workspace/region/shape.h"

namespace pkm_workspace
{
/// Where regions of a shape are looked at first: points of its family, and points of space that are known to be bad.
/// What the search learns is kept here.
class WitnessPoints
{
public:
  /// Keeps a reference to the shape. @param keep_out zones of the criterion: they tell bad points wherever a region is
  WitnessPoints(const Shape& shape, const std::vector<ZoneToKeepOut>& keep_out);

  /// Points of the family, exactly: its extreme points, then those that were learnt.
  const std::vector<GrowingVector>& ofShape() const { return of_shape_; }
  /// Points that are proved to violate the criterion [m]: no region may contain them.
  const std::vector<Eigen::Vector3d>& bad() const { return bad_; }
  /// The same, and of each zone to keep out of the point that a region about the center would hold first.
  /// @param angle by which the region is turned about the vertical [rad] @param room for them where there are zones
  const std::vector<Eigen::Vector3d>& badNear(const Eigen::Vector3d& center, double angle,
                                              std::vector<Eigen::Vector3d>& room) const;
  /// The same with points that a region which can be proved keeps out, too.
  const std::vector<Eigen::Vector3d>& keptOut(const Eigen::Vector3d& center, double angle,
                                              std::vector<Eigen::Vector3d>& room) const;

  /// Learns from a region c + K(h) that is refused because of a bad point: the point is bad for all regions, and its
  /// place in the family is a witness, instead of one that was learnt before and is close to it.
  void learn(const Eigen::Vector3d& center, double size, const Eigen::Vector3d& bad_point);

  /// The same where the point is bad for this region only.
  void learnPlace(const Eigen::Vector3d& center, double size, const Eigen::Vector3d& bad_point);

  /// The same where it is known which place of the family that is.
  void learnPlace(const GrowingVector& place, double size);

  /// The point is proved to be bad [m].
  void learn(const Eigen::Vector3d& bad_point);

private:
  Eigen::Vector3d contact(const ZoneToKeepOut& zone, const Eigen::Vector3d& center, double angle) const;

  const Shape& shape_;
  std::size_t extremes_;
  std::vector<GrowingVector> of_shape_;
  std::vector<Eigen::Vector3d> bad_;
  std::vector<ZoneToKeepOut> keep_out_;
  double depth_;                ///< of bad points in zones, in roundings
  std::size_t next_place_ = 0;  ///< counts what was learnt when there is no room for more
  std::size_t next_bad_ = 0;
};
}  // namespace pkm_workspace
