// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <vector>

#include "pkm_workspace/interval/turning.h"

namespace pkm_workspace
{
/// A region c + K(h), by its numbers; or one that is turned about its center.
struct Candidate
{
  Eigen::Vector3d center = Eigen::Vector3d::Zero();
  double size = 0.0;
  double angle = 0.0;  ///< about the vertical [rad]

  /// The same of another size.
  Candidate ofSize(double other) const { return { center, other, angle }; }
  /// Where points of the family are, seen from the center, in floating point.
  std::vector<GrowingVector> placesOf(const std::vector<GrowingVector>& points) const
  {
    return angle == 0.0 ? points : turnedAboutZ(points, angle);
  }
};
}  // namespace pkm_workspace
