// SPDX-License-Identifier: BSD-3-Clause
#include "zone_scene.h"

#include <Eigen/Geometry>
#include <algorithm>

#include "pkm_workspace/ros/conversions.h"

namespace pkm_workspace
{
namespace
{
using visualization_msgs::Marker;

constexpr Color ZONE_OUT = { 0.85F, 0.10F, 0.10F, 0.35F };
constexpr Color ZONE_IN = { 0.10F, 0.65F, 0.30F, 0.10F };
constexpr double ENDLESS = 2.0;  // lengths

Eigen::Isometry3d isometryOf(const Pose& pose)
{
  const Eigen::Quaterniond turn(pose.orientation.data());
  return Eigen::Translation3d(pose.translation) * turn.normalized();
}

std::int32_t typeOf(ZoneKind kind)
{
  return kind == ZoneKind::CYLINDER ? Marker::CYLINDER : kind == ZoneKind::SPHERE ? Marker::SPHERE : Marker::CUBE;
}

/// What a marker of the zone's type measures [m]. @param longest of what has no end
Eigen::Vector3d extentsOf(const Zone& zone, double longest)
{
  const double across = 2.0 * zone.radius;
  switch (zone.kind)
  {
    case ZoneKind::BOX:
      return zone.sides;
    case ZoneKind::CYLINDER:
      return { across, across, std::min(zone.height, longest) };
    case ZoneKind::SPHERE:
      return { across, across, across };
    case ZoneKind::HALF_SPACE:
      break;
  }
  return { longest, longest, 1e-3 * longest };
}
}  // namespace

void addZones(const std::vector<Zone>& zones, double length, Scene& scene)
{
  for (const Zone& zone : zones)
  {
    Eigen::Isometry3d pose = isometryOf(zone.frame) * isometryOf(zone.pose);
    if (zone.kind == ZoneKind::HALF_SPACE)
      pose.rotate(Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitZ(), zone.normal));
    Marker& body = scene.add("zones", typeOf(zone.kind), zone.use == Zone::Use::KEEP_IN ? ZONE_IN : ZONE_OUT);
    const Eigen::Vector3d extents = extentsOf(zone, ENDLESS * length);
    body.pose.position = toMessage(Eigen::Vector3d(pose.translation()));
    body.pose.orientation = toMessage(Eigen::Quaterniond(pose.linear()));
    body.scale.x = extents.x();
    body.scale.y = extents.y();
    body.scale.z = extents.z();
  }
}
}  // namespace pkm_workspace
