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
/// Of a job in G-code: where the controller's zero is, and where the tool is before the job.
inline auto origin(const Triple& point)
{
  return [point](auto& request) { request.origin = messageOf(point); };
}
inline auto tool_at(const Triple& point)
{
  return [point](auto& request) {
    request.use_tool_at = true;
    request.tool_at = messageOf(point);
  };
}
/// Offsets of G54, G55, ... before the job.
inline auto work_offsets(const std::vector<Triple>& offsets)
{
  return [offsets](auto& request) {
    for (const Triple& offset : offsets)
      request.work_offsets.push_back(messageOf(offset));
  };
}
/// Speed of G0 [m/s].
inline auto rapid_feed(double value)
{
  return [value](auto& request) { request.rapid_feed = value; };
}
inline auto most_listed(std::int64_t value)
{
  return [value](auto& request) { request.most_listed = value; };
}
inline auto top_by_slicer(bool value = true)
{
  return [value](auto& request) { request.top_by_slicer = value; };
}
/// Of a paving: how its set hangs together, and whether two points of it are connected.
inline auto components(bool value = true)
{
  return [value](auto& request) { request.components = value; };
}
inline auto connect(const Triple& from, const Triple& to)
{
  return [from, to](auto& request) { request.connect = { messageOf(from), messageOf(to) }; };
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
/// Name of a file in the node's ~certificate_folder for the reasons of the proof.
inline auto certificate(const std::string& name)
{
  return [name](auto& request) { request.certificate = name; };
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
}  // namespace with
}  // namespace pkm_workspace
