// SPDX-License-Identifier: BSD-3-Clause
#include "still_collisions.h"

#include <tinyxml2.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <map>

#include "element.h"

namespace pkm_workspace
{
namespace urdf_io
{
namespace
{
/// Each measure grows by this share of it and of all ways from the root to it: more than rounding the place can move
/// it.
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

/// A place in the root frame, and the sum of the lengths of all steps that lead to it [m].
struct Way
{
  Eigen::Isometry3d pose;
  double length;
};

/// All joints on the way are fixed. @param pose in the link
Way wayFromRoot(const Model& model, const urdf::Link& link, const Eigen::Isometry3d& pose)
{
  Way way{ pose, pose.translation().norm() };
  const urdf::Link* at = &link;
  while (at->parent_joint)
  {
    const Origin& origin = model.originOf(*at->parent_joint);
    way = { poseOf(origin) * way.pose, way.length + origin.xyz.norm() };
    at = &model.link(at->parent_joint->parent_link_name);
  }
  return way;
}

/// urdfdom leaves out what follows in a link after what it cannot read, and all but the first geometry.
/// @param read how many it has read
bool isAllRead(const XMLElement& link, std::size_t read)
{
  const auto collisions = childrenOf(link, "collision");
  return collisions.size() == read &&
         std::all_of(collisions.begin(), collisions.end(), [](const XMLElement* collision) {
           const auto geometries = childrenOf(*collision, "geometry");
           const XMLElement* const shape = geometries.empty() ? nullptr : geometries[0]->FirstChildElement();
           return geometries.size() == 1 && shape != nullptr && shape->NextSiblingElement() == nullptr;
         });
}

/// The links of the text by their names; a name that stands twice is refused elsewhere.
std::map<std::string, const XMLElement*> linksOf(const tinyxml2::XMLDocument& text)
{
  std::map<std::string, const XMLElement*> links;
  for (const XMLElement* const link : childrenOf(*text.RootElement(), "link"))
    links[nameOf(*link)] = link;
  return links;
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

/// @param distance that counts for its growth [m] @return whether the zone can have this geometry
bool measure(const urdf::Geometry& geometry, double distance, Zone& zone)
{
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
  tinyxml2::XMLDocument text;
  text.Parse(model.document.elements.c_str());
  for (const auto& [name, element] : linksOf(text))
  {
    if (std::find(moved.begin(), moved.end(), name) != moved.end())
      continue;
    const urdf::Link& link = model.link(name);
    if (!isAllRead(*element, link.collision_array.size()))
      found.open.push_back("link '" + name +
                           "': its <collision>s could not all be read; each needs one <geometry> with " +
                           "one shape, and the link no other element that is wrong");
    for (std::size_t k = 0; k < link.collision_array.size(); ++k)
    {
      const urdf::Collision& collision = *link.collision_array[k];
      const Way way = wayFromRoot(model, link, poseOf(collision.origin));
      Zone zone;
      zone.name = name + (link.collision_array.size() > 1 ? " " + std::to_string(k + 1) : "");
      zone.in_root = true;
      zone.pose = rounded(way.pose);
      if (collision.geometry && measure(*collision.geometry, way.length, zone))
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
