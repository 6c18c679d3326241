// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/region/shape.h"

namespace pkm_workspace
{
std::optional<Eigen::Vector3d> nearestInside(const Shape& shape, const Eigen::Vector3d& point,
                                             const Eigen::Vector3d& center, double size)
{
  const Eigen::Vector3d nearest = shape.nearest(point, center, size);
  // a corner of the region is rarely a double: go towards the center until rounding is out of the way
  for (const double inward : { 0.0, 0x1p-50, 0x1p-44, 0x1p-36, 0x1p-24, 0x1p-12, 1.0 })
  {
    const Eigen::Vector3d candidate = nearest + inward * (center - nearest);
    if (shape.contains(candidate, Box{ center, center }, size))
      return candidate;
  }
  return std::nullopt;
}
}  // namespace pkm_workspace
