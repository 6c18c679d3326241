// SPDX-License-Identifier: BSD-3-Clause
// The part of CenterSearch that is about places of centers along parallel rails.
#include "pkm_workspace/region/center_search.h"

namespace pkm_workspace
{
void CenterSearch::suspect(const std::vector<Eigen::Vector3d>& points)
{
  for (const Eigen::Vector3d& suspect : points)
  {
    const Eigen::Vector3d point = space_.travel ? space_.travel->placeOf(suspect) : suspect;
    if (testOfCenters().classify(point) == BoxVerdict::OUTSIDE)
      witnesses_.learn(point);
  }
}

/// Makes the region the incumbent if it is larger and proved. @return with a bad point if one stands in the way, of the
/// region's place where there are places; of one that may be turned, where it is in K
ContainmentResult CenterSearch::certify(const Candidate& candidate)
{
  if (!incumbent_.asksFor(candidate.size))
    return {};
  const Candidate region = settled(candidate);
  ContainmentResult proof = incumbent_.certify(region);
  if (proof.bad_point && !query_.turns() && space_.travel)
    *proof.bad_point += space_.travel->placeOf(region.center) - region.center;
  return proof;
}

/// Learns from a region that is refused. Along parallel rails a point is bad for other regions too if it is without
/// joint limits, and then all along the rails. A bad point that no double is cannot be known, but its place in K can;
/// of bodies that are not convex nothing else counts.
void CenterSearch::learn(const Candidate& refused, const ContainmentResult& proof)
{
  if (proof.bad_place)
  {
    witnesses_.learnPlace(*proof.bad_place, refused.size);
    return;
  }
  const Eigen::Vector3d& bad_point = *proof.bad_point;
  if (query_.turns())
  {
    witnesses_.learnPlace(Eigen::Vector3d::Zero(), refused.size, bad_point);
    return;
  }
  if (!space_.travel)
  {
    if (proof.bad_within > 0.0)
      witnesses_.learnPlace(refused.center, refused.size, bad_point);
    else
      witnesses_.learn(refused.center, refused.size, bad_point);
    return;
  }
  const Eigen::Vector3d place = space_.travel->placeOf(refused.center);
  if (testOfCenters().classify(bad_point) == BoxVerdict::OUTSIDE)
    witnesses_.learn(place, refused.size, bad_point);
  else
    witnesses_.learnPlace(place, refused.size, bad_point);
}

/// What boxes of centers are judged by: joint limits apart where centers have places.
const BoxTest& CenterSearch::testOfCenters() const
{
  return test_across_rails_ ? *test_across_rails_ : test_;
}

/// What climbs go by: where every place has a center it need not be known.
const BoxTest& CenterSearch::testOfClimbs() const
{
  return travel_ ? test_ : testOfCenters();
}

/// The same region, moved along parallel rails to where it is farthest from the joint limits.
Candidate CenterSearch::settled(const Candidate& candidate) const
{
  if (!space_.travel)
    return candidate;
  const Eigen::Vector3d place = space_.travel->placeOf(candidate.center);
  const std::vector<GrowingVector> points = candidate.placesOf(witnesses_.ofShape());
  return { space_.travel->centerAt(place, candidate.size, points), candidate.size, candidate.angle };
}

/// The same region where testOfClimbs() is asked for it.
Candidate CenterSearch::searched(const Candidate& candidate) const
{
  return space_.travel && !travel_
             ? Candidate{ space_.travel->placeOf(candidate.center), candidate.size, candidate.angle }
             : settled(candidate);
}
}  // namespace pkm_workspace
