// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/ros/solid_message.h"

#include <limits>
#include <stdexcept>

#include "pkm_workspace/interval/text_stream.h"
#include "pkm_workspace/region/path.h"
#include "pkm_workspace/region/polytope.h"
#include "pkm_workspace/ros/conversions.h"

namespace pkm_workspace
{
namespace
{
using shape_msgs::SolidPrimitive;

SolidKind kindOf(const SolidPrimitive& message)
{
  switch (message.type)
  {
    case SolidPrimitive::BOX:
      return SolidKind::BOX;
    case SolidPrimitive::SPHERE:
      return SolidKind::SPHERE;
    case SolidPrimitive::CYLINDER:
      static_assert(int(SolidPrimitive::CYLINDER_HEIGHT) == 0 && int(SolidPrimitive::CYLINDER_RADIUS) == 1, "order");
      return SolidKind::CYLINDER;
    default:
      throw std::invalid_argument("solid.type = " + std::to_string(message.type) +
                                  " must be BOX = 1, SPHERE = 2 or CYLINDER = 3");
  }
}

/// @throws std::invalid_argument with the dimensions and what they must be, or with another type
Solid read(const SolidPrimitive& message)
{
  const SolidKind kind = kindOf(message);
  try
  {
    return makeSolid(kind, message.dimensions);
  }
  catch (const std::invalid_argument& reason)
  {
    TextStream text;
    for (const double length : message.dimensions)
      text << (text.tellp() == std::streampos(0) ? "" : ", ") << length;
    throw std::invalid_argument("solid.dimensions = (" + text.str() + ") m " + reason.what());
  }
}
}  // namespace

std::optional<PlacedSolid> fromMessage(const SolidPrimitive& message, const geometry_msgs::Point& center,
                                       Problems& problems)
{
  const std::size_t before = problems.size();
  PlacedSolid placed{ {}, fromMessage(center) };
  try
  {
    placed.solid = read(message);
  }
  catch (const std::invalid_argument& reason)
  {
    problems.push_back(reason.what());
  }
  requireFinite("center", placed.center, problems);
  return problems.size() == before ? std::optional(placed) : std::nullopt;
}

std::optional<PlacedSolid> fromMessage(const SolidPrimitive& message, const std::vector<geometry_msgs::Point>& vertices,
                                       const geometry_msgs::Point& center, Problems& problems)
{
  if (vertices.empty())
    return fromMessage(message, center, problems);
  const std::size_t before = problems.size();
  PlacedSolid placed{ {}, fromMessage(center) };
  std::vector<Eigen::Vector3d> points;
  for (const geometry_msgs::Point& vertex : vertices)
    points.push_back(fromMessage(vertex));
  if (!message.dimensions.empty())
    problems.push_back("solid and vertices: only one of the two can be given");
  try
  {
    placed.solid = { makePolytope(points), 1.0 };
  }
  catch (const std::invalid_argument& reason)
  {
    problems.push_back(reason.what());
  }
  requireFinite("center", placed.center, problems);
  return problems.size() == before ? std::optional(placed) : std::nullopt;
}

std::optional<PlacedSolid> readRegion(bool given, const SolidPrimitive& message, const geometry_msgs::Point& center,
                                      Problems& problems)
{
  if (given)
    return fromMessage(message, center, problems);
  if (!message.dimensions.empty() || fromMessage(center) != Eigen::Vector3d::Zero())
    problems.push_back("solid and center must be empty and 0 [m] unless over = REGION");
  return std::nullopt;
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
