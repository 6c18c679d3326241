// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/region/witness_points.h"

#include "pkm_workspace/interval/turning.h"
#include "pkm_workspace/region/zone_contact.h"

namespace pkm_workspace
{
namespace
{
/// Kept at the most; the oldest ones make room.
constexpr std::size_t MAX_LEARNT = 16;
constexpr std::size_t MAX_BAD = 64;
/// Learnt places closer than this, relative to the region, are one.
constexpr double LEAST_DISTANCE = 0.05;
/// How far beneath the surface of zones bad points are, in roundings; for regions that are thin, relative to their
/// widest extent, enough that a segment beside such a point is proved bad.
constexpr double DEPTH = 16.0;
constexpr double DEPTH_OF_SEGMENTS = 4096.0;
constexpr double THIN = 0.1;
}  // namespace

WitnessPoints::WitnessPoints(const Shape& shape, const std::vector<ZoneToKeepOut>& keep_out)
  : shape_(shape), extremes_(shape.extremePoints().size()), of_shape_(shape.extremePoints())
{
  if (shape.ownProof() == nullptr)
    keep_out_ = keep_out;
  const Eigen::Vector3d extents = shape.halfExtents().at(1.0);
  const bool is_thin = extents.minCoeff() <= THIN * extents.maxCoeff();
  depth_ = is_thin ? DEPTH_OF_SEGMENTS : DEPTH;
}

/// Where a region that grows about the center meets the zone first; floating point.
Eigen::Vector3d WitnessPoints::contact(const ZoneToKeepOut& zone, const Eigen::Vector3d& center, double angle) const
{
  if (angle == 0.0)
    return firstContact(zone.numbers, shape_, center);
  const Eigen::Vector3d seen = firstContact(turnedBack(zone.numbers, center, angle), shape_, center);
  return center + turnedAboutZ(seen - center, angle);
}

const std::vector<Eigen::Vector3d>& WitnessPoints::badNear(const Eigen::Vector3d& center, double angle,
                                                           std::vector<Eigen::Vector3d>& room) const
{
  if (keep_out_.empty())
    return bad_;
  room = bad_;
  for (const ZoneToKeepOut& zone : keep_out_)
    if (const auto point = pointWithin(zone, contact(zone, center, angle), depth_))
      room.push_back(*point);
  return room;
}

const std::vector<Eigen::Vector3d>& WitnessPoints::keptOut(const Eigen::Vector3d& center, double angle,
                                                           std::vector<Eigen::Vector3d>& room) const
{
  if (keep_out_.empty())
    return bad_;
  room = bad_;
  for (const ZoneToKeepOut& zone : keep_out_)
    room.push_back(pointAround(zone.numbers, contact(zone, center, angle)));
  return room;
}

void WitnessPoints::learn(const Eigen::Vector3d& bad_point)
{
  if (bad_.size() < MAX_BAD)
    bad_.push_back(bad_point);
  else
    bad_[next_bad_++ % MAX_BAD] = bad_point;
}

void WitnessPoints::learn(const Eigen::Vector3d& center, double size, const Eigen::Vector3d& bad_point)
{
  learn(bad_point);
  learnPlace(center, size, bad_point);
}

void WitnessPoints::learnPlace(const Eigen::Vector3d& center, double size, const Eigen::Vector3d& point)
{
  if (const auto place = shape_.placeOf(point - center, size))
    learnPlace(*place, size);
}

void WitnessPoints::learnPlace(const GrowingVector& k, double size)
{
  const double least = LEAST_DISTANCE * shape_.halfExtents().at(size).maxCoeff();
  for (std::size_t known = extremes_; known < of_shape_.size(); ++known)
    if ((of_shape_[known] - k).at(size).cwiseAbs().maxCoeff() < least)
    {
      of_shape_[known] = k;
      return;
    }
  if (of_shape_.size() < extremes_ + MAX_LEARNT)
    of_shape_.push_back(k);
  else
    of_shape_[extremes_ + next_place_++ % MAX_LEARNT] = k;
}
}  // namespace pkm_workspace
