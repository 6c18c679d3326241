// SPDX-License-Identifier: BSD-3-Clause
#include "still_collisions.h"

#include <Eigen/Geometry>
#include <algorithm>

namespace pkm_workspace
{
namespace urdf_io
{
namespace
{
/// Each measure grows by this share of it and of its distance from the root: more than rounding the place can move it.
constexpr double GROWTH = 1e-12;

Eigen::Isometry3d poseOf(const Origin& origin)
{
  return Eigen::Translation3d(origin.xyz) * Eigen::AngleAxisd(origin.rpy[2], Eigen::Vector3d::UnitZ()) *
         Eigen::AngleAxisd(origin.rpy[1], Eigen::Vector3d::UnitY()) *
         Eigen::AngleAxisd(origin.rpy[0], Eigen::Vector3d::UnitX());
}

Eigen::Isometry3d poseOf(const urdf::Pose& pose)
{
  Eigen::Quaterniond turn;
  pose.rotation.getQuaternion(turn.x(), turn.y(), turn.z(), turn.w());
  return Eigen::Translation3d(pose.position.x, pose.position.y, pose.position.z) * turn.normalized();
}

/// All joints on the way are fixed.
Eigen::Isometry3d poseInRoot(const Model& model, const urdf::Link& link)
{
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  const urdf::Link* at = &link;
  while (at->parent_joint)
  {
    pose = poseOf(model.originOf(*at->parent_joint)) * pose;
    at = &model.link(at->parent_joint->parent_link_name);
  }
  return pose;
}

Pose rounded(const Eigen::Isometry3d& pose)
{
  Pose result;
  result.translation = pose.translation();
  const Eigen::Quaterniond turn(pose.linear());
  if (turn.vec().cwiseAbs().maxCoeff() > GROWTH)
    result.orientation = { turn.x(), turn.y(), turn.z(), turn.w() };
  return result;
}

/// @return whether the zone can have this geometry
bool measure(const urdf::Geometry& geometry, Zone& zone)
{
  const double distance = zone.pose.translation.norm();
  const auto grown = [distance](double length) { return length + GROWTH * (distance + 10.0 * length); };
  if (const auto* const box = dynamic_cast<const urdf::Box*>(&geometry))
  {
    zone.kind = ZoneKind::BOX;
    const double longest = std::max({ box->dim.x, box->dim.y, box->dim.z });
    zone.sides = Eigen::Vector3d(box->dim.x, box->dim.y, box->dim.z).array() + (grown(longest) - longest);
    return true;
  }
  if (const auto* const cylinder = dynamic_cast<const urdf::Cylinder*>(&geometry))
  {
    zone.kind = ZoneKind::CYLINDER;
    const double longest = std::max(cylinder->radius, cylinder->length);
    const double growth = grown(longest) - longest;
    zone.radius = cylinder->radius + growth;
    zone.height = cylinder->length + growth;
    return true;
  }
  if (const auto* const sphere = dynamic_cast<const urdf::Sphere*>(&geometry))
  {
    zone.kind = ZoneKind::SPHERE;
    zone.radius = grown(sphere->radius);
    return true;
  }
  return false;
}
/// Whether a joint between the link and the root is not fixed.
bool isMoved(const urdf::Link& link)
{
  for (const urdf::Link* below = &link; below->parent_joint; below = below->getParent().get())
    if (below->parent_joint->type != urdf::Joint::FIXED)
      return true;
  return false;
}
}  // namespace

std::vector<std::string> movedLinks(const Model& model)
{
  std::vector<std::string> moved;
  for (const auto& [name, link] : model.tree->links_)
    if (isMoved(*link))
      moved.push_back(name);
  return moved;
}

StillCollisions stillCollisions(const Model& model, const std::vector<std::string>& moved)
{
  StillCollisions found;
  for (const auto& [name, link] : model.tree->links_)
  {
    if (std::find(moved.begin(), moved.end(), name) != moved.end())
      continue;
    std::size_t count = 0;
    for (const auto& collision : link->collision_array)
    {
      Zone zone;
      ++count;
      zone.name = name + (link->collision_array.size() > 1 ? " " + std::to_string(count) : "");
      zone.in_root = true;
      zone.pose = rounded(poseInRoot(model, *link) * poseOf(collision->origin));
      if (collision->geometry && measure(*collision->geometry, zone))
        found.zones.push_back(zone);
      else
        found.open.push_back("link '" + name +
                             "' has a mesh for collision geometry: give a box, cylinder or sphere in its place");
    }
  }
  return found;
}
}  // namespace urdf_io
}  // namespace pkm_workspace
