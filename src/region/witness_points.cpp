// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/region/witness_points.h"

namespace pkm_workspace
{
namespace
{
/// Kept at the most; the oldest ones make room.
constexpr std::size_t MAX_LEARNT = 16;
constexpr std::size_t MAX_BAD = 64;
/// Learnt places closer than this, relative to the region, are one.
constexpr double LEAST_DISTANCE = 0.05;
}  // namespace

WitnessPoints::WitnessPoints(const Shape& shape, const Criterion& criterion)
  : shape_(shape), extremes_(shape.extremePoints().size()), of_shape_(shape.extremePoints())
{
  for (const Zone& zone : criterion.zones)
    if (zone.use == Zone::Use::KEEP_OUT && shape.ownProof() == nullptr)
      keep_out_.push_back(enclosed(zone, criterion.tool_radius));
}

const std::vector<Eigen::Vector3d>& WitnessPoints::badNear(const Eigen::Vector3d& center,
                                                           std::vector<Eigen::Vector3d>& room) const
{
  if (keep_out_.empty())
    return bad_;
  room = bad_;
  for (const EnclosedZone& zone : keep_out_)
    if (const auto point = pointWithin(zone, center))
      room.push_back(*point);
  return room;
}

const std::vector<Eigen::Vector3d>& WitnessPoints::keptOut(const Eigen::Vector3d& center,
                                                           std::vector<Eigen::Vector3d>& room) const
{
  if (keep_out_.empty())
    return bad_;
  room = bad_;
  for (const EnclosedZone& zone : keep_out_)
    room.push_back(pointAround(zone, center));
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
