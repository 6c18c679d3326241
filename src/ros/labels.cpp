// SPDX-License-Identifier: BSD-3-Clause
#include "labels.h"

#include <algorithm>
#include <cmath>

#include "pkm_workspace/ros/conversions.h"

namespace pkm_workspace
{
namespace
{
using Eigen::Vector3d;

/// In a view from above what is nearer seems to be lower by this share of its distance. The views of rviz/ look down by
/// 0.42 rad, whose tangent this is, and half as much again for perspective.
constexpr double SLOPE = 0.67;
/// Where nothing is drawn, the end of a rail is no farther than this from its range [L].
constexpr double FAR = 0.75;

/// As long as it is not turned.
Vector3d straightHalfSidesOf(const Region& region)
{
  const std::vector<double>& dimensions = region.solid.dimensions;
  Vector3d reach = Vector3d::Zero();
  for (const geometry_msgs::Point& vertex : region.vertices)
    reach = reach.cwiseMax(region.size * fromMessage(vertex).cwiseAbs());
  if (!region.vertices.empty())
    return reach;
  if (region.solid.type == shape_msgs::SolidPrimitive::BOX)
    return 0.5 * Vector3d(dimensions[0], dimensions[1], dimensions[2]);
  const double radius = dimensions.back();
  return { radius, radius, dimensions.size() == 1 ? radius : 0.5 * dimensions.front() };
}

/// Of a box along the axes that holds it.
Vector3d halfSidesOf(const Region& region)
{
  const double s = std::abs(std::sin(region.angle));
  const double c = std::abs(std::cos(region.angle));
  const Vector3d straight = straightHalfSidesOf(region);
  return { c * straight.x() + s * straight.y(), s * straight.x() + c * straight.y(), straight.z() };
}

std::vector<Vector3d> cornersOf(const Vector3d& center, const Vector3d& half_sides)
{
  std::vector<Vector3d> corners;
  for (const double x : { -1.0, 1.0 })
    for (const double y : { -1.0, 1.0 })
      for (const double z : { -1.0, 1.0 })
        corners.push_back(center + Vector3d(x, y, z).cwiseProduct(half_sides));
  return corners;
}

/// From wherever it is seen, nothing of the points is lower than this height over the center.
double lowestSeen(const std::vector<Vector3d>& points, const Vector3d& center)
{
  double lowest = center.z();
  for (const Vector3d& point : points)
    lowest = std::min(lowest, point.z() - SLOPE * (point - center).head<2>().norm());
  return lowest;
}

double highestSeen(const std::vector<Vector3d>& points, const Vector3d& center)
{
  double highest = center.z();
  for (const Vector3d& point : points)
    highest = std::max(highest, point.z() + SLOPE * (point - center).head<2>().norm());
  return highest;
}
/// Where the label of a leg stands, seen from the end of what its joint moves: further on its way, of an arc to its
/// outer side too; and from a foot, which stays, level and away from the region.
Vector3d outwardsFrom(const Leg& leg, const Vector3d& end, const Vector3d& way, const Vector3d& center)
{
  if (const auto* const crank = std::get_if<Crank>(&leg.kind))
    return 0.6 * (way.normalized() + (end - mid(crank->pivot)).normalized()).normalized();
  if (!std::holds_alternative<TelescopicStrut>(leg.kind))
    return way.normalized();
  const Vector3d away = end - center;
  const Vector3d level(away.x(), away.y(), 0.0);
  return 1.4 * (level.norm() > 0.1 * away.norm() ? level : away).normalized();
}
}  // namespace

Vector3d labelOf(const Box& box, const Machine& machine, double unit)
{
  const Vector3d center = box.center();
  const std::vector<Vector3d> corners = cornersOf(center, 0.5 * (box.upper - box.lower));
  const Vector3d joints = inverseKinematics(machine, machine.zero()).value_or(Vector3d::Zero());
  double above = 0.0;
  for (int i = 0; i < 3; ++i)
    above += drivenPoint(machine.leg(i), joints[i]).z() - machine.zero().z();
  // below the arrows of the tool, too, which begins near the box; above, three lines have to clear the box
  const double height =
      above > 0.0 ? lowestSeen(corners, center) - 360.0 * unit : highestSeen(corners, center) + 100.0 * unit;
  return { center.x(), center.y(), height };
}

LabelPlaces::LabelPlaces(const Region& region, const Machine& machine, const DrawnRails& rails, double unit)
  : unit_(unit), center_(region.size > 0.0 ? fromMessage(region.center) : machine.zero())
{
  if (region.size > 0.0)
    corners_ = cornersOf(center_, halfSidesOf(region));
  double above = 0.0;
  for (std::size_t i = 0; i < region.joint_ranges.size(); ++i)
  {
    const Leg& leg = machine.leg(static_cast<int>(i));
    const Interval range(region.joint_ranges[i].lower, region.joint_ranges[i].upper);
    above += drivenPoint(leg, range.mid()).z() - center_.z();
    of_rails_.push_back(labelOf(leg, rails[i], range));
  }
  is_below_ = above > 0.0;
}

Vector3d LabelPlaces::labelOf(const Leg& leg, const Interval& drawn, const Interval& range)
{
  const double reach = FAR * 1000.0 * unit_;
  const Interval near(std::max(leg.limits.lower(), range.lower() - reach),
                      std::min(leg.limits.upper(), range.upper() + reach));
  const Interval rail = hasAngle(leg) ? range : hull(drawn.isEmpty() ? near : drawn, range);
  const auto at = [&leg](double rho) { return drivenPoint(leg, rho); };
  const bool is_upper = (at(rail.upper()) - center_).norm() >= (at(rail.lower()) - center_).norm();
  const double last = is_upper ? rail.upper() : rail.lower(), step = hasAngle(leg) ? 1e-3 : 1000.0 * unit_;
  const Vector3d end = at(last);
  const Vector3d outwards = outwardsFrom(leg, end, end - at(is_upper ? last - step : last + step), center_);
  // two lines are as high as they are wide, nearly
  const Vector3d label =
      end + 150.0 * unit_ * outwards + (1.0 - std::min(1.0, std::abs(outwards.z()))) * 60.0 * unit_ * Vector3d::UnitZ();
  for (const Vector3d& point :
       { at(rail.lower()), at(rail.upper()), Vector3d(label - 80.0 * unit_ * Vector3d::UnitZ()) })
    rail_ends_.push_back(point);
  return label;
}

Vector3d LabelPlaces::ofRegion() const
{
  const double height = is_below_ ? lowestSeen(corners_, center_) - 70.0 * unit_ : highestSeen(corners_, center_);
  return { center_.x(), center_.y(), height };
}

Vector3d LabelPlaces::ofHypotheses() const
{
  std::vector<Vector3d> all = rail_ends_;
  all.insert(all.end(), corners_.begin(), corners_.end());
  all.push_back(is_below_ && !corners_.empty() ? ofRegion() : center_);
  const auto is_lower = [](const Vector3d& one, const Vector3d& other) { return one.z() < other.z(); };
  const double lowest = std::min_element(all.begin(), all.end(), is_lower)->z();
  Vector3d middle = Vector3d::Zero();  // of what is about as low as anything
  double count = 0.0;
  for (const Vector3d& point : all)
    if (point.z() < lowest + 100.0 * unit_)
    {
      middle += point;
      count += 1.0;
    }
  middle /= count;
  return { middle.x(), middle.y(), lowestSeen(all, middle) - 150.0 * unit_ };
}
}  // namespace pkm_workspace
