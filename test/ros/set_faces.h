// SPDX-License-Identifier: BSD-3-Clause
// Pictures of sets, and what the colours of their parts say, held against the definitions.
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "../../src/ros/condition_color.h"
#include "drawing.h"
#include "support/definition.h"

namespace pkm_workspace
{
namespace test
{
using Kind = ConditionKind;

inline const std::vector<Kind> KINDS = {
  Kind::REACH,           Kind::JOINT_LOWER,   Kind::JOINT_UPPER,        Kind::ASPECT,
  Kind::PSI_MIN,         Kind::PSI_MAX,       Kind::KAPPA_MAX,          Kind::TOOL_SPEED_MIN,
  Kind::TOOL_FORCE_MIN,  Kind::STIFFNESS_MIN, Kind::POSITION_ERROR_MAX, Kind::STRUT_ANGLE_MIN,
  Kind::STRUT_ANGLE_MAX, Kind::BALL_TILT_MAX, Kind::HINGE_LOWER,        Kind::HINGE_UPPER,
  Kind::KEEP_IN,         Kind::KEEP_OUT
};

struct Case
{
  std::string name;
  Machine machine;
  Criterion criterion;
  std::vector<Kind> kinds;  ///< that end the set
  double share;             ///< of its surface that has one of their colours, at least
  std::optional<Box> box = {};
};

inline std::vector<Case> pictures()
{
  Criterion driven;
  driven.joint_speed_max = { 1.0, 1.1, 1.2 };
  driven.tool_speed_min = 0.85;
  driven.strut_angle_max = 0.7;
  Criterion limited;
  limited.joint_limits = true;
  return { { "psi", orthoglide(), Criterion(), { Kind::PSI_MIN, Kind::PSI_MAX }, 0.99 },
           { "driven", orthoglide(), driven, { Kind::PSI_MIN, Kind::TOOL_SPEED_MIN, Kind::STRUT_ANGLE_MAX }, 0.99 },
           { "limits", orthoglidePrototype(), limited, { Kind::JOINT_LOWER, Kind::JOINT_UPPER, Kind::PSI_MIN }, 0.99 },
           { "flat", uranesx(), Criterion(), { Kind::PSI_MAX }, 0.05 } };
}

inline Paving pavingOf(const Case& each)
{
  PavingQuery query;
  query.criterion = each.criterion;
  query.resolution = 0.03 * each.machine.scale();
  query.box = each.box;
  return pave(each.machine, query);
}

/// With all points where they are.
inline visualization_msgs::MarkerArray shown(const SetPicture& set, const Case& each, double ceiling)
{
  auto array = markersOf(set, premisesOf(each.machine, each.criterion), each.machine, Workspace(), ceiling);
  for (Marker& marker : array.markers)
    for (geometry_msgs::Point& point : marker.points)
    {
      point.x += marker.pose.position.x;
      point.y += marker.pose.position.y;
      point.z += marker.pose.position.z;
    }
  return array;
}

inline Color of(const std_msgs::ColorRGBA& color)
{
  return { color.r, color.g, color.b, color.a };
}

/// Whether one is the other in some light.
inline bool isShadeOf(const Color& color, const Color& full)
{
  const Eigen::Vector3f lit(color.r, color.g, color.b), in_full(full.r, full.g, full.b);
  const float shade = lit.dot(in_full) / in_full.squaredNorm();
  return shade <= 1.0001F && (lit - shade * in_full).norm() < 1e-4F;
}

/// A part of a surface.
struct Face
{
  Eigen::Vector3d middle;
  Eigen::Vector3d outwards;
  double area;
  std::optional<Kind> kind;
};

/// Rectangles of two triangles, or triangles.
inline std::vector<Face> facesOf(const Marker& surface, const std::vector<Kind>& kinds, bool are_triangles = false)
{
  std::vector<Face> faces;
  for (std::size_t i = 0; i < surface.points.size(); i += are_triangles ? 3 : 6)
  {
    const Eigen::Vector3d first = vectorOf(surface.points[i]);
    const Eigen::Vector3d second = vectorOf(surface.points[i + 1]);
    const Eigen::Vector3d third = vectorOf(surface.points[i + 2]);
    const Eigen::Vector3d across = (second - first).cross(third - first);
    Face face{ 0.5 * (first + third), across.normalized(), across.norm(), {} };
    if (are_triangles)
      face = { (first + second + third) / 3.0, across.normalized(), 0.5 * across.norm(), {} };
    for (const Kind kind : kinds)
      if (isShadeOf(of(surface.colors[i]), conditionColor(kind)))
        face.kind = kind;
    faces.push_back(face);
  }
  return faces;
}

/// The first points beyond a face that are bad by the definitions, and what is violated there; none where the set goes
/// on for some boxes.
inline std::set<Kind> firstViolated(const Case& each, const Face& face, double width)
{
  constexpr int STEPS = 400;
  for (int k = 0; k <= STEPS; ++k)
  {
    const Eigen::Vector3d point = face.middle + 4.0 * width * k / STEPS * face.outwards;
    const std::set<Kind> violated = violatedAt(each.machine, each.criterion, point);
    if (!violated.empty())
      return violated;
  }
  return {};
}

/// What is violated first from somewhere near a face in its plane: where two conditions meet, its parts differ.
inline bool isFirstNear(const Case& each, const Face& face, double width)
{
  for (int u = -1; u <= 1; ++u)
    for (int v = -1; v <= 1; ++v)
    {
      Face near = face;
      const Eigen::Vector3d along = face.outwards.unitOrthogonal();
      near.middle += width * (u * along + v * face.outwards.cross(along));
      if (firstViolated(each, near, width).count(*face.kind) > 0)
        return true;
    }
  return false;
}
}  // namespace test
}  // namespace pkm_workspace
