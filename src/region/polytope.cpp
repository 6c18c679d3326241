// SPDX-License-Identifier: BSD-3-Clause
#include "polytope.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <map>
#include <set>
#include <stdexcept>

#include "pkm_workspace/interval/text_stream.h"
#include "pkm_workspace/region/polytope.h"

namespace pkm_workspace
{
namespace
{
using Eigen::Vector3d;
using Points = std::vector<Vector3d>;

/// Lengths that products of three keep ordinary numbers [m].
constexpr double LEAST_EXTENT = 1e-9;
constexpr double LARGEST = 1e9;

template <class... Words>
[[noreturn]] void refuseVertices(const Words&... words)
{
  TextStream text;
  text << "vertices ";
  (text << ... << words);
  throw std::invalid_argument(text.str());
}

}  // namespace

Polytope::Polytope(const Points& points)
{
  if (points.size() > MOST_VERTICES)
    refuseVertices("are ", points.size(), "; allowed: 4 to ", MOST_VERTICES);
  for (const Vector3d& point : points)
    if (!(point.allFinite() && point.cwiseAbs().maxCoeff() <= LARGEST))
      refuseVertices("have (", point.x(), ", ", point.y(), ", ", point.z(), ") m; they must be finite, within 1e9 m");
  try
  {
    triangles_ = convexHull(points);
  }
  catch (const std::invalid_argument& reason)
  {
    refuseVertices(reason.what());
  }
  keepCorners(points);
  makeFacets();
  checkSurface();
  measure();
}

/// Those of the surface come first; of the others those that nothing proves to lie within it.
void Polytope::keepCorners(const Points& points)
{
  std::map<std::size_t, std::size_t> places;
  for (HullTriangle& triangle : triangles_)
    for (std::size_t& corner : triangle)
    {
      const auto place = places.emplace(corner, vertices_.size()).first;
      if (place->second == vertices_.size())
        vertices_.push_back(points[corner]);
      corner = place->second;
    }
  makeFacets();
  const std::size_t of_surface = vertices_.size();
  for (std::size_t k = 0; k < points.size() && vertices_.size() <= MOST_CORNERS; ++k)
    if (places.count(k) == 0 && std::find(vertices_.begin(), vertices_.end(), points[k]) == vertices_.end() &&
        !contains(points[k], { Vector3d::Zero(), Vector3d::Zero() }, 1.0))
      vertices_.push_back(points[k]);
  if (vertices_.size() > MOST_CORNERS)
    refuseVertices("have a hull of more than ", MOST_CORNERS, " corners (", of_surface,
                   " and what lies on its faces but for rounding): leave out some of them, or give a coarser mesh");
}

void Polytope::makeFacets()
{
  facets_.clear();
  for (const auto& [a, b, c] : triangles_)
  {
    const IntervalVector first = enclose(vertices_[b]) - enclose(vertices_[a]);
    const IntervalVector second = enclose(vertices_[c]) - enclose(vertices_[a]);
    const IntervalVector normal = cross(first, second);
    PolytopeFacet facet;
    facet.exact = Interval(1.0 / mid(normal).norm()) * normal;
    facet.normal = mid(facet.exact);
    facet.level =
        intersection(intersection(dot(facet.exact, enclose(vertices_[a])), dot(facet.exact, enclose(vertices_[b]))),
                     dot(facet.exact, enclose(vertices_[c])));
    facet.most = support(enclose(facet.normal)).per_size;
    facets_.push_back(facet);
  }
}

/// Whether it is closed, an inner point sees all of it from inside, and the center is within it.
void Polytope::checkSurface() const
{
  const Vector3d middle = Vector3d::Zero();
  std::set<std::pair<std::size_t, std::size_t>> edges;
  bool is_good = true;
  for (const auto& triangle : triangles_)
    for (std::size_t i = 0; i < 3; ++i)
      is_good = edges.insert({ triangle[i], triangle[(i + 1) % 3] }).second && is_good;
  for (const auto& [from, to] : edges)
    is_good = is_good && edges.count({ to, from }) == 1;
  Vector3d inner = Vector3d::Zero();
  for (const Vector3d& vertex : vertices_)
    inner += vertex / static_cast<double>(vertices_.size());
  for (const PolytopeFacet& facet : facets_)
    is_good = is_good && beyond(facet, enclose(inner), 1.0).upper() < 0.0;
  if (!is_good)
    refuseVertices("lie so close that doubles cannot tell what their hull is: leave out some of them");
  for (const PolytopeFacet& facet : facets_)
    if (!(beyond(facet, enclose(middle), 1.0).upper() <= 0.0))
      refuseVertices(
          "lie around another point than (0, 0, 0) m, which has to be one of their hull, as it is the center "
          "of regions; give them as seen from a point of it, such as (",
          inner.x(), ", ", inner.y(), ", ", inner.z(), ") m");
}

/// The hull lies within the surface made larger about the inner point, by as much as a vertex sticks out of it.
void Polytope::measure()
{
  inner_ = lower_ = upper_ = vertices_.front();
  Vector3d sum = Vector3d::Zero();
  for (const Vector3d& vertex : vertices_)
  {
    sum += vertex;
    lower_ = lower_.cwiseMin(vertex);
    upper_ = upper_.cwiseMax(vertex);
  }
  inner_ = sum / static_cast<double>(vertices_.size());
  const double extent = (upper_ - lower_).maxCoeff();
  if (!(extent >= LEAST_EXTENT))
    refuseVertices("measure ", extent, " m; allowed: from 1e-9 m");
  Interval six_fold(0.0);
  for (const auto& [a, b, c] : triangles_)
    six_fold += determinant(enclose(vertices_[a]), enclose(vertices_[b]), enclose(vertices_[c]));
  double more = 1.0;
  for (const PolytopeFacet& facet : facets_)
  {
    const Interval at_inner = dot(facet.exact, enclose(inner_));
    for (const Vector3d& vertex : vertices_)
      more = std::max(more, ((dot(facet.exact, enclose(vertex)) - at_inner) / (facet.level - at_inner)).upper());
  }
  volume_ = six_fold / Interval(6.0) * Interval(1.0, (Interval(more) * sqr(Interval(more))).upper());
}

ShapePtr makePolytope(const Points& vertices)
{
  return std::make_shared<Polytope>(vertices);
}
}  // namespace pkm_workspace
