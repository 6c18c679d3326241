// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/region/region_singularity.h"

namespace pkm_workspace
{
namespace
{
using Eigen::Vector3d;

/// A convex body holds a box when it holds its corners.
bool holdsCorners(const Shape& shape, const Vector3d& center, double size, const Box& box)
{
  for (int corner = 0; corner < 8; ++corner)
  {
    Vector3d point = box.lower;
    for (const int axis : { 0, 1, 2 })
      point[axis] = (corner >> axis) % 2 == 0 ? box.lower[axis] : box.upper[axis];
    if (!shape.contains(point, { center, center }, size))
      return false;
  }
  return true;
}
}  // namespace

SingularityQuery singularitiesOver(const ShapePtr& shape, const Vector3d& center, double size)
{
  SingularityQuery query;
  query.box = shape->boundingBox(center, size);
  query.part = [shape, center, size](const Box& box) {
    return shape->misses(box, center, size)          ? BoxVerdict::OUTSIDE
           : holdsCorners(*shape, center, size, box) ? BoxVerdict::INSIDE
                                                     : BoxVerdict::UNDECIDED;
  };
  return query;
}
}  // namespace pkm_workspace
