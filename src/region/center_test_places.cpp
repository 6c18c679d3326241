// SPDX-License-Identifier: BSD-3-Clause
// The part of CenterTest that says where the points of regions are.
#include <algorithm>

#include "pkm_workspace/region/center_test.h"

namespace pkm_workspace
{
/// @param angles a single 0 where regions are not to be turned
void CenterTest::place(const Box& centers, double size, const Interval& angles)
{
  angles_ = angles;
  places_ = witnesses_.ofShape();
  places_.insert(places_.end(), between_.begin(), between_.end());
  if (angles == Interval(0.0))
  {
    turning_.reset();
    box_ = CenteredBox<double>(centers);
    if (own_)
      box_.slack = own_->slack(size);
    return;
  }
  turning_.emplace(centers, angles, size, places_);
  box_ = turning_->box();
  places_ = turning_->places();
}

/// What a form over the box moved by a place says of center and angle.
TurningForm CenterTest::overNode(std::size_t place, const AffineForm<double>& form) const
{
  return turning_ ? turning_->formOf(place, form) : TurningForm{ form };
}

/// How far beyond the region the point is for every center, turned by every angle; nothing where that is not affine.
std::optional<TurningForm> CenterTest::avoidance(const BadPoint& bad, double size) const
{
  if (!turning_)
  {
    const auto straight = shape_.avoidance(bad.point, bad.centers, size);
    return straight ? std::make_optional(TurningForm{ *straight }) : std::nullopt;
  }
  const TurningOffset offset(bad.centers, angles_, bad.point);
  const auto turned = shape_.avoidance(Eigen::Vector3d::Zero(), offset.box(), size);
  return turned ? std::make_optional(offset.formOf(*turned)) : std::nullopt;
}

bool CenterTest::isPromising(const Candidate& region)
{
  const std::vector<GrowingVector> places = region.placesOf(witnesses_.ofShape());
  margins_.resize(places.size());
  test_.kernel().margins(pointsOf(places, region.center, region.size).data(), places.size(), margins_.data());
  if (*std::min_element(margins_.begin(), margins_.end()) < 0.0)
    return false;
  const Eigen::Vector3d place = travel_ ? travel_->placeOf(region.center) : region.center;
  if (travel_ && !travel_->leavesCenter(place, region.size, places))
    return false;
  const std::vector<Eigen::Vector3d>& bad = witnesses_.badNear(region.center, region.angle, bad_);
  return std::none_of(bad.begin(), bad.end(), [&](const Eigen::Vector3d& point) {
    const Eigen::Vector3d seen = region.angle == 0.0 ? point : place + turnedAboutZ(point - place, -region.angle);
    return shape_.contains(seen, Box{ place, place }, region.size);
  });
}
}  // namespace pkm_workspace
