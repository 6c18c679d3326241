// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "pkm_workspace/region/convex_hull.h"
#include "pkm_workspace/region/shape.h"

namespace pkm_workspace
{
/// A plane of the hull's surface, of K: its points x satisfy normal . x <= most.
struct PolytopeFacet
{
  Eigen::Vector3d normal;  ///< outward, of a length near 1; near the exact one
  Interval most;           ///< encloses the largest normal . k over K
  IntervalVector exact;    ///< encloses the normal of the plane through its corners, of a length near 1
  Interval level;          ///< encloses exact . x of the corners
};

/// K = the convex hull of some points. Proofs rest on two facts. No point of K lies beyond `most` of any facet,
/// whatever its normal. And where the triangles are a closed surface that an inner point sees all of from inside, which
/// is proved once, a point within the exact planes of all of them is in K: on the way from the inner point to a point
/// that is out of the surface, the plane of the triangle where the way leaves is crossed.
class Polytope : public Shape
{
public:
  /// @throws std::invalid_argument as makePolytope() does
  explicit Polytope(const std::vector<Eigen::Vector3d>& points);

  std::string name() const override;
  std::string sizeMeaning() const override { return "factor on the vertices"; }
  GrowingVector lower() const override { return scaling(lower_); }
  GrowingVector upper() const override { return scaling(upper_); }
  std::vector<GrowingVector> extremePoints() const override;
  HalfSpace halfSpace(const Box& part, const Eigen::Vector3d& center, double size) const override;
  bool misses(const Box& box, const Eigen::Vector3d& center, double size) const override;
  bool contains(const Eigen::Vector3d& point, const Box& centers, double size) const override;
  std::optional<AffineForm<double>> avoidance(const Eigen::Vector3d& point, const Box& centers,
                                              double size) const override;
  Growing<Interval> support(const IntervalVector& n) const override;
  Growing<double> support(const Eigen::Vector3d& n) const override;
  Eigen::Vector3d exit(const Eigen::Vector3d& point, const Eigen::Vector3d& center, double size) const override;
  Eigen::Vector3d nearest(const Eigen::Vector3d& point, const Eigen::Vector3d& center, double size) const override;
  std::vector<double> dimensions(double) const override { return {}; }
  Interval volume(double size) const override { return Interval(size) * sqr(Interval(size)) * volume_; }
  ShapePtr standing() const override;

private:
  void keepCorners(const std::vector<Eigen::Vector3d>& points);
  void makeFacets();
  void checkSurface() const;
  void measure();
  Interval beyond(const PolytopeFacet& facet, const IntervalVector& offset, double size) const;
  const PolytopeFacet& outermost(const Eigen::Vector3d& offset, double size) const;

  std::vector<Eigen::Vector3d> vertices_;  ///< those of the surface first
  std::vector<HullTriangle> triangles_;
  std::vector<PolytopeFacet> facets_;  ///< one for each triangle
  Eigen::Vector3d inner_;              ///< a point that sees all of the surface from inside
  Eigen::Vector3d lower_;
  Eigen::Vector3d upper_;
  Interval volume_;
};
}  // namespace pkm_workspace
