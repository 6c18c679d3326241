// SPDX-License-Identifier: BSD-3-Clause
// The part of the proof that tells what of a body lies where.
#include "path_body_proof.h"

#include <algorithm>
#include <cmath>

namespace pkm_workspace
{
namespace
{
using Eigen::Vector3d;

/// Parts that are wider than this share of a box are divided before they are taken for their own boxes.
constexpr double COARSE = 0.5;
/// Parts are not divided below this [longest strut].
constexpr double FINEST = 1e-12;
/// A share of a box that is not worth looking for a point that covers as much more.
constexpr double ENOUGH_COVER = 0x1p-8;
/// Of the width of a box: parts that are narrower are as good as points there.
constexpr double FINE_PART = 0.05;
}  // namespace

/// Contains all points of the part, moved.
Box PathBody::Proof::placed(const Part& part) const
{
  const Box box = moves_.box(part.path);
  Box result;
  for (int k = 0; k < 3; ++k)
  {
    Interval side = box.side(k);
    const Interval reference(body_.workpiece_->reference[k]);
    if (part.low != 1.0 || part.high != 1.0)
      side = reference + Interval(part.low, part.high) * (side - reference);
    side = side + Interval(center_[k]);
    result.lower[k] = side.lower();
    result.upper[k] = side.upper();
  }
  return result;
}

/// Contains what the points of a box are moved to; of a solid, whose place is rounded, too.
Box PathBody::Proof::thickened(const Box& box, double reach) const
{
  const double rounding = body_.workpiece_->solid ? body_.slack(most_) : 0.0;
  const Interval by = Interval(reach) + Interval(rounding);
  Box result;
  for (int k = 0; k < 3; ++k)
  {
    result.lower[k] = (Interval(box.lower[k]) - by).lower();
    result.upper[k] = (Interval(box.upper[k]) + by).upper();
  }
  return result;
}

/// Points that each point of a small box is moved to, by the generous reach.
Box PathBody::Proof::coveredBy(const Box& point) const
{
  Box result;
  for (int k = 0; k < 3; ++k)
  {
    result.lower[k] = (Interval(point.upper[k]) - Interval(generous_)).upper();
    result.upper[k] = (Interval(point.lower[k]) + Interval(generous_)).lower();
  }
  return result;
}

/// How far points of the part go with the scale.
double PathBody::Proof::sweepOf(const Part& part) const
{
  if (part.low == part.high)
    return 0.0;
  const Box box = moves_.box(part.path);
  const Vector3d& reference = body_.workpiece_->reference;
  return (part.high - part.low) *
         std::max((box.upper - reference).cwiseAbs().maxCoeff(), (box.lower - reference).cwiseAbs().maxCoeff());
}

bool PathBody::Proof::isLarge(const Part& part, const Box& placed, const Box& within) const
{
  const double width = placed.maxWidth();
  const double scale = std::sqrt(test_.model().legs().squaredScale());
  return width > std::max(COARSE * within.maxWidth(), FINEST * scale) && moves_.isDivisible(part.path);
}

/// Which share of the box a part may cover at the most, or does where it is a point.
double PathBody::Proof::coverage(const Part& part, const Box& within) const
{
  const Box common = intersection(thickened(placed(part), generous_), within);
  double share = 1.0;
  for (int k = 0; k < 3; ++k)
    if (common.upper[k] < common.lower[k])
      return 0.0;
    else if (within.width(k) > 0.0)
      share *= common.width(k) / within.width(k);
  return share;
}

/// Finds a point of the part that covers more of the box than the best one so far, if there is one.
void PathBody::Proof::seekCover(const Part& part, const Box& within, Cover& best) const
{
  if (coverage(part, within) <= best.share + ENOUGH_COVER)
    return;
  for (const double t : { part.path.first, part.path.last })
    if (part.path.level == 0)
    {
      const Part end{ { 0, part.path.index, t, t }, part.low, part.high };
      const double share = coverage(end, within);
      if (share > best.share)
        best = { end, share };
    }
  if (part.path.level > 0 || placed(part).maxWidth() > FINE_PART * within.maxWidth())
    halve(part, [&](const Part& smaller) { seekCover(smaller, within, best); });
}

/// Whether all points of a box are points that one of those parts is moved to.
bool PathBody::Proof::isCovered(const Box& box, const Gathering& into)
{
  const Box common = intersection(box, into.cover);
  return box.isValid() && common.lower == box.lower && common.upper == box.upper;
}

bool PathBody::Proof::isSamePoint(const Part& a, const Part& b)
{
  return a.path.level == 0 && b.path.level == 0 && a.path.index == b.path.index && a.path.first == a.path.last &&
         a.path.first == b.path.first && b.path.first == b.path.last && a.low == b.low && a.high == b.high;
}

/// Keeps the parts that may have points in the box, and what is around them. What a part that others rely on has to
/// prove for them is covered as its own points are: else what it covered would be nowhere.
void PathBody::Proof::gather(const Part& part, Gathering& into) const
{
  const Box exact = placed(part);
  if (isCovered(intersection(thickened(exact, reachOf(part)), into.within), into))
    return;
  const Box box = thickened(exact, generous_);
  const Box common = intersection(box, into.within);
  if (!common.isValid())
    return;
  const bool is_within = common.lower == box.lower && common.upper == box.upper;
  if (!is_within && isLarge(part, exact, into.within))
    halve(part, [&](const Part& smaller) { gather(smaller, into); });
  else
    into.keep(part, common);
}

/// Keeps of the parts one point first that covers as much of the box as it can: what the others would add to that is
/// mostly nothing.
void PathBody::Proof::gatherCovered(const Part* first, const Part* last, Gathering& into) const
{
  Cover best;
  if (reach_ > 0.0 && into.within.maxWidth() < INF)
    std::for_each(first, last, [&](const Part& part) { seekCover(part, into.within, best); });
  into.cover = nowhere();
  if (best.share > 0.0)
  {
    best.point.is_relied_on = true;
    into.cover = coveredBy(placed(best.point));
    into.keep(best.point, intersection(thickened(placed(best.point), generous_), into.within));
  }
  std::for_each(first, last, [&](const Part& part) {
    if (best.share == 0.0 || !isSamePoint(part, best.point))
      gather(part, into);
  });
}

/// Whether what the joints do at a point depends on the move only, and not on where on it the point is.
bool PathBody::Proof::isLine(const Part& part) const
{
  return part.path.level == 0 && moves_.curve(part.path).angle() == Interval(0.0);
}

/// For rates points cover each other only where they are of one line.
void PathBody::Proof::open(const Box& within, const Parts& parts)
{
  Gathering into{ within };
  const Part* const end = parts.data() + parts.size();
  for (const Part *first = parts.data(), *last = end; first != end; first = last, last = end)
  {
    if (asks_for_rates_)
      last = std::find_if(first + 1, end, [first](const Part& part) {
        return part.path.level != first->path.level || part.path.index != first->path.index;
      });
    if (!asks_for_rates_ || isLine(*first))
      gatherCovered(first, last, into);
    else
    {
      into.cover = nowhere();
      std::for_each(first, last, [&](const Part& part) { gather(part, into); });
    }
  }
  if (!into.kept.empty())
    open_.put({ into.hull, std::make_shared<Parts>(std::move(into.kept)) });
}

void PathBody::Proof::openSolid(const Box& within)
{
  const Workpiece& piece = *body_.workpiece_;
  const Box around = thickened(within, reach_);
  if (!piece.solid->misses(around, center_ + piece.reference, most_) && !isApart(around))
    open_.put({ within, nullptr });
}

/// Whether a plane along an edge of the solid and one of the box lies between them: with the faces of both, which
/// Shape::misses() knows, there are no others to look at.
bool PathBody::Proof::isApart(const Box& box) const
{
  const Vector3d origin = center_ + body_.workpiece_->reference;
  const Vector3d middle = box.center() - origin;
  const Vector3d half_widths = box.halfWidths();
  return std::any_of(body_.edge_planes_.begin(), body_.edge_planes_.end(), [&](const EdgePlane& plane) {
    const double nearest = plane.normal.dot(middle) - plane.normal.cwiseAbs().dot(half_widths);
    if (nearest <= most_ * plane.most)
      return false;
    const IntervalVector n = enclose(plane.normal);
    return dot(n, enclose(box)).lower() > (dot(n, enclose(origin)) + Interval(most_) * Interval(plane.most)).upper();
  });
}
}  // namespace pkm_workspace
