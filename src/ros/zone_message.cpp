// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/ros/zone_message.h"

#include <algorithm>
#include <stdexcept>

#include "parameter_values.h"
#include "pkm_workspace/common/problems.h"
#include "pkm_workspace/machine/zone_keys.h"
#include "pkm_workspace/ros/client_fields.h"
#include "pkm_workspace/ros/conversions.h"

namespace pkm_workspace
{
namespace
{
std::vector<double> threeOf(const geometry_msgs::Vector3& v)
{
  return { v.x, v.y, v.z };
}

geometry_msgs::Vector3 vectorMessage(const Eigen::Vector3d& v)
{
  return pkm_workspace::messageOf<geometry_msgs::Vector3>({ v.x(), v.y(), v.z() });
}

/// What is not 0 was given.
void give(const char* key, const std::vector<double>& values, ZoneNumbers& numbers)
{
  if (std::any_of(values.begin(), values.end(), [](double value) { return value != 0.0; }))
    numbers[key] = values;
}

bool turnsNothing(const geometry_msgs::Quaternion& q)
{
  return q.x == 0.0 && q.y == 0.0 && q.z == 0.0 && (q.w == 0.0 || q.w == 1.0);
}

/// One zone of a list of parameters.
Zone readZoneOf(Zone::Use use, const XmlRpcValue& value)
{
  if (value.getType() != XmlRpcValue::TypeStruct)
    throw std::invalid_argument("each zone must be a map with a kind and its keys");
  std::string kind, name;
  ZoneNumbers numbers;
  Problems problems;
  for (const auto& member : value)
  {
    double number = 0.0;
    std::vector<double> list;
    if (member.first == "kind" || member.first == "name")
    {
      if (!pkm_workspace::read(member.second, member.first == "kind" ? kind : name))
        problems.push_back(member.first + " must be a text");
    }
    else if (pkm_workspace::read(member.second, number))
      numbers[member.first] = { number };
    else if (pkm_workspace::read(member.second, list))
      numbers[member.first] = list;
    else
      problems.push_back(member.first + " must be a number or a list of numbers");
  }
  throwProblems(problems);
  return readZone(use, kind, name, numbers);
}
}  // namespace

Zone fromMessage(const ToolZone& message)
{
  Problems problems;
  if (message.use != ToolZone::KEEP_IN && message.use != ToolZone::KEEP_OUT)
    problems.push_back("use = " + std::to_string(message.use) + " must be KEEP_IN = 1 or KEEP_OUT = 2");
  if (message.kind < ToolZone::BOX || message.kind > ToolZone::HALF_SPACE)
    problems.push_back("kind = " + std::to_string(message.kind) +
                       " must be BOX = 1, CYLINDER = 2, SPHERE = 3 or HALF_SPACE = 4");
  throwProblems(problems);
  ZoneNumbers numbers;
  numbers[message.kind == ToolZone::HALF_SPACE ? "point" : "center"] = { message.pose.position.x,
                                                                         message.pose.position.y,
                                                                         message.pose.position.z };
  const geometry_msgs::Quaternion& q = message.pose.orientation;
  if (!turnsNothing(q))
    numbers["orientation"] = { q.x, q.y, q.z, q.w };
  give("sides", threeOf(message.sides), numbers);
  give("radius", { message.radius }, numbers);
  give("height", { message.height }, numbers);
  give("normal", threeOf(message.normal), numbers);
  Zone zone = readZone(message.use == ToolZone::KEEP_IN ? Zone::Use::KEEP_IN : Zone::Use::KEEP_OUT,
                       ZONE_KINDS[message.kind - 1U], message.name, numbers, ZoneNames::FIELDS);
  zone.in_root = message.in_root;
  return zone;
}

ToolZone toMessage(const Zone& zone)
{
  ToolZone message;
  message.use = zone.use == Zone::Use::KEEP_IN ? ToolZone::KEEP_IN : ToolZone::KEEP_OUT;
  message.kind = static_cast<std::uint8_t>(static_cast<int>(zone.kind) + 1);
  message.name = zone.name;
  message.pose = toMessage(zone.pose);
  if (zone.kind == ZoneKind::BOX)
    message.sides = vectorMessage(zone.sides);
  message.radius = zone.radius;
  message.height = zone.height;
  if (zone.kind == ZoneKind::HALF_SPACE)
    message.normal = vectorMessage(zone.normal);
  message.in_root = zone.in_root;
  return message;
}

std::vector<Zone> readZones(Zone::Use use, const XmlRpcValue& list)
{
  if (list.getType() != XmlRpcValue::TypeArray)
    throw std::invalid_argument("it must be a list of zones");
  std::vector<Zone> zones;
  Problems problems;
  for (int k = 0; k < list.size(); ++k)
    try
    {
      zones.push_back(readZoneOf(use, list[k]));
      zones.back().in_root = true;
    }
    catch (const std::invalid_argument& reason)
    {
      problems.push_back("zone " + std::to_string(k + 1) + ": " + reason.what());
    }
  throwProblems(problems);
  return zones;
}
}  // namespace pkm_workspace
