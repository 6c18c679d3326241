// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <limits>
#include <string>
#include <vector>

#include "pkm_workspace/region/shape.h"
#include "support_along.h"

namespace pkm_workspace
{
/// Heights along z that a body reaches from and to.
struct Heights
{
  Growing<double> lower{ 0.0, 0.0 };
  Growing<double> upper{ 0.0, 0.0 };
};

/// As far as it is to the sides of half the height.
inline Heights aboutCenter(double half_height)
{
  return { { 0.0, -half_height }, { 0.0, half_height } };
}

/// K(h) = { x : the first `round` coordinates lie within the radius, the third one of two between the heights }: a
/// sphere (3), a cylinder along z or a disc (2).
class RoundShape : public Shape
{
public:
  RoundShape(std::string name, std::string size_meaning, int round, const Growing<double>& radius,
             const Heights& heights)
    : name_(std::move(name))
    , size_meaning_(std::move(size_meaning))
    , round_(round)
    , radius_(radius)
    , heights_(heights)
    , is_flat_(heights.upper.at(1.0) == heights.lower.at(1.0))
  {}

  std::string name() const override { return name_; }
  std::string sizeMeaning() const override { return size_meaning_; }
  GrowingVector lower() const override { return corner(-1.0, heights_.lower); }
  GrowingVector upper() const override { return corner(1.0, heights_.upper); }
  bool isPrism() const override { return round_ == 2; }

  /// Directions to the faces, edges and corners of a cube.
  std::vector<GrowingVector> extremePoints() const override
  {
    std::vector<GrowingVector> points;
    for (int index = 0; index < 27; ++index)
    {
      Eigen::Vector3d direction(index % 3 - 1, index / 3 % 3 - 1, index / 9 - 1);
      const double length = roundPart(direction).norm();
      const bool at_height = round_ == 2 && direction.z() != 0.0;
      if (length == 0.0 || (round_ == 2 && !is_flat_ && !at_height) || (is_flat_ && at_height))
        continue;
      // a little less than the radius, to be in K exactly
      GrowingVector point{ (1.0 - 0x1p-50) * radius_.fixed / length * roundPart(direction),
                           (1.0 - 0x1p-50) * radius_.per_size / length * roundPart(direction) };
      if (round_ == 2)
        setHeight(direction.z() < 0.0 ? heights_.lower : heights_.upper, 1.0, point);
      points.push_back(point);
    }
    return points;
  }

  std::optional<GrowingVector> placeOf(const Eigen::Vector3d& offset, double size) const override
  {
    if (isScaling())
      return Shape::placeOf(offset, size);
    const double radius = radius_.at(size);
    const Eigen::Vector3d within = radius > 0.0 ? Eigen::Vector3d(roundPart(offset) / radius) : Eigen::Vector3d::Zero();
    // less than the radius by more than the roundings
    const Eigen::Vector3d share = (1.0 - 0x1p-46) / std::max(1.0, within.norm()) * within;
    GrowingVector place{ radius_.fixed * share, radius_.per_size * share };
    const Growing<double>& end = offset.z() < 0.0 ? heights_.lower : heights_.upper;
    const double reach = end.at(size);
    if (round_ == 2)
      setHeight(end, reach == 0.0 ? 0.0 : std::min(1.0, offset.z() / reach), place);
    return place;
  }

  /// The rims of both faces; of a disc, its own.
  std::vector<Circle> extremeCircles(const Eigen::Vector3d& center, double size) const override
  {
    if (round_ == 3)
      return {};
    const auto at = [&](const Growing<double>& above) {
      return Circle{ enclose(center) + IntervalVector{ 0.0, 0.0, encloseAt(above, size) }, radius(size) };
    };
    if (is_flat_)
      return { at(heights_.upper) };
    return { at(heights_.lower), at(heights_.upper) };
  }

  std::optional<Interval> ballRadius(double size) const override
  {
    return round_ == 3 ? std::optional<Interval>(radius(size)) : std::nullopt;
  }

  HalfSpace halfSpace(const Box& part, const Eigen::Vector3d& center, double size) const override
  {
    HalfSpace half;
    half.normal = roundPart(part.center() - center);
    const double length = half.normal.norm();
    if (!(length > 0.0))
      return {};
    half.normal /= length;
    const IntervalVector n = enclose(half.normal);
    half.offset = (dot(n, enclose(center)) + radius(size) * norm(n)).upper();
    return half;
  }

  bool misses(const Box& box, const Eigen::Vector3d& center, double size) const override
  {
    const Box bounds = boundingBox(center, size);
    if ((box.lower.array() > bounds.upper.array()).any() || (box.upper.array() < bounds.lower.array()).any())
      return true;
    Interval least(0.0);
    for (int axis = 0; axis < round_; ++axis)
      least += sqr(Interval((box.side(axis) - Interval(center[axis])).mignitude()));
    return least.lower() > sqr(radius(size)).upper();
  }

  bool contains(const Eigen::Vector3d& point, const Box& centers, double size) const override
  {
    return isBetween(point, centers, size) && squaredDistance(point, centers).upper() <= sqr(radius(size)).lower();
  }

  /// The squared distance from a center, less that of the radius, encloses a convex function of the center.
  std::optional<AffineForm<double>> avoidance(const Eigen::Vector3d& point, const Box& centers,
                                              double size) const override
  {
    const double unit = radius_.at(size);
    if (!isBetween(point, centers, size) || !(unit > 0.0))
      return std::nullopt;
    const CenteredBox<double> box(centers);
    AffineForm<double> beyond;
    for (int axis = 0; axis < round_; ++axis)
    {
      const AffineForm<double> offset =
          coordinate(box, static_cast<std::size_t>(axis)) + Enclosed<double>(Interval(-point[axis]));
      beyond = beyond + offset * offset;
    }
    beyond = beyond + Enclosed<double>(-sqr(radius(size)));
    return Enclosed<double>(Interval(1.0 / unit)) * beyond;  // a length, as the others are
  }

  Eigen::Vector3d exit(const Eigen::Vector3d& point, const Eigen::Vector3d& center, double size) const override
  {
    const Eigen::Vector3d offset = point - center;
    const Eigen::Vector3d round = roundPart(offset);
    const double length = round.norm();
    const double above = heights_.upper.at(size) - offset.z();
    const double below = offset.z() - heights_.lower.at(size);
    if (round_ == 2 && !is_flat_ && std::min(above, below) < radius_.at(size) - length)
      return (above <= below ? 1.0 : -1.0) * Eigen::Vector3d::UnitZ();
    return length > 0.0 ? Eigen::Vector3d(round / length) : Eigen::Vector3d(Eigen::Vector3d::UnitX());
  }

  Growing<Interval> support(const IntervalVector& n) const override
  {
    const Interval round = norm(round_ == 3 ? n : IntervalVector{ n[0], n[1], Interval(0.0) });
    const Growing<double>& low = heights_.lower;
    const Growing<double>& high = heights_.upper;
    return { Interval(radius_.fixed) * round + largestAlong(n[2], low.fixed, high.fixed),
             Interval(radius_.per_size) * round + largestAlong(n[2], low.per_size, high.per_size) };
  }

  Growing<double> support(const Eigen::Vector3d& n) const override
  {
    const double round = roundPart(n).norm();
    const auto largest = [&](double radius, double lower, double upper) {
      return radius * round + std::max(lower * n.z(), upper * n.z());
    };
    return { largest(radius_.fixed, heights_.lower.fixed, heights_.upper.fixed),
             largest(radius_.per_size, heights_.lower.per_size, heights_.upper.per_size) };
  }

  Eigen::Vector3d nearest(const Eigen::Vector3d& point, const Eigen::Vector3d& center, double size) const override
  {
    const Eigen::Vector3d offset = point - center;
    const Eigen::Vector3d round = roundPart(offset);
    const double length = round.norm();
    const double radius = radius_.at(size);
    Eigen::Vector3d result = length > radius ? Eigen::Vector3d(radius / length * round) : round;
    if (round_ == 2)
      result.z() = std::min(std::max(offset.z(), heights_.lower.at(size)), heights_.upper.at(size));
    return center + result;
  }

  std::vector<double> dimensions(double size) const override
  {
    if (round_ == 3)
      return { radius(size).lower() };
    return { height(size).lower(), radius(size).lower() };
  }

  Interval volume(double size) const override
  {
    const Interval section = pi() * sqr(radius(size));
    return round_ == 3 ? Interval(4.0) / Interval(3.0) * section * radius(size) : height(size) * section;
  }

  ShapePtr standing() const override
  {
    if (round_ == 3)
      return nullptr;
    const Heights above{
      { 0.0, 0.0 }, { heights_.upper.fixed - heights_.lower.fixed, heights_.upper.per_size - heights_.lower.per_size }
    };
    return std::make_shared<RoundShape>(name_, size_meaning_, round_, radius_, above);
  }

private:
  Interval radius(double size) const { return encloseAt(radius_, size); }
  Interval height(double size) const
  {
    return encloseAt(Growing<double>{ heights_.upper.fixed - heights_.lower.fixed,
                                      heights_.upper.per_size - heights_.lower.per_size },
                     size);
  }
  GrowingVector corner(double side, const Growing<double>& height) const
  {
    const auto at = [&](double radius, double z) {
      return Eigen::Vector3d(side * radius, side * radius, round_ == 3 ? side * radius : z);
    };
    return { at(radius_.fixed, height.fixed), at(radius_.per_size, height.per_size) };
  }
  static void setHeight(const Growing<double>& height, double share, GrowingVector& place)
  {
    place.fixed.z() = share * height.fixed;
    place.per_size.z() = share * height.per_size;
  }
  Eigen::Vector3d roundPart(Eigen::Vector3d v) const
  {
    if (round_ == 2)
      v.z() = 0.0;
    return v;
  }

  bool isBetween(const Eigen::Vector3d& point, const Box& centers, double size) const
  {
    if (round_ == 3)
      return true;
    const Interval height = Interval(point.z()) - centers.side(2);
    return height.upper() <= encloseAt(heights_.upper, size).lower() &&
           height.lower() >= encloseAt(heights_.lower, size).upper();
  }

  Interval squaredDistance(const Eigen::Vector3d& point, const Box& centers) const
  {
    Interval sum(0.0);
    for (int axis = 0; axis < round_; ++axis)
      sum += sqr(Interval(point[axis]) - centers.side(axis));
    return sum;
  }

  std::string name_;
  std::string size_meaning_;
  int round_;
  Growing<double> radius_;
  Heights heights_;
  bool is_flat_;
};
}  // namespace pkm_workspace
