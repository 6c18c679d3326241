// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <limits>
#include <stdexcept>

#include "pkm_workspace/interval/text_stream.h"
#include "pkm_workspace/region/shape.h"

namespace pkm_workspace
{
namespace
{
using Eigen::Vector3d;

/// K = { x : the first `round` coordinates lie within the radius, the others within half the height }: a sphere (3), a
/// cylinder along z or a disc (2).
class RoundShape : public Shape
{
public:
  RoundShape(std::string name, std::string size_meaning, int round, double radius, double half_height)
    : name_(std::move(name))
    , size_meaning_(std::move(size_meaning))
    , round_(round)
    , radius_(radius)
    , half_height_(half_height)
  {}

  std::string name() const override { return name_; }
  std::string sizeMeaning() const override { return size_meaning_; }
  Vector3d halfExtents() const override { return { radius_, radius_, round_ == 3 ? radius_ : half_height_ }; }
  bool isPrism() const override { return round_ == 2; }

  /// Directions to the faces, edges and corners of a cube.
  std::vector<Vector3d> extremePoints() const override
  {
    std::vector<Vector3d> points;
    for (int index = 0; index < 27; ++index)
    {
      Vector3d direction(index % 3 - 1, index / 3 % 3 - 1, index / 9 - 1);
      const double length = roundPart(direction).norm();
      const bool at_height = round_ == 2 && direction.z() != 0.0;
      if (length == 0.0 || (round_ == 2 && half_height_ > 0.0 && !at_height) || (half_height_ == 0.0 && at_height))
        continue;
      // a little less than the radius, to be in K exactly
      Vector3d point = (1.0 - 0x1p-50) * radius_ / length * roundPart(direction);
      if (round_ == 2)
        point.z() = half_height_ * direction.z();
      points.push_back(point);
    }
    return points;
  }

  /// The rims of both faces; of a disc, its own.
  std::vector<Circle> extremeCircles(const Vector3d& center, double size) const override
  {
    if (round_ == 3)
      return {};
    const auto at = [&](const Interval& above) {
      return Circle{ enclose(center) + IntervalVector{ 0.0, 0.0, above }, radius(size) };
    };
    if (half_height_ == 0.0)
      return { at(0.0) };
    return { at(-halfHeight(size)), at(halfHeight(size)) };
  }

  std::optional<Interval> ballRadius(double size) const override
  {
    return round_ == 3 ? std::optional<Interval>(radius(size)) : std::nullopt;
  }

  HalfSpace halfSpace(const Box& part, const Vector3d& center, double size) const override
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

  bool misses(const Box& box, const Vector3d& center, double size) const override
  {
    const Box bounds = boundingBox(center, size);
    if ((box.lower.array() > bounds.upper.array()).any() || (box.upper.array() < bounds.lower.array()).any())
      return true;
    Interval least(0.0);
    for (int axis = 0; axis < round_; ++axis)
      least += sqr(Interval((box.side(axis) - Interval(center[axis])).mignitude()));
    return least.lower() > sqr(radius(size)).upper();
  }

  bool contains(const Vector3d& point, const Box& centers, double size) const override
  {
    const bool between = round_ == 3 || height(point, centers).magnitude() <= halfHeight(size).lower();
    return between && squaredDistance(point, centers).upper() <= sqr(radius(size)).lower();
  }

  /// The squared distance from a center, less that of the radius, encloses a convex function of the center.
  std::optional<AffineForm<double>> avoidance(const Vector3d& point, const Box& centers, double size) const override
  {
    const bool may_be_beyond = round_ == 2 && !(height(point, centers).magnitude() <= halfHeight(size).lower());
    if (may_be_beyond)
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
    return Enclosed<double>(Interval(1.0 / (size * radius_))) * beyond;  // a length, as the others are
  }

  Vector3d exit(const Vector3d& point, const Vector3d& center, double size) const override
  {
    const Vector3d offset = point - center;
    const Vector3d round = roundPart(offset);
    const double length = round.norm();
    const double depth =
        half_height_ == 0.0 ? std::numeric_limits<double>::infinity() : size * half_height_ - std::abs(offset.z());
    if (round_ == 2 && depth < size * radius_ - length)
      return std::copysign(1.0, offset.z()) * Vector3d::UnitZ();
    return length > 0.0 ? Vector3d(round / length) : Vector3d(Vector3d::UnitX());
  }

  Interval support(const IntervalVector& n) const override
  {
    const IntervalVector round = round_ == 3 ? n : IntervalVector{ n[0], n[1], Interval(0.0) };
    return Interval(radius_) * norm(round) + Interval(half_height_) * abs(n[2]);
  }

  double support(const Vector3d& n) const override
  {
    return radius_ * roundPart(n).norm() + half_height_ * (n - roundPart(n)).norm();
  }

  Vector3d nearest(const Vector3d& point, const Vector3d& center, double size) const override
  {
    const Vector3d offset = point - center;
    const Vector3d round = roundPart(offset);
    const double length = round.norm();
    Vector3d result = length > size * radius_ ? Vector3d(size * radius_ / length * round) : round;
    if (round_ == 2)
      result.z() = std::min(std::max(offset.z(), -size * half_height_), size * half_height_);
    return center + result;
  }

  std::vector<double> dimensions(double size) const override
  {
    if (round_ == 3)
      return { radius(size).lower() };
    return { (Interval(2.0) * halfHeight(size)).lower(), radius(size).lower() };
  }

  Interval volume(double size) const override
  {
    const Interval section = pi() * sqr(radius(size));
    return round_ == 3 ? Interval(4.0) / Interval(3.0) * section * radius(size)
                       : Interval(2.0) * halfHeight(size) * section;
  }

private:
  Interval radius(double size) const { return Interval(size) * Interval(radius_); }
  Interval halfHeight(double size) const { return Interval(size) * Interval(half_height_); }
  Vector3d roundPart(Vector3d v) const
  {
    if (round_ == 2)
      v.z() = 0.0;
    return v;
  }

  static Interval height(const Vector3d& point, const Box& centers) { return Interval(point.z()) - centers.side(2); }

  Interval squaredDistance(const Vector3d& point, const Box& centers) const
  {
    Interval sum(0.0);
    for (int axis = 0; axis < round_; ++axis)
      sum += sqr(Interval(point[axis]) - centers.side(axis));
    return sum;
  }

  std::string name_;
  std::string size_meaning_;
  int round_;
  double radius_;
  double half_height_;
};
}  // namespace

ShapePtr makeSphere()
{
  return std::make_shared<RoundShape>("sphere", "radius [m]", 3, 1.0, 0.0);
}

ShapePtr makeDisc()
{
  return std::make_shared<RoundShape>("disc", "radius [m]", 2, 1.0, 0.0);
}

ShapePtr makeCylinder(double ratio)
{
  if (!(ratio >= 1e-6 && ratio <= 1e6))
  {
    TextStream text;
    text << "ratio = " << ratio << " (radius over height of a cylinder) must be from 1e-6 to 1e6";
    throw std::invalid_argument(text.str());
  }
  return std::make_shared<RoundShape>("cylinder", "height [m]", 2, ratio, 0.5);
}

ShapePtr makeCylinder(double radius, double height)
{
  const auto isOrdinary = [](double length) { return length >= 1e-100 && length <= 1e100; };
  if (!isOrdinary(radius) || !isOrdinary(height))
  {
    TextStream text;
    text << "cylinder of radius " << radius << " m and height " << height
         << " m: both must be positive and finite (1e-100 to 1e100)";
    throw std::invalid_argument(text.str());
  }
  return std::make_shared<RoundShape>("cylinder", "factor on radius and height", 2, radius, 0.5 * height);
}
}  // namespace pkm_workspace
