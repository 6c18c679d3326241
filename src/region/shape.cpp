// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/region/shape.h"

#include <algorithm>
#include <iterator>
#include <sstream>
#include <stdexcept>

namespace pkm_workspace
{
namespace
{
struct NamedShape
{
  const char* name;
  bool has_proportions;
  ShapePtr (*make)(const Eigen::Vector3d& proportions);
};

const NamedShape SHAPES[] = {
  { "cube", false, [](const Eigen::Vector3d&) { return makeCube(); } },
  { "square", false, [](const Eigen::Vector3d&) { return makeSquare(); } },
  { "box", true, [](const Eigen::Vector3d& proportions) { return makeBox(proportions); } },
};

std::string listOfNames()
{
  std::string list;
  for (const NamedShape& shape : SHAPES)
    list += (list.empty() ? "" : &shape == std::end(SHAPES) - 1 ? " or " : ", ") + std::string(shape.name);
  return list;
}
}  // namespace

std::vector<std::string> shapeNames()
{
  std::vector<std::string> names;
  for (const NamedShape& shape : SHAPES)
    names.emplace_back(shape.name);
  return names;
}

ShapePtr makeShape(const std::string& name, const std::optional<Eigen::Vector3d>& proportions)
{
  const auto* const named =
      std::find_if(std::begin(SHAPES), std::end(SHAPES), [&](const NamedShape& s) { return s.name == name; });
  if (named == std::end(SHAPES))
    throw std::invalid_argument("shape = '" + name + "' must be " + listOfNames());
  if (named->has_proportions && !proportions)
    throw std::invalid_argument("shape = " + name + " needs proportions: what it measures along x, y and z");
  ShapePtr shape = named->make(proportions.value_or(Eigen::Vector3d::Ones()));
  if (!named->has_proportions && proportions && *proportions != 2.0 * shape->halfExtents())
  {
    const Eigen::IOFormat tuple(Eigen::StreamPrecision, Eigen::DontAlignCols, ", ", ", ", "", "", "(", ")");
    std::ostringstream text;
    text << "proportions = " << proportions->format(tuple) << " are for the shape box only, the shape is " << name;
    throw std::invalid_argument(text.str());
  }
  return shape;
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
