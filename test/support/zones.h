// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <vector>

#include "pkm_workspace/interval/box.h"
#include "pkm_workspace/machine/zone.h"
#include "support/random.h"

namespace pkm_workspace
{
namespace test
{
/// How a point stands to a zone, in 100 digits and by the definition: quaternions turn the point into the zone's own
/// axes, where its distances from the surfaces are read off.
class ZoneOracle
{
public:
  using Number = boost::multiprecision::cpp_bin_float_100;
  using Vector = std::array<Number, 3>;

  ZoneOracle(const Zone& zone, double tool_radius) : zone_(zone), tool_radius_(tool_radius) {}

  /// How far the tool keeps within a zone to keep in, or out of one to keep out [m]; negative where it does not.
  Number clearance(const Vector& point) const
  {
    const Vector u = turnedBack(zone_.pose, turnedBack(zone_.frame, point));
    const Number outside = beyond(u);
    return zone_.use == Zone::Use::KEEP_IN ? Number(-outside - tool_radius_) : Number(outside - tool_radius_);
  }
  bool isGood(const Vector& point) const { return clearance(point) >= 0; }

private:
  static Vector cross(const Vector& a, const Vector& b)
  {
    return { a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0] };
  }

  /// Where a point of the outer frame is in the frame that the pose tells: q* (p - t) q / |q|^2.
  static Vector turnedBack(const Pose& pose, const Vector& point)
  {
    const Vector v = { -Number(pose.orientation[0]), -Number(pose.orientation[1]), -Number(pose.orientation[2]) };
    const Number w = pose.orientation[3];
    const Number norm = v[0] * v[0] + v[1] * v[1] + v[2] * v[2] + w * w;
    Vector p;
    for (std::size_t k = 0; k < 3; ++k)
      p[k] = point[k] - pose.translation[static_cast<int>(k)];
    const Vector twice = cross(v, p);
    const Vector again = cross(v, twice);
    for (std::size_t k = 0; k < 3; ++k)
      p[k] += 2 * (w * twice[k] + again[k]) / norm;
    return p;
  }

  /// The farthest that u is beyond any of the surfaces; negative within.
  Number beyond(const Vector& u) const
  {
    const auto over = [&u](std::size_t k, const Number& half) { return Number(abs(u[k]) - half); };
    const auto larger = [](const Number& a, const Number& b) { return a < b ? b : a; };
    switch (zone_.kind)
    {
      case Zone::Kind::BOX:
        return larger(over(0, Number(zone_.sides[0]) / 2),
                      larger(over(1, Number(zone_.sides[1]) / 2), over(2, Number(zone_.sides[2]) / 2)));
      case Zone::Kind::CYLINDER:
      {
        const Number aside = sqrt(u[0] * u[0] + u[1] * u[1]) - zone_.radius;
        return std::isfinite(zone_.height) ? larger(aside, over(2, Number(zone_.height) / 2)) : aside;
      }
      case Zone::Kind::SPHERE:
        return sqrt(u[0] * u[0] + u[1] * u[1] + u[2] * u[2]) - zone_.radius;
      case Zone::Kind::HALF_SPACE:
        break;
    }
    const Eigen::Vector3d& n = zone_.normal;
    const Vector normal = { n[0], n[1], n[2] };
    const Number length = sqrt(normal[0] * normal[0] + normal[1] * normal[1] + normal[2] * normal[2]);
    return -(u[0] * normal[0] + u[1] * normal[1] + u[2] * normal[2]) / length;
  }

  Zone zone_;
  double tool_radius_;
};

inline bool keepsToZones(const std::vector<Zone>& zones, double tool_radius, const ZoneOracle::Vector& point)
{
  for (const Zone& zone : zones)
    if (!ZoneOracle(zone, tool_radius).isGood(point))
      return false;
  return true;
}

inline Pose randomPose(Random& random, const Box& space)
{
  Pose pose;
  double norm = 0.0;
  while (norm < 0.1)
  {
    norm = 0.0;
    for (double& part : pose.orientation)
    {
      part = random.uniform(-1.0, 1.0);
      norm += part * part;
    }
  }
  for (double& part : pose.orientation)
    part /= std::sqrt(norm);
  for (int k = 0; k < 3; ++k)
    pose.translation[k] = random.uniform(space.lower[k], space.upper[k]);
  return pose;
}

/// A zone of any kind somewhere in the space, half of them along the axes; to keep in are large ones.
inline Zone randomZone(Random& random, const Box& space, Zone::Use use)
{
  const double size = (space.upper - space.lower).minCoeff() * (use == Zone::Use::KEEP_IN ? 1.0 : 0.3);
  const auto measure = [&] { return size * random.uniform(0.3, 1.0); };
  Zone zone;
  zone.use = use;
  zone.kind = static_cast<Zone::Kind>(random.integer(0, 3));
  zone.pose = randomPose(random, space);
  if (use == Zone::Use::KEEP_IN)
    zone.pose.translation = 0.2 * zone.pose.translation + 0.8 * space.center();
  if (random.once(2))
    zone.pose.orientation = Pose().orientation;
  if (random.once(3))
    zone.frame = randomPose(random, { Eigen::Vector3d::Constant(-0.1), Eigen::Vector3d::Constant(0.1) });
  zone.sides = { measure(), measure(), measure() };
  zone.radius = 0.5 * measure();
  zone.height = random.once(3) ? INF : measure();
  zone.normal = { random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0), random.uniform(0.2, 3.0) };
  if (random.once(3))
    zone.normal = Eigen::Vector3d(0.0, 0.0, random.sign());
  return zone;
}

/// One zone to keep in, mostly, and up to three to keep out, with a tool now and then.
inline std::vector<Zone> randomZones(Random& random, const Box& space)
{
  std::vector<Zone> zones;
  if (!random.once(4))
    zones.push_back(randomZone(random, space, Zone::Use::KEEP_IN));
  for (int k = random.integer(zones.empty() ? 1 : 0, 3); k > 0; --k)
    zones.push_back(randomZone(random, space, Zone::Use::KEEP_OUT));
  return zones;
}
}  // namespace test
}  // namespace pkm_workspace
