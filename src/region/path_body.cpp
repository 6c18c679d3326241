// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/region/path_body.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>

#include "path_looks.h"
#include "pkm_workspace/region/convex_hull.h"

namespace pkm_workspace
{
namespace
{
using Eigen::Vector3d;

/// Places are rounded a few times: of the largest coordinate.
constexpr double PLACE_ROUNDING = 1e-14;
/// Steps of the grid of directions in which the outline is extreme.
constexpr int OUTLINE = 4;
/// Most points near to which joints go fast that are kept.
constexpr std::size_t MOST_FAST = 12;

/// Keeps the points that are extreme along the directions from the middle of a cube to points of a grid on its faces.
class ExtremePoints
{
public:
  struct Extreme
  {
    Vector3d direction;
    Vector3d point = Vector3d::Zero();
    double level = -INF;
  };

  /// @param steps of the grid from the middle of a face to its edge: 1 gives the directions to faces, edges and corners
  explicit ExtremePoints(int steps)
  {
    for (int x = -steps; x <= steps; ++x)
      for (int y = -steps; y <= steps; ++y)
        for (int z = -steps; z <= steps; ++z)
          if (std::max({ std::abs(x), std::abs(y), std::abs(z) }) == steps)
            all_.push_back({ Vector3d(x, y, z) });
  }

  void look(const Vector3d& point)
  {
    for (Extreme& extreme : all_)
      if (const double level = extreme.direction.dot(point); level > extreme.level)
      {
        extreme.level = level;
        extreme.point = point;
      }
  }
  const std::vector<Extreme>& all() const { return all_; }

private:
  std::vector<Extreme> all_;
};

bool isSame(const GrowingVector& a, const GrowingVector& b)
{
  return a.fixed == b.fixed && a.per_size == b.per_size;
}

/// Corners of a cube that a direction points to.
std::vector<Vector3d> cornersAlong(const Vector3d& direction)
{
  std::vector<Vector3d> corners;
  for (int k = 0; k < 8; ++k)
  {
    const Vector3d corner(k % 2 == 0 ? -1.0 : 1.0, k / 2 % 2 == 0 ? -1.0 : 1.0, k / 4 == 0 ? -1.0 : 1.0);
    if ((corner.cwiseProduct(direction).array() >= 0.0).all())
      corners.push_back(corner);
  }
  return corners;
}
}  // namespace

Box Workpiece::bounds() const
{
  if (!solid)
    return moves.bounds();
  Box box{ Vector3d::Constant(INF), Vector3d::Constant(-INF) };
  for (const GrowingVector& corner : solid->extremePoints())
  {
    box.lower = box.lower.cwiseMin(reference + corner.per_size);
    box.upper = box.upper.cwiseMax(reference + corner.per_size);
  }
  const double rounding = PLACE_ROUNDING * std::max(box.lower.cwiseAbs().maxCoeff(), box.upper.cwiseAbs().maxCoeff());
  return { box.lower - Vector3d::Constant(rounding), box.upper + Vector3d::Constant(rounding) };
}

double Workpiece::lowest() const
{
  const double bound = bounds().lower.z();
  double lowest = INF;
  if (solid)
    for (const GrowingVector& corner : solid->extremePoints())
      lowest = std::min(lowest, reference.z() + corner.per_size.z());
  for (std::uint32_t index = 0; index < moves.size(); ++index)
    for (const double t : { 0.0, 1.0 })
      lowest = std::min(lowest, mid(moves.curve({ 0, index }).point(t)).z());
  return lowest - bound > 10.0 * PLACE_ROUNDING * std::max(1.0, std::abs(bound)) ? bound : lowest;
}

PathBody::PathBody(std::shared_ptr<const Workpiece> workpiece, Grows grows, double least_scale,
                   const JointRateLimits& limits)
  : workpiece_(std::move(workpiece))
  , grows_(grows)
  , least_scale_(least_scale)
  , limits_(grows == Grows::MARGIN ? limits : JointRateLimits{})
  , bounds_(workpiece_->bounds())
{
  const double farthest = std::max({ bounds_.lower.cwiseAbs().maxCoeff(), bounds_.upper.cwiseAbs().maxCoeff(),
                                     workpiece_->reference.cwiseAbs().maxCoeff() });
  slack_ = PLACE_ROUNDING * std::max(farthest, 1e-3);
  chooseExtremes();
  if (workpiece_->solid)
    makeEdgePlanes();
}

void PathBody::makeEdgePlanes()
{
  const std::vector<Vector3d> corners = pointsOf(workpiece_->solid->extremePoints(), Vector3d::Zero(), 1.0);
  const auto most = [&corners](const Vector3d& normal) {
    double value = -INF;
    for (const Vector3d& corner : corners)
      value = std::max(value, dot(enclose(normal), enclose(corner)).upper());
    return value;
  };
  for (const auto& [a, b, c] : convexHull(corners))
    for (const auto& [from, to] : { std::pair(a, b), std::pair(b, c), std::pair(c, a) })
      for (int axis = 0; axis < 3 && from < to; ++axis)
        for (const double sense : { -1.0, 1.0 })
        {
          const Vector3d normal = sense * (corners[to] - corners[from]).cross(Vector3d::Unit(axis));
          if (normal.norm() > 0.0)
            edge_planes_.push_back({ normal.normalized(), most(normal.normalized()) });
        }
}

double PathBody::slack(double size) const
{
  return grows_ == Grows::MARGIN ? slack_ : 4.0 * slack_ * (1.0 + size);
}

/// Where in the family a point of the workpiece is, and one that is moved from there along the cube of the margin.
GrowingVector PathBody::placeOfPoint(const Vector3d& point, const Vector3d& along) const
{
  if (grows_ == Grows::MARGIN)
    return { point, along };
  const Vector3d& reference = workpiece_->reference;
  return { least_scale_ == 1.0 ? point : reference, point - reference };
}

void PathBody::chooseExtremes()
{
  ExtremePoints few(1);
  ExtremePoints many(OUTLINE);
  forEachPoint([&](const Vector3d& point) {
    few.look(point);
    many.look(point);
  });
  addPlaces(few.all(), extremes_);
  addPlaces(many.all(), outline_);
}

template <class Extremes>
void PathBody::addPlaces(const Extremes& extremes, std::vector<GrowingVector>& places) const
{
  for (const auto& extreme : extremes)
    for (const Vector3d& corner : cornersAlong(extreme.direction))
    {
      const GrowingVector place = placeOfPoint(extreme.point, corner);
      if (std::none_of(places.begin(), places.end(), [&](const auto& known) { return isSame(known, place); }))
        places.push_back(place);
    }
}

GrowingVector PathBody::lower() const
{
  const Vector3d rounding = Vector3d::Constant(slack_);
  if (grows_ == Grows::MARGIN)
    return { bounds_.lower - rounding, -Vector3d::Ones() };
  const Vector3d from_reference = bounds_.lower - workpiece_->reference - rounding;
  return { workpiece_->reference + least_scale_ * from_reference, from_reference.cwiseMin(0.0) };
}

GrowingVector PathBody::upper() const
{
  const Vector3d rounding = Vector3d::Constant(slack_);
  if (grows_ == Grows::MARGIN)
    return { bounds_.upper + rounding, Vector3d::Ones() };
  const Vector3d from_reference = bounds_.upper - workpiece_->reference + rounding;
  return { workpiece_->reference + least_scale_ * from_reference, from_reference.cwiseMax(0.0) };
}

/// Of its bounding box.
Growing<Interval> PathBody::support(const IntervalVector& n) const
{
  const GrowingVector low = lower();
  const GrowingVector high = upper();
  return { Interval(dot(n, enclose(Box{ low.fixed, high.fixed })).upper()),
           Interval(dot(n, enclose(Box{ low.per_size, high.per_size })).upper()) };
}

Growing<double> PathBody::support(const Vector3d& n) const
{
  const Growing<Interval> most = support(enclose(n));
  return { most.fixed.upper(), most.per_size.upper() };
}

Vector3d PathBody::exit(const Vector3d&, const Vector3d&, double) const
{
  return Vector3d::UnitZ();
}

Vector3d PathBody::nearest(const Vector3d& point, const Vector3d& center, double size) const
{
  return point.cwiseMax(center + lower().at(size)).cwiseMin(center + upper().at(size));
}

/// Whether joints are too fast there for every center, in one of the corners of the margin.
bool PathBody::isTooFast(const BoxTest& test, const FastPoint& fast, const CenteredBox<double>& centers,
                         double size) const
{
  const Curve& curve = workpiece_->moves.curve(fast.part);
  const CurvePiece there = curve.piece(fast.t, fast.t);
  const SkewBox<double> curvature = curve.curvatures(fast.t, fast.t);
  for (const Vector3d& corner : cornersAlong(Vector3d::Zero()))
  {
    const CenteredBox<double> box = centers.moved(size, { mid(curve.point(fast.t)), corner });
    CurvePiece piece = there;
    piece.points = {};
    piece.points.center = box.center;
    for (std::size_t k = 0; k < 3; ++k)
      piece.points.edges[k][k] = box.half_widths[k];
    piece.points.slack = box.slack;
    PieceRates rates;
    test.kernel().rates(&piece, &curvature, 1, &rates);
    if (verdictOn(rates, limits_, workpiece_->moves.speed(fast.part)) == BoxVerdict::OUTSIDE)
      return true;
  }
  return false;
}

void PathBody::learnOutline(const GrowingVector& place) const
{
  outline_.push_back(place);
}

void PathBody::learnFast(const FastPoint& fast) const
{
  if (fast_.size() == MOST_FAST)
    fast_.erase(fast_.begin());
  fast_.push_back(fast);
}

bool PathBody::refutes(const BoxTest& test, const Box& centers, double size) const
{
  if (fast_.empty())
    return false;
  CenteredBox<double> box(centers);
  box.slack = slack(size);
  return std::any_of(fast_.begin(), fast_.end(),
                     [&](const FastPoint& fast) { return isTooFast(test, fast, box, size); });
}
}  // namespace pkm_workspace
