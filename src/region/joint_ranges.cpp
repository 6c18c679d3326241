// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/region/joint_ranges.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>
#include <stdexcept>

#include "pkm_workspace/interval/affine_vector.h"
#include "pkm_workspace/interval/half_space.h"

namespace pkm_workspace
{
namespace
{
using Eigen::Vector3d;

/// Steps of the projected gradient method; it converges geometrically, and a proof does not rest on it.
constexpr int STEPS = 400;
constexpr double SMALLEST_MOVE = 1e-14;  ///< relative to the size

/// Where the search for the largest value over a round region ends: parts, and a gap relative to the size.
constexpr int PARTS = 20000;
constexpr double GAP = 1e-9;

/// f = weight . (p - c) - height, where height = sqrt(L^2 - |q|^2) is a concave function of p (a sphere around the
/// rail); weight is s e for the joint value times s, and 0 for the height alone. So f is convex: least somewhere
/// within, largest at a vertex.
class ConvexFunction
{
public:
  ConvexFunction(const Machine& machine, int leg, const IntervalVector& weight)
    : center_(machine.center(leg))
    , projector_(machine.projector(leg))
    , length_(machine.leg(leg).length)
    , weight_(weight)
    , middle_center_(mid(center_))
    , middle_weight_(mid(weight))
    , middle_squared_length_(length_.mid() * length_.mid())
  {
    for (int row = 0; row < 3; ++row)
      middle_projector_.row(row) = mid(projector_[static_cast<std::size_t>(row)]);
  }

  struct Value
  {
    Interval value;
    IntervalVector gradient;
  };

  /// @throws std::domain_error where the strut does not surely reach
  Value at(const IntervalVector& p) const
  {
    const IntervalVector offset = p - center_;
    const IntervalVector across = projector_ * offset;
    const Interval radicand = sqr(length_) - squaredNorm(across);
    if (!(radicand.lower() > 0.0))
      throw std::domain_error("joint ranges: a strut does not reach, or just reaches, part of the region");
    const Interval height = sqrt(radicand);
    return { dot(weight_, offset) - height, weight_ + (Interval(1.0) / height) * across };
  }

  /// Encloses the value over a box, wherever the strut reaches.
  AffineForm<double> over(const CenteredBox<double>& box) const
  {
    AffineVector<double> across, along;
    mapBox(EnclosedMatrix<double>(projector_), EnclosedVector<double>(center_), box, across);
    mapBox(EnclosedMatrix<double>({ weight_, IntervalVector{}, IntervalVector{} }), EnclosedVector<double>(center_),
           box, along);
    const AffineForm<double> radicand = -squaredNorm(across) + Enclosed<double>(sqr(length_));
    return component(along, 0) - sqrtAbove(radicand, 0.0);
  }

  /// In floating point.
  Vector3d gradientAt(const Vector3d& p) const
  {
    const Vector3d across = middle_projector_ * (p - middle_center_);
    return middle_weight_ + across / std::sqrt(middle_squared_length_ - across.squaredNorm());
  }

  /// A bound, for step lengths, on the second derivatives where the value is at least the one given: L^2 / height^3.
  double curvature(double least_height) const
  {
    return length_.upper() * length_.upper() / (least_height * least_height * least_height);
  }

private:
  IntervalVector center_;
  IntervalMatrix projector_;
  Interval length_;
  IntervalVector weight_;
  Vector3d middle_center_;
  Vector3d middle_weight_;
  double middle_squared_length_;
  Eigen::Matrix3d middle_projector_;
};

/// The region that is looked at.
struct Region
{
  const Shape& shape;
  Vector3d center;
  double size;

  IntervalVector vertex(const Vector3d& k) const { return enclose(center) + Interval(size) * enclose(k); }
};

/// Encloses the largest value over a polytope: a convex function takes it at a vertex.
Interval maximumAtVertices(const ConvexFunction& f, const Region& region)
{
  Interval largest = f.at(enclose(region.center)).value;
  for (const Vector3d& k : region.shape.extremePoints())
  {
    const Interval value = f.at(region.vertex(k)).value;
    largest = Interval(std::max(largest.lower(), value.lower()), std::max(largest.upper(), value.upper()));
  }
  return largest;
}

/// Encloses the largest value over any region, by bisection of its bounding box, highest upper bound first.
class Maximum
{
public:
  Maximum(const ConvexFunction& f, const Region& region)
    : f_(f), region_(region), least_(f.at(enclose(region.center)).value.lower())
  {}

  Interval run()
  {
    for (const Box& box : region_.shape.extremeBoxes(region_.center, region_.size))
      look(box);
    const double enough = GAP * region_.size;
    for (int part = 0; part < PARTS && !open_.empty() && open_.top().bound > least_ + enough; ++part)
    {
      const Box box = open_.top().box;
      const int axis = box.widestAxis();
      if (!box.canBisect(axis))
        break;
      open_.pop();
      const auto halves = box.bisect(axis);
      look(halves.first);
      look(halves.second);
    }
    return { least_, open_.empty() ? least_ : std::max(least_, open_.top().bound) };
  }

private:
  struct Part
  {
    Box box;
    double bound;
    bool operator<(const Part& other) const { return bound < other.bound; }
  };

  void look(const Box& box)
  {
    const Shape& shape = region_.shape;
    if (shape.misses(box, region_.center, region_.size))
      return;
    const auto point = nearestInside(shape, box.center(), region_.center, region_.size);
    if (point)
      least_ = std::max(least_, f_.at(enclose(*point)).value.lower());
    const CenteredBox<double> centered(box);
    const AffineForm<double> negative = -f_.over(centered);
    const AffineForm<double> slack = slackOf(shape.halfSpace(box, region_.center, region_.size), centered);
    const double bound = -lowered(negative, multiplier(negative, slack), slack).lower();
    open_.push({ box, std::isnan(bound) ? std::numeric_limits<double>::infinity() : bound });
  }

  const ConvexFunction& f_;
  const Region& region_;
  double least_;
  std::priority_queue<Part> open_;
};

Interval maximum(const ConvexFunction& f, const Region& region)
{
  return region.shape.isPolytope() ? maximumAtVertices(f, region) : Maximum(f, region).run();
}

/// Encloses the least value: it is attained nearly at the point that the descent ends at, and a convex function lies
/// above its tangent plane there.
Interval minimum(const ConvexFunction& f, const Region& region, double step)
{
  const Shape& shape = region.shape;
  Vector3d point = region.center;
  for (int k = 0; k < STEPS; ++k)
  {
    const Vector3d next = shape.nearest(point - step * f.gradientAt(point), region.center, region.size);
    const double move = (next - point).cwiseAbs().maxCoeff();
    point = next;
    if (move <= SMALLEST_MOVE * region.size)
      break;
  }
  point = nearestInside(shape, point, region.center, region.size).value_or(region.center);
  const ConvexFunction::Value value = f.at(enclose(point));
  const IntervalVector& g = value.gradient;
  const Interval to_center = dot(g, enclose(region.center) - enclose(point));
  const Interval tangent = value.value + to_center - Interval(region.size) * shape.support({ -g[0], -g[1], -g[2] });
  return Interval(std::min(tangent.lower(), value.value.lower()), value.value.upper());
}

Interval leastHeight(const Machine& machine, int leg, const Region& region)
{
  return -maximum(ConvexFunction(machine, leg, IntervalVector{}), region);
}

JointRange rangeOf(const Machine& machine, int leg, const Region& region)
{
  const Interval sign(machine.leg(leg).working_mode);
  const ConvexFunction joint(machine, leg, sign * machine.leg(leg).axis);  // s rho
  const ConvexFunction height(machine, leg, IntervalVector{});
  const Interval least_height = leastHeight(machine, leg, region);
  const double step = 1.0 / joint.curvature(least_height.lower());
  const Interval first = minimum(joint, region, step);
  const Interval last = maximum(joint, region);
  JointRange range;
  range.lower = machine.leg(leg).working_mode > 0 ? first : -last;
  range.upper = machine.leg(leg).working_mode > 0 ? last : -first;
  const Interval not_negative(0.0, std::numeric_limits<double>::infinity());
  range.stroke = intersection(range.upper - range.lower, not_negative);
  range.across = intersection(-minimum(height, region, step) - least_height, not_negative);
  return range;
}
}  // namespace

std::array<JointRange, 3> jointRanges(const Machine& machine, const Shape& shape, const Vector3d& center, double size)
{
  const Region region{ shape, center, size };
  return { rangeOf(machine, 0, region), rangeOf(machine, 1, region), rangeOf(machine, 2, region) };
}
}  // namespace pkm_workspace
