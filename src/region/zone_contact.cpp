// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/region/zone_contact.h"

namespace pkm_workspace
{
namespace
{
constexpr int PROJECTIONS = 8;
constexpr int STEPS = 6;
/// Bodies closer than this, relative to their coordinates, touch.
constexpr double TOUCHING = 1e-14;
/// Projections end where they come nearer by less than this share.
constexpr double LEAST_GAIN = 1e-9;

/// A point of the zone, and the point of the region nearest to it.
struct ClosestPair
{
  Eigen::Vector3d of_zone;
  Eigen::Vector3d of_region;

  double distance() const { return (of_zone - of_region).norm(); }
  bool isTouching() const
  {
    return distance() <= TOUCHING * (of_zone.cwiseAbs().maxCoeff() + of_region.cwiseAbs().maxCoeff());
  }
};

/// Projects on the one and on the other: both are convex (von Neumann's alternating projections).
/// @param nearest_of that of the zone to a point
template <class NearestOf>
void project(const NearestOf& nearest_of, const Shape& shape, const Eigen::Vector3d& center, double size,
             ClosestPair& pair)
{
  double before = INF;
  for (int k = 0; k < PROJECTIONS && pair.distance() < before * (1.0 - LEAST_GAIN); ++k)
  {
    before = k == 0 ? INF : pair.distance();
    pair.of_zone = nearest_of(pair.of_region);
    pair.of_region = shape.nearest(pair.of_zone, center, size);
  }
}

/// First with what the zone is all round: near to a round surface projections on it hardly move.
ClosestPair closestPair(const PlainZone<double>& zone, const Shape& shape, const Eigen::Vector3d& center, double size)
{
  ClosestPair pair{ center, center };
  project([&](const Eigen::Vector3d& p) { return nearestOfCore(zone, p); }, shape, center, size, pair);
  pair.of_zone = nearestOf(zone, pair.of_region);
  if (zone.has_ends && !pair.isTouching())
    project([&](const Eigen::Vector3d& p) { return nearestOf(zone, p); }, shape, center, size, pair);
  return pair;
}
}  // namespace

Eigen::Vector3d firstContact(const PlainZone<double>& zone, const Shape& shape, const Eigen::Vector3d& center)
{
  // Newton's method: the distance is convex in the size, and falls as fast as the support along it grows
  double size = 0.0;
  ClosestPair pair = closestPair(zone, shape, center, size);
  for (int step = 0; step < STEPS && !pair.isTouching(); ++step)
  {
    const double distance = pair.distance();
    const double rate = shape.support(Eigen::Vector3d((pair.of_zone - pair.of_region) / distance)).per_size;
    if (!(rate > 0.0))
      break;
    size += distance / rate;
    pair = closestPair(zone, shape, center, size);
  }
  return pair.of_zone;
}

Eigen::Vector3d nearestToZone(const PlainZone<double>& zone, const Shape& shape, const Eigen::Vector3d& center,
                              double size)
{
  return closestPair(zone, shape, center, size).of_region;
}
}  // namespace pkm_workspace
