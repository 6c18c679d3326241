// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/machine/zone.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "pkm_workspace/interval/decimal.h"

namespace pkm_workspace
{
namespace
{
std::string inWords(const Eigen::Vector3d& v)
{
  return "(" + exact(v.x()) + ", " + exact(v.y()) + ", " + exact(v.z()) + ")";
}

/// Squares of measures stay ordinary numbers.
constexpr double LEAST_MEASURE = 1e-100;
constexpr double LARGEST_MEASURE = 1e100;

bool isMeasure(double value)
{
  return value >= LEAST_MEASURE && value <= LARGEST_MEASURE;
}

/// "box 'column'", or "box".
std::string named(const Zone& zone)
{
  const std::string kind =
      zone.kind == ZoneKind::HALF_SPACE ? "half-space" : ZONE_KINDS[static_cast<std::size_t>(zone.kind)];
  return kind + (zone.name.empty() ? "" : " '" + zone.name + "'");
}

bool isTurned(const Pose& pose)
{
  return pose.orientation[0] != 0.0 || pose.orientation[1] != 0.0 || pose.orientation[2] != 0.0;
}

std::string turnInWords(const Pose& pose)
{
  const auto& q = pose.orientation;
  return isTurned(pose) ? ", turned by the quaternion (" + exact(q[0]) + ", " + exact(q[1]) + ", " + exact(q[2]) +
                              ", " + exact(q[3]) + ")"
                        : "";
}

std::string measuresInWords(const Zone& zone)
{
  switch (zone.kind)
  {
    case ZoneKind::BOX:
      return " and sides " + inWords(zone.sides) + " m";
    case ZoneKind::CYLINDER:
      return ", radius " + exact(zone.radius) + " m and " +
             (std::isfinite(zone.height) ? "height " + exact(zone.height) + " m" : "no ends");
    case ZoneKind::SPHERE:
      return " and radius " + exact(zone.radius) + " m";
    case ZoneKind::HALF_SPACE:
      break;
  }
  return " into the direction " + inWords(zone.normal);
}

/// The least measure that moving its surfaces inward by the tool's radius makes smaller, twice; or infinite.
double leastWidth(const Zone& zone)
{
  switch (zone.kind)
  {
    case ZoneKind::BOX:
      return zone.sides.minCoeff();
    case ZoneKind::CYLINDER:
      return std::min(2.0 * zone.radius, zone.height);
    case ZoneKind::SPHERE:
      return 2.0 * zone.radius;
    case ZoneKind::HALF_SPACE:
      break;
  }
  return INF;
}

bool measuresAreOrdinary(const Zone& zone)
{
  switch (zone.kind)
  {
    case ZoneKind::BOX:
      return isMeasure(zone.sides.x()) && isMeasure(zone.sides.y()) && isMeasure(zone.sides.z());
    case ZoneKind::CYLINDER:
      return isMeasure(zone.radius) && (isMeasure(zone.height) || zone.height == INF);
    case ZoneKind::SPHERE:
      return isMeasure(zone.radius);
    case ZoneKind::HALF_SPACE:
      break;
  }
  return zone.normal.allFinite() && isMeasure(zone.normal.cwiseAbs().maxCoeff());
}

const char* allowedMeasures(ZoneKind kind)
{
  constexpr const char* ALLOWED[] = {
    "its sides [m] must be positive and finite (1e-100 to 1e100)",
    "its radius and height [m] must be positive and finite (1e-100 to 1e100), or its height infinite",
    "its radius [m] must be positive and finite (1e-100 to 1e100)",
    "its normal must be finite and not 0 (1e-100 to 1e100)",
  };
  return ALLOWED[static_cast<std::size_t>(kind)];
}

void validateZone(const Zone& zone, double tool_radius, Problems& problems)
{
  const std::string what = ZONE_USES[static_cast<std::size_t>(zone.use)] + (" " + describe(zone)) + ": ";
  try
  {
    static_cast<void>(rotationOf(zone.pose));
  }
  catch (const std::invalid_argument& reason)
  {
    complain(problems, what, reason.what());
    return;
  }
  const double farthest = zone.pose.translation.cwiseAbs().maxCoeff();
  if (!zone.pose.translation.allFinite() || farthest > LARGEST_MEASURE)
    complain(problems, what, "its place [m] must be finite (at most 1e100 from 0)");
  else if (!measuresAreOrdinary(zone))
    complain(problems, what, allowedMeasures(zone.kind));
  else if (zone.use == Zone::Use::KEEP_IN && !(leastWidth(zone) > 2.0 * tool_radius))
    complain(problems, what, "a tool of radius ", exact(tool_radius), " m leaves nothing of it: it must be wider than ",
             "twice the radius");
}
}  // namespace

bool isElsewhere(const Zone& zone)
{
  return isTurned(zone.frame) || !zone.frame.translation.isZero(0.0);
}

std::string title(const Zone& zone)
{
  return named(zone) + (zone.name.empty() ? " at " + inWords(zone.pose.translation) + " m" : "");
}

std::string describe(const Zone& zone)
{
  const std::string place = zone.kind == ZoneKind::HALF_SPACE ? " from " : " with center ";
  return named(zone) + place + inWords(zone.pose.translation) + " m" + measuresInWords(zone) + turnInWords(zone.pose) +
         (isElsewhere(zone) ? " (root link's frame)" : "");
}

void validateZones(const std::vector<Zone>& zones, double tool_radius, Problems& problems)
{
  if (zones.size() > MOST_ZONES)
    complain(problems, "there are ", zones.size(), " zones to keep in or out of, at most ", MOST_ZONES, " are allowed");
  if (!(tool_radius >= 0.0 && tool_radius <= LARGEST_MEASURE))
    complain(problems, "tool_radius = ", exact(tool_radius), " m must be positive and finite, or 0");
  else
    for (const Zone& zone : zones)
      validateZone(zone, tool_radius, problems);
}

void requireEffect(double tool_radius, const std::vector<Zone>& zones, Problems& problems)
{
  if (tool_radius > 0.0 && zones.empty())
    complain(problems, "tool_radius = ", exact(tool_radius),
             " m is without effect: there are no zones to keep in or out of");
}

std::string zonesInWords(const std::vector<Zone>& zones, double tool_radius)
{
  std::string text;
  for (const Zone& zone : zones)
    text += std::string(zone.use == Zone::Use::KEEP_IN ? ", tool within the " : ", tool out of the ") + describe(zone);
  return text + (tool_radius > 0.0 ? ", tool radius " + exact(tool_radius) + " m" : "");
}

std::string zonesInShort(const std::vector<Zone>& zones, double tool_radius)
{
  const auto out =
      std::count_if(zones.begin(), zones.end(), [](const Zone& zone) { return zone.use == Zone::Use::KEEP_OUT; });
  const auto in = static_cast<std::ptrdiff_t>(zones.size()) - out;
  if (zones.empty())
    return "";
  const auto counted = [](const std::string& word, std::ptrdiff_t count) {
    return count == 0 ? "" : word + std::to_string(count) + (count == 1 ? " zone" : " zones");
  };
  return ", tool " + counted("within ", in) + (in == 0 || out == 0 ? "" : " and ") + counted("out of ", out) +
         (tool_radius > 0.0 ? ", tool radius " + exact(tool_radius) + " m" : "");
}

void addCollisions(const std::vector<Zone>& collisions, const std::vector<std::string>& open,
                   const std::string& switched_on, std::vector<Zone>& zones, Problems& problems)
{
  for (const std::string& phrase : open)
    complain(problems, switched_on, ": ", phrase);
  if (collisions.empty() && open.empty())
    complain(problems, switched_on,
             " is without effect: no link of the URDF that stands still has a <collision>; give the zones themselves");
  zones.insert(zones.end(), collisions.begin(), collisions.end());
}

std::vector<Zone> seenFrom(const Pose& root, std::vector<Zone> zones)
{
  for (Zone& zone : zones)
    if (zone.in_root)
      zone.frame = root;
  return zones;
}
}  // namespace pkm_workspace
