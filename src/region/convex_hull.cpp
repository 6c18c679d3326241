// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/region/convex_hull.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>

namespace pkm_workspace
{
namespace
{
using Eigen::Vector3d;
using Points = std::vector<Vector3d>;

/// Points that stick out by less are left where they are, as a share of what all measure.
constexpr double NEAR = 1e-10;
/// The least thickness of what is no plane, as that share.
constexpr double FLAT = 1e-6;

/// Of the surface, while it grows: a body of some hundred corners has twice as many triangles.
constexpr std::size_t MOST_FACETS = 1024;

/// Triangles around points that are added one by one.
class Hull
{
public:
  explicit Hull(const Points& points) : points_(points)
  {
    Vector3d lower = points[0];
    Vector3d upper = points[0];
    for (const Vector3d& point : points)
    {
      lower = lower.cwiseMin(point);
      upper = upper.cwiseMax(point);
    }
    extent_ = (upper - lower).maxCoeff();
    begin();
  }

  std::vector<HullTriangle> run()
  {
    for (std::size_t k = 0; k < points_.size(); ++k)
    {
      add(k);
      if (facets_.size() > MOST_FACETS)
        throw std::invalid_argument("have a hull of more than " + std::to_string(MOST_FACETS / 4) +
                                    " corners: give those of a coarser mesh around it");
    }
    std::vector<HullTriangle> corners;
    for (const Facet& facet : facets_)
      corners.push_back(facet.corners);
    return corners;
  }

private:
  struct Facet
  {
    HullTriangle corners;
    Vector3d normal;  ///< outward, of length 1
  };

  double above(const Facet& facet, const Vector3d& point) const
  {
    return facet.normal.dot(point - points_[facet.corners[0]]);
  }

  Facet facetOf(std::size_t a, std::size_t b, std::size_t c) const
  {
    const Vector3d normal = (points_[b] - points_[a]).cross(points_[c] - points_[a]);
    return { { a, b, c }, normal.normalized() };
  }

  template <class Value>
  std::size_t farthest(const Value& value) const
  {
    std::size_t best = 0;
    for (std::size_t k = 1; k < points_.size(); ++k)
      if (value(points_[k]) > value(points_[best]))
        best = k;
    return best;
  }

  /// A tetrahedron of points that are far from each other.
  void begin()
  {
    const std::size_t a = farthest([](const Vector3d& p) { return -p.x() - 0.9 * p.y() - 0.8 * p.z(); });
    const std::size_t b = farthest([&](const Vector3d& p) { return (p - points_[a]).squaredNorm(); });
    const Vector3d line = (points_[b] - points_[a]).normalized();
    const std::size_t c = farthest([&](const Vector3d& p) { return line.cross(p - points_[a]).squaredNorm(); });
    const Vector3d normal = line.cross(points_[c] - points_[a]).normalized();
    const std::size_t d = farthest([&](const Vector3d& p) { return std::abs(normal.dot(p - points_[a])); });
    const double thickness = std::abs(normal.dot(points_[d] - points_[a]));
    if (!(extent_ > 0.0 && thickness > FLAT * extent_))
      throw std::invalid_argument(
          "lie in one plane, or nearly: a polytope has to be thicker than a millionth of its "
          "width");
    const bool is_above = normal.dot(points_[d] - points_[a]) > 0.0;
    const std::size_t first = is_above ? c : b;
    const std::size_t second = is_above ? b : c;
    facets_ = { facetOf(a, first, second), facetOf(a, second, d), facetOf(second, first, d), facetOf(first, a, d) };
  }

  /// Takes away what the point sees, and joins it to the border of that.
  void add(std::size_t k)
  {
    const auto is_seen = [&](const Facet& facet) { return above(facet, points_[k]) > NEAR * extent_; };
    const auto seen = std::partition(facets_.begin(), facets_.end(), [&](const Facet& f) { return !is_seen(f); });
    if (seen == facets_.end())
      return;
    std::set<std::pair<std::size_t, std::size_t>> edges;
    for (auto facet = seen; facet != facets_.end(); ++facet)
      for (std::size_t i = 0; i < 3; ++i)
        edges.insert({ facet->corners[i], facet->corners[(i + 1) % 3] });
    facets_.erase(seen, facets_.end());
    for (const auto& [from, to] : edges)
      if (edges.count({ to, from }) == 0)
        facets_.push_back(facetOf(from, to, k));
  }

  const Points& points_;
  double extent_ = 0.0;
  std::vector<Facet> facets_;
};
}  // namespace

std::vector<HullTriangle> convexHull(const Points& points)
{
  if (points.size() < 4)
    throw std::invalid_argument("are " + std::to_string(points.size()) + ": a polytope has at least 4");
  if (!std::all_of(points.begin(), points.end(), [](const Vector3d& point) { return point.allFinite(); }))
    throw std::invalid_argument("have to be finite");
  return Hull(points).run();
}
}  // namespace pkm_workspace
