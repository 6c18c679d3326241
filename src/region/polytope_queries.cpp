// SPDX-License-Identifier: BSD-3-Clause
// What a polytope answers, from its facets.
#include <Eigen/Geometry>
#include <algorithm>
#include <iterator>
#include <stdexcept>

#include "polytope.h"

namespace pkm_workspace
{
namespace
{
using Eigen::Vector3d;

/// How much nearer than the surface the nearest point of a body is, so that it is proved to be in it.
constexpr double INWARD = 1e-13;

Interval largest(const Interval& a, const Interval& b)
{
  return { std::max(a.lower(), b.lower()), std::max(a.upper(), b.upper()) };
}

/// The point of a triangle that is nearest to a point, in floating point (Ericson, Real-Time Collision
/// Detection, 5.1.5).
Vector3d nearestOfTriangle(const Vector3d& p, const Vector3d& a, const Vector3d& b, const Vector3d& c)
{
  const Vector3d ab = b - a, ac = c - a, bc = c - b;
  const auto share = [](double way, double back) { return way + back > 0.0 ? way / (way + back) : 0.0; };
  const double along_ab = ab.dot(p - a), back_ab = -ab.dot(p - b);
  const double along_ac = ac.dot(p - a), back_ac = -ac.dot(p - c);
  const double along_bc = bc.dot(p - b), back_bc = -bc.dot(p - c);
  if (along_ab <= 0.0 && along_ac <= 0.0)
    return a;
  if (back_ab <= 0.0 && along_bc <= 0.0)
    return b;
  if (back_ac <= 0.0 && back_bc <= 0.0)
    return c;
  const Vector3d n = ab.cross(ac);
  const double beyond_c = n.dot((a - p).cross(b - p));
  const double beyond_a = n.dot((b - p).cross(c - p));
  const double beyond_b = n.dot((c - p).cross(a - p));
  if (beyond_c <= 0.0 && along_ab >= 0.0 && back_ab >= 0.0)
    return a + share(along_ab, back_ab) * ab;
  if (beyond_a <= 0.0 && along_bc >= 0.0 && back_bc >= 0.0)
    return b + share(along_bc, back_bc) * bc;
  if (beyond_b <= 0.0 && along_ac >= 0.0 && back_ac >= 0.0)
    return a + share(along_ac, back_ac) * ac;
  return (beyond_a * a + beyond_b * b + beyond_c * c) / (beyond_a + beyond_b + beyond_c);
}
}  // namespace

std::string Polytope::name() const
{
  return "polytope of " + std::to_string(vertices_.size()) + " corners";
}

std::vector<GrowingVector> Polytope::extremePoints() const
{
  std::vector<GrowingVector> points;
  std::transform(vertices_.begin(), vertices_.end(), std::back_inserter(points), scaling);
  return points;
}

const PolytopeFacet& Polytope::outermost(const Vector3d& offset, double size) const
{
  const auto out = [&](const PolytopeFacet& facet) { return facet.normal.dot(offset) - size * facet.most.mid(); };
  return *std::max_element(facets_.begin(), facets_.end(),
                           [&](const PolytopeFacet& a, const PolytopeFacet& b) { return out(a) < out(b); });
}

/// Encloses how far the offsets are beyond the exact plane of a facet.
Interval Polytope::beyond(const PolytopeFacet& facet, const IntervalVector& offset, double size) const
{
  return dot(facet.exact, offset) - Interval(size) * facet.level;
}

HalfSpace Polytope::halfSpace(const Box& part, const Vector3d& center, double size) const
{
  const PolytopeFacet& facet = outermost(part.center() - center, size);
  const Interval offset = dot(enclose(facet.normal), enclose(center)) + Interval(size) * facet.most;
  return { facet.normal, offset.upper() };
}

bool Polytope::misses(const Box& box, const Vector3d& center, double size) const
{
  const Box bounds = boundingBox(center, size);
  if ((box.lower.array() > bounds.upper.array()).any() || (box.upper.array() < bounds.lower.array()).any())
    return true;
  const Vector3d offset = box.center() - center;
  const Vector3d half = box.halfWidths();
  const IntervalVector offsets = enclose(box) - enclose(center);
  return std::any_of(facets_.begin(), facets_.end(), [&](const PolytopeFacet& facet) {
    const double guess = facet.normal.dot(offset) - facet.normal.cwiseAbs().dot(half) - size * facet.most.upper();
    return guess > 0.0 && dot(enclose(facet.normal), offsets).lower() > (Interval(size) * facet.most).upper();
  });
}

bool Polytope::contains(const Vector3d& point, const Box& centers, double size) const
{
  const IntervalVector offset = enclose(point) - enclose(centers);
  return std::all_of(facets_.begin(), facets_.end(),
                     [&](const PolytopeFacet& facet) { return beyond(facet, offset, size).upper() <= 0.0; });
}

/// A region that avoids a point has it beyond one of the exact planes. Where planes that are one but for rounding are
/// all that is left over the centers, the distance to them is affine.
std::optional<AffineForm<double>> Polytope::avoidance(const Vector3d& point, const Box& centers, double size) const
{
  const IntervalVector offset = enclose(point) - enclose(centers);
  const PolytopeFacet* left = nullptr;
  Interval others(0.0);  // how much further the point may be beyond one of them
  for (const PolytopeFacet& facet : facets_)
  {
    if (beyond(facet, offset, size).upper() <= 0.0)
      continue;
    if (left == nullptr)
      left = &facet;
    const Interval more = dot(facet.exact - left->exact, offset) - Interval(size) * (facet.level - left->level);
    others = Interval(0.0, std::max(others.upper(), more.upper()));
    if (others.upper() > 1e-9 * size * (upper_ - lower_).maxCoeff())
      return std::nullopt;
  }
  AffineForm<double> form;
  form.center = -1.0;
  if (left == nullptr)
    return form;  // no region avoids it
  const CenteredBox<double> box(centers);
  form =
      AffineForm<double>() + Enclosed<double>(dot(left->exact, enclose(point)) - Interval(size) * left->level + others);
  for (std::size_t k = 0; k < 3; ++k)
    form = form + Enclosed<double>(-left->exact[k]) * coordinate(box, k);
  return form;
}

Growing<Interval> Polytope::support(const IntervalVector& n) const
{
  Interval most = dot(n, enclose(vertices_.front()));
  for (const Vector3d& vertex : vertices_)
    most = largest(most, dot(n, enclose(vertex)));
  return { Interval(0.0), largest(most, Interval(0.0)) };  // the center is one of its points
}

Growing<double> Polytope::support(const Vector3d& n) const
{
  double most = 0.0;
  for (const Vector3d& vertex : vertices_)
    most = std::max(most, n.dot(vertex));
  return { 0.0, most };
}

Vector3d Polytope::exit(const Vector3d& point, const Vector3d& center, double size) const
{
  return outermost(point - center, size).normal.normalized();
}

Vector3d Polytope::nearest(const Vector3d& point, const Vector3d& center, double size) const
{
  const Vector3d offset = point - center;
  const PolytopeFacet& facet = outermost(offset, size);
  if (facet.normal.dot(offset) <= size * (1.0 - INWARD) * facet.most.mid())
    return point;
  Vector3d best = size * inner_;
  for (const auto& [a, b, c] : triangles_)
  {
    const Vector3d on = nearestOfTriangle(offset, size * vertices_[a], size * vertices_[b], size * vertices_[c]);
    if ((on - offset).squaredNorm() < (best - offset).squaredNorm())
      best = on;
  }
  return center + best + INWARD * (size * inner_ - best);
}

/// Moved up where that changes no vertex but exactly.
ShapePtr Polytope::standing() const
{
  std::vector<Vector3d> moved = vertices_;
  for (Vector3d& vertex : moved)
  {
    const Interval z = Interval(vertex.z()) - Interval(lower_.z());
    if (!z.isSingle())
      return nullptr;
    vertex.z() = z.lower();
  }
  try
  {
    return std::make_shared<Polytope>(moved);
  }
  catch (const std::invalid_argument&)
  {
    return nullptr;  // the center would not be in its lowest face
  }
}
}  // namespace pkm_workspace
