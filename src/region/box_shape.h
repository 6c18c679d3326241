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
/// K(h) = { x : lower_j <= x_j <= upper_j }: cubes, squares and boxes, about their center or elsewhere.
class BoxShape : public Shape
{
public:
  /// @pre upper - lower rounds nothing
  BoxShape(std::string name, std::string size_meaning, const GrowingVector& lower, const GrowingVector& upper)
    : name_(std::move(name))
    , size_meaning_(std::move(size_meaning))
    , lower_(lower)
    , upper_(upper)
    , sides_(upper - lower)
    , has_thickness_(sides_.fixed.array() > 0.0 || sides_.per_size.array() > 0.0)
  {}
  BoxShape(std::string name, std::string size_meaning, const Eigen::Vector3d& proportions)
    : BoxShape(std::move(name), std::move(size_meaning), scaling(-0.5 * proportions), scaling(0.5 * proportions))
  {}

  std::string name() const override { return name_; }
  std::string sizeMeaning() const override { return size_meaning_; }
  GrowingVector lower() const override { return lower_; }
  GrowingVector upper() const override { return upper_; }

  std::vector<GrowingVector> extremePoints() const override
  {
    std::vector<GrowingVector> corners = { scaling(Eigen::Vector3d::Zero()) };
    for (int axis = 0; axis < 3; ++axis)
    {
      if (!has_thickness_[axis])
        continue;
      std::vector<GrowingVector> both;
      for (const GrowingVector& end : { lower_, upper_ })
        for (GrowingVector corner : corners)
        {
          corner.fixed[axis] = end.fixed[axis];
          corner.per_size[axis] = end.per_size[axis];
          both.push_back(corner);
        }
      corners = both;
    }
    return corners;
  }

  /// Shares of lower_ or upper_, whichever lies on the offset's side.
  std::optional<GrowingVector> placeOf(const Eigen::Vector3d& offset, double size) const override
  {
    if (isScaling())
      return Shape::placeOf(offset, size);
    GrowingVector place = scaling(Eigen::Vector3d::Zero());
    for (int axis = 0; axis < 3; ++axis)
    {
      const GrowingVector& end = offset[axis] < 0.0 ? lower_ : upper_;
      const double reach = end.at(size)[axis];
      const double share = reach == 0.0 ? 0.0 : std::min(1.0, offset[axis] / reach);
      place.fixed[axis] = share * end.fixed[axis];
      place.per_size[axis] = share * end.per_size[axis];
    }
    return place;
  }

  bool isBox() const override { return true; }
  HalfSpace halfSpace(const Box&, const Eigen::Vector3d&, double) const override { return {}; }

  bool misses(const Box& box, const Eigen::Vector3d& center, double size) const override
  {
    const Eigen::Vector3d margin = 0.0005 * sides_.at(size);  // nearly all parts reach into what this leaves
    if ((box.lower.array() < (center + upper_.at(size) - margin).array()).all() &&
        (box.upper.array() > (center + lower_.at(size) + margin).array()).all())
      return false;
    const Box bounds = boundingBox(center, size);
    return (box.lower.array() > bounds.upper.array()).any() || (box.upper.array() < bounds.lower.array()).any();
  }

  bool contains(const Eigen::Vector3d& point, const Box& centers, double size) const override
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      const Interval offset = Interval(point[axis]) - centers.side(axis);
      if (!(offset.upper() <= along(upper_, axis, size).lower() && offset.lower() >= along(lower_, axis, size).upper()))
        return false;
    }
    return true;
  }

  /// A box avoids a point on one side at least; if only one side is left over the centers, the distance to it is
  /// affine.
  std::optional<AffineForm<double>> avoidance(const Eigen::Vector3d& point, const Box& centers,
                                              double size) const override
  {
    if (sidesLeft(point, centers, size) > 1)
      return std::nullopt;
    AffineForm<double> beyond;  // how far the point is beyond the one side that is left
    beyond.center = -1.0;
    int sides_left = 0;
    for (int axis = 0; axis < 3; ++axis)
      for (const double direction : { 1.0, -1.0 })
      {
        const Interval distance = Interval(direction) * (Interval(point[axis]) - centers.side(axis));
        const Interval reach = direction > 0.0 ? along(upper_, axis, size) : -along(lower_, axis, size);
        if (distance.upper() <= reach.lower())
          continue;
        beyond = Enclosed<double>(Interval(-direction)) *
                     coordinate(CenteredBox<double>(centers), static_cast<std::size_t>(axis)) +
                 Enclosed<double>(Interval(direction * point[axis]) - reach);
        ++sides_left;
      }
    return sides_left <= 1 ? std::optional<AffineForm<double>>(beyond) : std::nullopt;
  }

  Eigen::Vector3d exit(const Eigen::Vector3d& point, const Eigen::Vector3d& center, double size) const override
  {
    const Eigen::Vector3d offset = point - center;
    const Eigen::Array3d above = (upper_.at(size) - offset).array();
    const Eigen::Array3d below = (offset - lower_.at(size)).array();
    int axis = 0;
    has_thickness_.select(above.min(below), std::numeric_limits<double>::infinity()).minCoeff(&axis);
    return (above[axis] <= below[axis] ? 1.0 : -1.0) * Eigen::Vector3d::Unit(axis);
  }

  Growing<Interval> support(const IntervalVector& n) const override
  {
    Growing<Interval> sum;
    for (std::size_t k = 0; k < 3; ++k)
    {
      const int axis = static_cast<int>(k);
      sum.fixed += largestAlong(n[k], lower_.fixed[axis], upper_.fixed[axis]);
      sum.per_size += largestAlong(n[k], lower_.per_size[axis], upper_.per_size[axis]);
    }
    return sum;
  }

  Growing<double> support(const Eigen::Vector3d& n) const override
  {
    const auto largest = [&n](const Eigen::Vector3d& lower, const Eigen::Vector3d& upper) {
      return n.cwiseProduct(lower).cwiseMax(n.cwiseProduct(upper)).sum();
    };
    return { largest(lower_.fixed, upper_.fixed), largest(lower_.per_size, upper_.per_size) };
  }

  Eigen::Vector3d nearest(const Eigen::Vector3d& point, const Eigen::Vector3d& center, double size) const override
  {
    return point.cwiseMax(center + lower_.at(size)).cwiseMin(center + upper_.at(size));
  }

  std::vector<double> dimensions(double size) const override
  {
    std::vector<double> result;
    for (int axis = 0; axis < 3; ++axis)
      result.push_back(along(sides_, axis, size).lower());
    return result;
  }

  Interval volume(double size) const override
  {
    return along(sides_, 0, size) * along(sides_, 1, size) * along(sides_, 2, size);
  }

  ShapePtr standing() const override
  {
    GrowingVector lower = lower_;
    GrowingVector upper = upper_;
    lower.fixed.z() = lower.per_size.z() = 0.0;
    upper.fixed.z() = sides_.fixed.z();
    upper.per_size.z() = sides_.per_size.z();
    return std::make_shared<BoxShape>(name_, size_meaning_, lower, upper);
  }

private:
  /// How many sides of a region a point may be beyond, in floating point and not counting those in doubt.
  int sidesLeft(const Eigen::Vector3d& point, const Box& centers, double size) const
  {
    const double more = 1.0 + 1e-9;
    const auto above = more * upper_.fixed + more * size * upper_.per_size;
    const auto below = more * lower_.fixed + more * size * lower_.per_size;
    return static_cast<int>(((point - centers.lower).array() > above.array()).count() +
                            ((point - centers.upper).array() < below.array()).count());
  }

  static Interval along(const GrowingVector& v, int axis, double size)
  {
    return encloseAt(Growing<double>{ v.fixed[axis], v.per_size[axis] }, size);
  }

  std::string name_;
  std::string size_meaning_;
  GrowingVector lower_;
  GrowingVector upper_;
  GrowingVector sides_;  ///< what it measures along the axes
  Eigen::Array<bool, 3, 1> has_thickness_;
};
}  // namespace pkm_workspace
