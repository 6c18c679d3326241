// SPDX-License-Identifier: BSD-3-Clause
#include "shapes.h"

#include <algorithm>
#include <stdexcept>

namespace pkm_workspace
{
namespace cli
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
}  // namespace

Words shapeNames()
{
  Words names;
  for (const NamedShape& shape : SHAPES)
    names.push_back(shape.name);
  return names;
}

ShapePtr makeShape(const std::string& name, const std::optional<Eigen::Vector3d>& proportions)
{
  const auto* const shape =
      std::find_if(std::begin(SHAPES), std::end(SHAPES), [&](const NamedShape& s) { return s.name == name; });
  if (shape->has_proportions && !proportions)
    throw std::invalid_argument("a " + name + " needs --proportions A B C");
  if (!shape->has_proportions && proportions)
    throw std::invalid_argument("a " + name + " has no proportions: leave --proportions out");
  return shape->make(proportions.value_or(Eigen::Vector3d::Ones()));
}
}  // namespace cli
}  // namespace pkm_workspace
