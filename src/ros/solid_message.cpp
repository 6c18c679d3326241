// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/ros/solid_message.h"

#include <cmath>
#include <limits>
#include <stdexcept>

#include "pkm_workspace/interval/text_stream.h"
#include "pkm_workspace/region/path.h"

namespace pkm_workspace
{
namespace
{
using shape_msgs::SolidPrimitive;

/// Products with sizes have to stay ordinary numbers [m].
constexpr double LEAST_LENGTH = 1e-100;

void requireDimensions(const SolidPrimitive& message, const char* meaning, std::size_t count)
{
  const auto& dimensions = message.dimensions;
  bool is_good = dimensions.size() == count;
  bool is_point = true;
  TextStream text;
  for (const double length : dimensions)
  {
    is_good = is_good && (length == 0.0 || (length >= LEAST_LENGTH && length <= FARTHEST));
    is_point = is_point && length == 0.0;
    text << (text.tellp() == std::streampos(0) ? "" : ", ") << length;
  }
  if (!is_good || is_point)
    throw std::invalid_argument("solid.dimensions = (" + text.str() + ") m must be " + meaning +
                                ", each 0 or from 1e-100 to 1e9, not all 0");
}

Solid cylinder(double height, double radius)
{
  if (radius == 0.0)  // no thickness across
    return { makeBox({ 0.0, 0.0, height }) };
  return height == 0.0 ? Solid{ makeDisc(), radius } : Solid{ makeCylinder(radius, height) };
}
}  // namespace

Solid fromMessage(const SolidPrimitive& message)
{
  const auto& d = message.dimensions;
  switch (message.type)
  {
    case SolidPrimitive::BOX:
      requireDimensions(message, "three full sides", 3);
      return { makeBox({ d[0], d[1], d[2] }) };
    case SolidPrimitive::SPHERE:
      requireDimensions(message, "one radius", 1);
      return { makeSphere(), d[0] };
    case SolidPrimitive::CYLINDER:
      requireDimensions(message, "height and radius", 2);
      return cylinder(d[SolidPrimitive::CYLINDER_HEIGHT], d[SolidPrimitive::CYLINDER_RADIUS]);
    default:
      throw std::invalid_argument("solid.type = " + std::to_string(message.type) +
                                  " must be BOX = 1, SPHERE = 2 or CYLINDER = 3");
  }
}

Bounds toMessage(const Interval& interval)
{
  constexpr double NONE = std::numeric_limits<double>::quiet_NaN();
  Bounds message;
  message.lower = interval.isEmpty() ? NONE : interval.lower();
  message.upper = interval.isEmpty() ? NONE : interval.upper();
  return message;
}

void requireFinite(const char* name, const Eigen::Vector3d& point, Problems& problems)
{
  if (point.allFinite() && point.cwiseAbs().maxCoeff() <= FARTHEST)
    return;
  TextStream text;
  text << name << " = (" << point.x() << ", " << point.y() << ", " << point.z() << ") m must be finite, within 1e9 m";
  problems.push_back(text.str());
}
}  // namespace pkm_workspace
