// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <geometry_msgs/Point.h>
#include <pkm_workspace/CriterionRequest.h>
#include <pkm_workspace/ToolSegment.h>
#include <pkm_workspace/ToolZone.h>

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace pkm_workspace
{
/// x, y, z of a point [m] or of a direction.
using Triple = std::array<double, 3>;

/// @tparam Message geometry_msgs/Point or Vector3
template <class Message = geometry_msgs::Point>
Message messageOf(const Triple& triple)
{
  Message message;
  message.x = triple[0];
  message.y = triple[1];
  message.z = triple[2];
  return message;
}

/// Pieces of a path.
inline ToolSegment line(const Triple& start, const Triple& end)
{
  ToolSegment segment;
  segment.kind = ToolSegment::LINE;
  segment.start = messageOf(start);
  segment.end = messageOf(end);
  return segment;
}

/// The arc of a circle through three points.
inline ToolSegment arc(const Triple& start, const Triple& via, const Triple& end)
{
  ToolSegment segment = line(start, end);
  segment.kind = ToolSegment::ARC_THROUGH;
  segment.via = messageOf(via);
  return segment;
}

/// The arc from start about the axis through the center [rad]; a helix where it climbs along the axis [m].
inline ToolSegment turn(const Triple& start, const Triple& center, const Triple& axis, double angle, double lift = 0.0)
{
  ToolSegment segment;
  segment.kind = ToolSegment::ARC;
  segment.start = messageOf(start);
  segment.center = messageOf(center);
  segment.axis = messageOf<geometry_msgs::Vector3>(axis);
  segment.angle = angle;
  segment.lift = lift;
  return segment;
}

/// What a request holds, by name, to be handed to a call of Client: machine.largestRegion(with::shape("cube"),
/// with::psi_min(0.4)). Each takes effect on a request that has such a field, and does not compile for another.
namespace with
{
// The request's own.
inline auto frame(const std::string& name)
{
  return [name](auto& request) { request.header.frame_id = name; };
}
inline auto shape(const std::string& name)
{
  return [name](auto& request) { request.shape = name; };
}
/// Sides of a box.
inline auto proportions(const Triple& sides)
{
  return [sides](auto& request) { request.proportions = messageOf<geometry_msgs::Vector3>(sides); };
}
/// Radius over height of a cylinder.
inline auto ratio(double least, double largest)
{
  return [least, largest](auto& request) {
    request.ratio_min = least;
    request.ratio_max = largest;
  };
}
/// In place of it, of a cylinder as high as possible [m].
inline auto radius(double value)
{
  return [value](auto& request) { request.radius = value; };
}
/// In place of both, of a cylinder as wide as possible [m].
inline auto height(double value)
{
  return [value](auto& request) { request.height = value; };
}
/// Sides along x and y of a box as high as possible [m].
inline auto footprint(double x, double y)
{
  return [x, y](auto& request) {
    request.footprint_x = x;
    request.footprint_y = y;
  };
}
/// Those of a polytope, seen from its center.
inline auto vertices(const std::vector<Triple>& points)
{
  return [points](auto& request) {
    for (const Triple& point : points)
      request.vertices.push_back(messageOf(point));
  };
}
/// Whether the region may be turned about the vertical.
inline auto turned(bool value = true)
{
  return [value](auto& request) { request.turned = value ? request.ON : request.OFF; };
}
/// The only one that is looked at.
inline auto center(const Triple& point)
{
  return [point](auto& request) {
    request.use_center = true;
    request.center = messageOf(point);
  };
}
/// The height of the region's lowest face.
inline auto base_z(double value)
{
  return [value](auto& request) {
    request.use_base = true;
    request.base_z = value;
  };
}
inline auto accuracy(double value)
{
  return [value](auto& request) { request.accuracy = value; };
}
inline auto resolution(double value)
{
  return [value](auto& request) { request.resolution = value; };
}
inline auto time_limit(double seconds)
{
  return [seconds](auto& request) { request.time_limit = seconds; };
}
inline auto tool_speed(double value)
{
  return [value](auto& request) { request.tool_speed = value; };
}
/// Largest accelerations of the joints along a path: one for all, or three.
inline auto joint_acceleration_max(const std::vector<double>& values)
{
  return [values](auto& request) { request.joint_acceleration_max = values; };
}
inline auto joint_speeds_off()
{
  return [](auto& request) { request.joint_speeds_off = true; };
}
inline auto largest_feed()
{
  return [](auto& request) { request.largest_feed = true; };
}
/// How much larger a path may be, too.
inline auto largest_scale()
{
  return [](auto& request) { request.largest_scale = true; };
}
/// Where the center of a region may be.
inline auto search_box(const Triple& lower, const Triple& upper)
{
  return [lower, upper](auto& request) {
    request.use_search_box = true;
    request.min_corner = messageOf(lower);
    request.max_corner = messageOf(upper);
  };
}
/// What is paved; translations that may be chosen.
inline auto box(const Triple& lower, const Triple& upper)
{
  return [lower, upper](auto& request) {
    request.use_box = true;
    request.min_corner = messageOf(lower);
    request.max_corner = messageOf(upper);
  };
}

// Its criterion's; those without an argument choose a constant of CriterionRequest.
inline auto criterion(const CriterionRequest& value)
{
  return [value](auto& request) { request.criterion = value; };
}
inline auto psi_min(double value)
{
  return [value](auto& request) { request.criterion.psi_min = value; };
}
inline auto psi_max(double value)
{
  return [value](auto& request) { request.criterion.psi_max = value; };
}
inline auto psi_auto()
{
  return [](auto& request) { request.criterion.psi = CriterionRequest::AUTO; };
}
inline auto force_min(double value)
{
  return [value](auto& request) { request.criterion.force_min = value; };
}
inline auto force_max(double value)
{
  return [value](auto& request) { request.criterion.force_max = value; };
}
inline auto kappa_max(double value)
{
  return [value](auto& request) { request.criterion.kappa_max = value; };
}
inline auto tool_speed_min(double value)
{
  return [value](auto& request) { request.criterion.tool_speed_min = value; };
}
inline auto tool_force_min(double value)
{
  return [value](auto& request) { request.criterion.tool_force_min = value; };
}
inline auto stiffness_min(double value)
{
  return [value](auto& request) { request.criterion.stiffness_min = value; };
}
inline auto position_error_max(double value)
{
  return [value](auto& request) { request.criterion.position_error_max = value; };
}
inline auto strut_angle_min(double value)
{
  return [value](auto& request) { request.criterion.strut_angle_min = value; };
}
inline auto strut_angle_max(double value)
{
  return [value](auto& request) { request.criterion.strut_angle_max = value; };
}
inline auto ball_tilt_max(double value)
{
  return [value](auto& request) { request.criterion.ball_tilt_max = value; };
}
inline auto joint_speed_max(const std::vector<double>& values)
{
  return [values](auto& request) { request.criterion.joint_speed_max = values; };
}
inline auto joint_effort_max(const std::vector<double>& values)
{
  return [values](auto& request) { request.criterion.joint_effort_max = values; };
}
inline auto joint_stiffness(const std::vector<double>& values)
{
  return [values](auto& request) { request.criterion.joint_stiffness = values; };
}
inline auto strut_stiffness(const std::vector<double>& values)
{
  return [values](auto& request) { request.criterion.strut_stiffness = values; };
}
inline auto joint_error_max(const std::vector<double>& values)
{
  return [values](auto& request) { request.criterion.joint_error_max = values; };
}
inline auto set(std::uint8_t value)
{
  return [value](auto& request) { request.criterion.set = value; };
}
inline auto aspect(std::uint8_t value)
{
  return [value](auto& request) { request.criterion.aspect = value; };
}
inline auto joint_limits(bool on)
{
  return [on](auto& request) { request.criterion.joint_limits = on ? CriterionRequest::ON : CriterionRequest::OFF; };
}
inline auto zones(const std::vector<ToolZone>& values)
{
  return [values](auto& request) { request.criterion.zones = values; };
}
inline auto own_zones(bool on)
{
  return [on](auto& request) { request.criterion.own_zones = on ? CriterionRequest::ON : CriterionRequest::OFF; };
}
inline auto tool_radius(double value)
{
  return [value](auto& request) { request.criterion.tool_radius = value; };
}
inline auto hinge_limits(bool on)
{
  return [on](auto& request) { request.criterion.hinge_limits = on ? CriterionRequest::ON : CriterionRequest::OFF; };
}
}  // namespace with
}  // namespace pkm_workspace
