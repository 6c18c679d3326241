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
/// K = { x : |x_j| <= proportion_j / 2 }: cubes, squares and boxes.
class BoxShape : public Shape
{
public:
  BoxShape(std::string name, std::string size_meaning, const Eigen::Vector3d& proportions)
    : name_(std::move(name)), size_meaning_(std::move(size_meaning)), proportions_(proportions)
  {}

  std::string name() const override { return name_; }
  std::string sizeMeaning() const override { return size_meaning_; }
  Eigen::Vector3d halfExtents() const override { return 0.5 * proportions_; }

  std::vector<Eigen::Vector3d> extremePoints() const override
  {
    std::vector<Eigen::Vector3d> corners = { Eigen::Vector3d::Zero() };
    for (int axis = 0; axis < 3; ++axis)
    {
      if (proportions_[axis] == 0.0)
        continue;
      std::vector<Eigen::Vector3d> both;
      for (const double half : { -0.5 * proportions_[axis], 0.5 * proportions_[axis] })
        for (Eigen::Vector3d corner : corners)
        {
          corner[axis] = half;
          both.push_back(corner);
        }
      corners = both;
    }
    return corners;
  }

  bool isBox() const override { return true; }
  HalfSpace halfSpace(const Box&, const Eigen::Vector3d&, double) const override { return {}; }

  bool misses(const Box& box, const Eigen::Vector3d& center, double size) const override
  {
    const Eigen::Array3d core = 0.999 * size * halfExtents().array();  // nearly all parts reach into this
    if ((box.lower.array() < center.array() + core).all() && (box.upper.array() > center.array() - core).all())
      return false;
    const Box bounds = boundingBox(center, size);
    return (box.lower.array() > bounds.upper.array()).any() || (box.upper.array() < bounds.lower.array()).any();
  }

  bool contains(const Eigen::Vector3d& point, const Box& centers, double size) const override
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      const Interval distance = Interval(point[axis]) - centers.side(axis);
      if (!(distance.magnitude() <= half(size, axis).lower()))
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
        if (distance.upper() <= half(size, axis).lower())
          continue;
        beyond = Enclosed<double>(Interval(-direction)) *
                     coordinate(CenteredBox<double>(centers), static_cast<std::size_t>(axis)) +
                 Enclosed<double>(Interval(direction * point[axis]) - half(size, axis));
        ++sides_left;
      }
    return sides_left <= 1 ? std::optional<AffineForm<double>>(beyond) : std::nullopt;
  }

  Eigen::Vector3d exit(const Eigen::Vector3d& point, const Eigen::Vector3d& center, double size) const override
  {
    const Eigen::Vector3d offset = point - center;
    Eigen::Array3d depth = size * halfExtents().array() - offset.array().abs();
    depth = (proportions_.array() > 0.0).select(depth, std::numeric_limits<double>::infinity());
    int axis = 0;
    depth.minCoeff(&axis);
    return std::copysign(1.0, offset[axis]) * Eigen::Vector3d::Unit(axis);
  }

  Interval support(const IntervalVector& n) const override
  {
    Interval sum(0.0);
    for (std::size_t k = 0; k < 3; ++k)
      sum += abs(n[k]) * Interval(0.5 * proportions_[static_cast<int>(k)]);
    return sum;
  }

  double support(const Eigen::Vector3d& n) const override { return n.cwiseAbs().dot(halfExtents()); }

  Eigen::Vector3d nearest(const Eigen::Vector3d& point, const Eigen::Vector3d& center, double size) const override
  {
    const Eigen::Vector3d reach = size * halfExtents();
    return point.cwiseMax(center - reach).cwiseMin(center + reach);
  }

  std::vector<double> dimensions(double size) const override
  {
    std::vector<double> result;
    for (int axis = 0; axis < 3; ++axis)
      result.push_back((Interval(size) * Interval(proportions_[axis])).lower());
    return result;
  }

  Interval volume(double size) const override
  {
    Interval product(1.0);
    for (int axis = 0; axis < 3; ++axis)
      product *= Interval(size) * Interval(proportions_[axis]);
    return product;
  }

private:
  /// How many sides of a region a point may be beyond, in floating point and not counting those in doubt.
  int sidesLeft(const Eigen::Vector3d& point, const Box& centers, double size) const
  {
    const Eigen::Array3d reach = (1.0 + 1e-9) * size * halfExtents().array();
    return static_cast<int>(((point - centers.lower).array() > reach).count() +
                            ((centers.upper - point).array() > reach).count());
  }

  Interval half(double size, int axis) const { return Interval(size) * Interval(0.5 * proportions_[axis]); }

  std::string name_;
  std::string size_meaning_;
  Eigen::Vector3d proportions_;
};
}  // namespace

ShapePtr makeCube()
{
  return std::make_shared<BoxShape>("cube", "edge [m]", Eigen::Vector3d::Ones());
}

ShapePtr makeSquare()
{
  return std::make_shared<BoxShape>("square", "edge [m]", Eigen::Vector3d(1.0, 1.0, 0.0));
}

ShapePtr makeBox(const Eigen::Vector3d& proportions)
{
  const bool finite = proportions.allFinite() && (proportions.array() >= 0.0).all();
  // halves and products with sizes have to stay ordinary numbers
  const bool ordinary = finite && proportions.maxCoeff() >= 1e-100 && proportions.maxCoeff() <= 1e100 &&
                        (proportions.array() == 0.0 || proportions.array() >= 1e-100).all();
  if (!ordinary)
  {
    TextStream text;
    text << "proportions (" << proportions[0] << ", " << proportions[1] << ", " << proportions[2]
         << ") [m per unit of size] must be finite, 0 or positive "
         << "(1e-100 to 1e100), and at least one of them positive";
    throw std::invalid_argument(text.str());
  }
  return std::make_shared<BoxShape>("box", "factor on the proportions", proportions);
}
}  // namespace pkm_workspace
