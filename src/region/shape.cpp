// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/region/shape.h"

#include <algorithm>
#include <iterator>
#include <stdexcept>

#include "pkm_workspace/interval/text_stream.h"

namespace pkm_workspace
{
namespace
{
using Proportions = std::optional<Eigen::Vector3d>;

struct NamedShape
{
  const char* name;
  ShapePtr (*make)(const Proportions& proportions);
};

ShapePtr makeBoxFrom(const Proportions& proportions)
{
  if (!proportions)
    throw std::invalid_argument("shape = box needs proportions: what it measures along x, y and z");
  return makeBox(*proportions);
}

const NamedShape SHAPES[] = {
  { "cube", [](const Proportions&) { return makeCube(); } },
  { "square", [](const Proportions&) { return makeSquare(); } },
  { "box", makeBoxFrom },
  { "sphere", [](const Proportions&) { return makeSphere(); } },
  { "disc", [](const Proportions&) { return makeDisc(); } },
};

std::string listOfNames()
{
  std::string list;
  for (const NamedShape& shape : SHAPES)
    list += shape.name + std::string(", ");
  return list.substr(0, list.size() - 2) + ", cylinder or polytope";
}
}  // namespace

std::vector<std::string> shapeNames()
{
  std::vector<std::string> names;
  for (const NamedShape& shape : SHAPES)
    names.emplace_back(shape.name);
  return names;
}

ShapePtr makeShape(const std::string& name, const Proportions& proportions)
{
  const auto* const named =
      std::find_if(std::begin(SHAPES), std::end(SHAPES), [&](const NamedShape& s) { return s.name == name; });
  if (named == std::end(SHAPES))
    throw std::invalid_argument("shape = '" + name + "' must be " + listOfNames());
  ShapePtr shape = named->make(proportions);
  if (proportions && *proportions != 2.0 * shape->halfExtents().per_size)  // those that it has anyway are let pass
  {
    const Eigen::IOFormat tuple(Eigen::StreamPrecision, Eigen::DontAlignCols, ", ", ", ", "", "", "(", ")");
    TextStream text;
    text << "proportions = " << proportions->format(tuple) << " are for the shape box only, the shape is " << name;
    throw std::invalid_argument(text.str());
  }
  return shape;
}

std::string Shape::kind() const
{
  const std::string full = name();
  return full.substr(0, full.find(' '));
}

std::vector<Circle> Shape::extremeCircles(const Eigen::Vector3d&, double) const
{
  return {};
}

std::optional<Interval> Shape::ballRadius(double) const
{
  return std::nullopt;
}

Box Shape::boundingBox(const Eigen::Vector3d& center, double size) const
{
  const GrowingVector least = lower();
  const GrowingVector most = upper();
  const auto side = [&](int k) {
    const Growing<double> first{ least.fixed[k], least.per_size[k] };
    const Growing<double> last{ most.fixed[k], most.per_size[k] };
    const bool is_symmetric = first.fixed == -last.fixed && first.per_size == -last.per_size;
    const Interval reach = encloseAt(last, size);
    return Interval(center[k]) + hull(is_symmetric ? -reach : encloseAt(first, size), reach);
  };
  return pkm_workspace::boundingBox({ side(0), side(1), side(2) });
}

std::optional<GrowingVector> Shape::placeOf(const Eigen::Vector3d& offset, double size) const
{
  const auto place = nearestInside(*this, offset / size, Eigen::Vector3d::Zero(), 1.0);
  return place ? std::make_optional(scaling(*place)) : std::nullopt;
}

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
