// SPDX-License-Identifier: BSD-3-Clause
#include "drawn_rails.h"

#include <Eigen/Geometry>
#include <algorithm>

#include "pkm_workspace/machine/leg_state.h"

namespace pkm_workspace
{
namespace urdf_io
{
namespace
{
using Eigen::Isometry3d;
using Eigen::Vector3d;

constexpr double BESIDE = 0.2;  ///< of the strut's length: how far from its line a rail may be drawn

Isometry3d transformOf(const urdf::Pose& pose)
{
  const urdf::Rotation& turn = pose.rotation;
  return Eigen::Translation3d(pose.position.x, pose.position.y, pose.position.z) *
         Eigen::Quaterniond(turn.w, turn.x, turn.y, turn.z);
}

Vector3d halfSides(const urdf::Geometry& geometry)
{
  if (const auto* box = dynamic_cast<const urdf::Box*>(&geometry))
    return 0.5 * Vector3d(box->dim.x, box->dim.y, box->dim.z);
  if (const auto* cylinder = dynamic_cast<const urdf::Cylinder*>(&geometry))
    return { cylinder->radius, cylinder->radius, 0.5 * cylinder->length };
  return Vector3d::Zero();
}

/// Takes in what a link that stands still looks like.
Interval looksAlong(const urdf::Link& link, const Isometry3d& place, const Leg& leg)
{
  const Vector3d start = drivenPoint(leg, 0.0);
  const Vector3d axis = drivenPoint(leg, 1.0) - start;
  const double beside = BESIDE * slidingStrut(leg).length.mid();
  Interval drawn = Interval::empty();
  for (const auto& visual : link.visual_array)
  {
    const Isometry3d at = place * transformOf(visual->origin);
    const Vector3d offset = at.translation() - start;
    if (!visual->geometry || (offset - offset.dot(axis) * axis).norm() > beside)
      continue;
    const double reach = (at.rotation().transpose() * axis).cwiseAbs().dot(halfSides(*visual->geometry));
    drawn = hull(drawn, Interval(offset.dot(axis) - reach, offset.dot(axis) + reach));
  }
  return drawn;
}

Interval looksBelow(const urdf::Link& link, const Isometry3d& place, const Leg& leg)
{
  Interval drawn = looksAlong(link, place, leg);
  for (const auto& joint : link.child_joints)
    if (joint->type == urdf::Joint::FIXED)
      for (const auto& child : link.child_links)
        if (child->name == joint->child_link_name)
          drawn = hull(drawn, looksBelow(*child, place * transformOf(joint->parent_to_joint_origin_transform), leg));
  return drawn;
}
}  // namespace

Interval drawnAlong(const Model& model, const Leg& leg)
{
  if (!std::holds_alternative<SlidingStrut>(leg.kind))
    return Interval::empty();
  return looksBelow(*model.tree->getRoot(), Isometry3d::Identity(), leg);
}
}  // namespace urdf_io
}  // namespace pkm_workspace
