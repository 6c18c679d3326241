// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/region/region_parts.h"

#include <algorithm>

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

BoxVerdict partOf(const Shape& shape, const Vector3d& center, double size, const Box& box)
{
  return shape.misses(box, center, size)          ? BoxVerdict::OUTSIDE
         : holdsCorners(shape, center, size, box) ? BoxVerdict::INSIDE
                                                  : BoxVerdict::UNDECIDED;
}

/// What it measures along the axes.
IntervalVector sidesOf(const Shape& shape, double size)
{
  return encloseAt(2.0 * shape.halfExtents(), size);
}

/// How much larger the bounding box of a box is than itself, relative to it: rounding only.
Interval overhang(const Shape& shape, const Box& bounds, double size)
{
  Interval sum;
  int axis = 0;
  for (const Interval& side : sidesOf(shape, size))
  {
    if (side.lower() > 0.0)
      sum += ((Interval(bounds.upper[axis]) - Interval(bounds.lower[axis])) - side) / side;
    ++axis;
  }
  return sum;
}

/// Of a box; of a flat one, the area.
Interval measureOf(const Shape& shape, double size)
{
  Interval measure(1.0);
  for (const Interval& side : sidesOf(shape, size))
    if (side.upper() > 0.0)
      measure *= side;
  return measure;
}
}  // namespace

SingularityQuery singularitiesOver(const ShapePtr& shape, const Vector3d& center, double size)
{
  SingularityQuery query;
  query.box = shape->boundingBox(center, size);
  query.part = [shape, center, size](const Box& box) { return partOf(*shape, center, size, box); };
  return query;
}

GlobalConditioning globalConditioning(const Machine& machine, const Shape& shape, const Vector3d& center, double size,
                                      const ConditioningQuery& query)
{
  Problems problems;
  validatePositive("size", size, "m", problems);
  throwProblems(problems);
  const Box bounds = shape.boundingBox(center, size);
  if (!shape.isBox())
  {
    const BoxClassifier part = [&](const Box& box) { return partOf(shape, center, size, box); };
    return globalConditioning(machine, part, bounds, query);
  }
  const BoxClassifier whole = [](const Box&) { return BoxVerdict::INSIDE; };
  GlobalConditioning result = globalConditioning(machine, whole, bounds, query);
  // two means of values in [0, 1] over sets that differ by this share differ by no more than twice as much
  const double error = (Interval(2.0) * overhang(shape, bounds, size)).upper();
  const Interval wider = result.index + Interval(-error, error);
  result.index = { std::max(0.0, wider.lower()), std::min(1.0, wider.upper()) };
  result.measure = measureOf(shape, size);
  result.complete = result.index.width() <= query.accuracy;
  return result;
}
}  // namespace pkm_workspace
