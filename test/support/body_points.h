// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "pkm_workspace/region/shape.h"
#include "support/cases.h"

namespace pkm_workspace
{
namespace test
{
/// A point of the region, near its surface more often than not.
inline Eigen::Vector3d pointOf(const Shape& shape, const Eigen::Vector3d& center, double size, RandomBoxes& random)
{
  const Eigen::Vector3d reach = shape.halfExtents().at(size);
  const Box bounds = shape.boundingBox(center, size);
  const Eigen::Vector3d far = random.pointIn({ bounds.lower - 0.5 * reach, bounds.upper + 0.5 * reach });
  return nearestInside(shape, far, center, size).value_or(center);
}
}  // namespace test
}  // namespace pkm_workspace
