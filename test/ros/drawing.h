// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "pkm_workspace/machine/catalogue.h"
#include "pkm_workspace/ros/markers.h"
#include "pkm_workspace/ros/set_surface.h"

namespace pkm_workspace
{
namespace test
{
using visualization_msgs::Marker;
using Markers = std::vector<Marker>;

inline Region regionWithSides(double x, double y, double z)
{
  Region region;
  region.header.frame_id = "base_link";
  region.header.stamp = ros::Time(100.0);
  region.shape = Region::BOX;
  region.size = 1.0;
  region.solid.type = shape_msgs::SolidPrimitive::BOX;
  region.solid.dimensions = { x, y, z };
  RailRange range;
  range.joint = "rail_x";
  range.lower = -0.25;
  range.upper = 0.5;
  range.stroke_upper_bound = 0.75;
  region.joint_ranges = { range };
  return region;
}

inline Markers inNamespace(const visualization_msgs::MarkerArray& array, const std::string& ns)
{
  Markers found;
  for (const Marker& marker : array.markers)
    if (marker.ns == ns)
      found.push_back(marker);
  return found;
}

inline Markers ofType(const Markers& markers, int type)
{
  Markers found;
  for (const Marker& marker : markers)
    if (marker.type == type)
      found.push_back(marker);
  return found;
}

inline const DrawnRails NOT_DRAWN = { Interval::empty(), Interval::empty(), Interval::empty() };

inline visualization_msgs::MarkerArray draw(const Region& region, const Paving* paving = nullptr,
                                            bool show_boundary = false)
{
  std::optional<SetSurface> set;
  if (paving)
    set.emplace(*paving, orthoglide(), SetColors::VERDICT, show_boundary);
  return markersOf(region, premisesOf(orthoglide(), Criterion()), orthoglide(), NOT_DRAWN, set ? &*set : nullptr);
}

inline Eigen::Vector3d vectorOf(const geometry_msgs::Point& point)
{
  return { point.x, point.y, point.z };
}

/// Of all triangles together.
inline double areaOf(const Marker& surface)
{
  double area = 0.0;
  for (std::size_t i = 0; i + 2 < surface.points.size(); i += 3)
  {
    const Eigen::Vector3d corner = vectorOf(surface.points[i]);
    const Eigen::Vector3d first = vectorOf(surface.points[i + 1]) - corner;
    area += 0.5 * first.cross(vectorOf(surface.points[i + 2]) - corner).norm();
  }
  return area;
}
}  // namespace test
}  // namespace pkm_workspace
