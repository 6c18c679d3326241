// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pkm_workspace/CriterionRequest.h>
#include <pkm_workspace/ToolZone.h>

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "pkm_workspace/ros/client_fields.h"

namespace pkm_workspace
{
namespace with
{
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
inline auto strut_tilt_max(const std::vector<double>& values)
{
  return [values](auto& request) { request.criterion.strut_tilt_max = values; };
}
/// Where ball joints are not tilted, for all legs or for each.
inline auto ball_axes(const std::vector<Triple>& axes)
{
  return [axes](auto& request) {
    for (const Triple& axis : axes)
      request.criterion.ball_axes.push_back(messageOf<geometry_msgs::Vector3>(axis));
  };
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
/// In place of the node's own of these kinds, such as { "tolerance_length", { 1e-4 } } [m, rad].
inline auto tolerances(const std::map<std::string, std::vector<double>>& kinds)
{
  return [kinds](auto& request) {
    for (const auto& [kind, values] : kinds)
    {
      request.criterion.tolerances.emplace_back();
      request.criterion.tolerances.back().kind = kind;
      request.criterion.tolerances.back().values = values;
    }
  };
}
inline auto own_tolerances(bool on)
{
  return [on](auto& request) { request.criterion.own_tolerances = on ? CriterionRequest::ON : CriterionRequest::OFF; };
}
}  // namespace with
}  // namespace pkm_workspace
