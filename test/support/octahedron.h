// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>

#include "pkm_workspace/region/shape.h"

namespace pkm_workspace
{
namespace test
{
/// K = { x : |x_1| + |x_2| + |x_3| <= 1/2 }: a polytope that is not its bounding box. Size: distance of opposite
/// vertices [m].
class Octahedron : public Shape
{
public:
  std::string name() const override { return "octahedron"; }
  std::string sizeMeaning() const override { return "distance of opposite vertices [m]"; }
  GrowingVector lower() const override { return scaling(Eigen::Vector3d::Constant(-0.5)); }
  GrowingVector upper() const override { return scaling(Eigen::Vector3d::Constant(0.5)); }

  std::vector<GrowingVector> extremePoints() const override
  {
    std::vector<GrowingVector> vertices;
    for (int axis = 0; axis < 3; ++axis)
      for (const double half : { -0.5, 0.5 })
        vertices.push_back(scaling(half * Eigen::Vector3d::Unit(axis)));
    return vertices;
  }

  /// That of the facet that the part is nearest to.
  HalfSpace halfSpace(const Box& part, const Eigen::Vector3d& center, double size) const override
  {
    HalfSpace half;
    half.normal = signsOf(part.center() - center);
    half.offset = (dot(enclose(half.normal), enclose(center)) + Interval(0.5) * Interval(size)).upper();
    return half;
  }

  bool misses(const Box& box, const Eigen::Vector3d& center, double size) const override
  {
    return reach(enclose(box), { center, center }).lower() > (Interval(0.5) * Interval(size)).upper();
  }

  bool contains(const Eigen::Vector3d& point, const Box& centers, double size) const override
  {
    return reach(enclose(point), centers).upper() <= (Interval(0.5) * Interval(size)).lower();
  }

  std::optional<AffineForm<double>> avoidance(const Eigen::Vector3d&, const Box&, double) const override
  {
    return std::nullopt;
  }

  Growing<Interval> support(const IntervalVector& n) const override
  {
    const Interval a[] = { abs(n[0]), abs(n[1]), abs(n[2]) };
    return { 0.0, Interval(0.5) * Interval(std::max({ a[0].lower(), a[1].lower(), a[2].lower() }),
                                           std::max({ a[0].upper(), a[1].upper(), a[2].upper() })) };
  }
  Growing<double> support(const Eigen::Vector3d& n) const override { return { 0.0, 0.5 * n.cwiseAbs().maxCoeff() }; }

  Eigen::Vector3d exit(const Eigen::Vector3d& point, const Eigen::Vector3d& center, double) const override
  {
    return signsOf(point - center).normalized();
  }

  /// Takes the same from each magnitude that is larger, so that their sum is right (Duchi et al. 2008).
  Eigen::Vector3d nearest(const Eigen::Vector3d& point, const Eigen::Vector3d& center, double size) const override
  {
    const Eigen::Vector3d offset = point - center;
    if (offset.lpNorm<1>() <= 0.5 * size)
      return point;
    Eigen::Vector3d sorted = offset.cwiseAbs();
    std::sort(sorted.data(), sorted.data() + 3, std::greater<double>());
    double sum = 0.0;
    double taken = 0.0;
    for (int k = 0; k < 3; ++k)
    {
      sum += sorted[k];
      if (sorted[k] > (sum - 0.5 * size) / (k + 1))
        taken = (sum - 0.5 * size) / (k + 1);
    }
    const Eigen::Vector3d left = (offset.cwiseAbs().array() - taken).cwiseMax(0.0);
    return center + left.cwiseProduct(signsOf(offset));
  }

  std::vector<double> dimensions(double size) const override { return { size }; }
  Interval volume(double size) const override { return sqr(Interval(size)) * Interval(size) / Interval(6.0); }

private:
  static Eigen::Vector3d signsOf(const Eigen::Vector3d& v)
  {
    return v.unaryExpr([](double x) { return std::copysign(1.0, x); });
  }

  /// Encloses |x_1| + |x_2| + |x_3| of the offsets of the points from the centers.
  static Interval reach(const IntervalVector& points, const Box& centers)
  {
    const IntervalVector offset = points - enclose(centers);
    return abs(offset[0]) + abs(offset[1]) + abs(offset[2]);
  }
};
}  // namespace test
}  // namespace pkm_workspace
