// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/dexterity/region_check.h"

#include <algorithm>
#include <vector>

#include "pkm_workspace/common/branch_and_bound.h"

namespace pkm_workspace
{
namespace
{
/// Bisects a box, depth first, until @p judge answers ALL or NONE for every part, or has given both answers.
template <class Judge>
class Bisect : public BranchingDefaults
{
public:
  Bisect(double min_width, const Judge& judge) : min_width_(min_width), judge_(judge) {}

  /// Limits of branchAndBound().
  struct Limits
  {
    std::int64_t max_boxes;
    const std::atomic<bool>* stop;

    bool hasSpent(std::int64_t boxes) const { return boxes == max_boxes; }
    bool isOver() const { return stop && *stop; }
    static bool isFull(std::size_t /*bytes*/) { return false; }
  };

  Share run(const Box& box, const Limits& limits)
  {
    open_.put(box);
    if (branchAndBound(open_, *this, limits) == Ending::BUDGET)
      return Share::UNDECIDED;
    if (isSettled())
      return Share::SOME;
    return undecided_ ? Share::UNDECIDED : all_ ? Share::ALL : Share::NONE;
  }

  std::int64_t looks() const { return boxes_; }
  bool isSettled() const { return all_ && none_; }

  bool expand(const std::vector<Box>& wave)
  {
    for (const Box& part : wave)
      look(part);
    return true;
  }

private:
  void look(const Box& part)
  {
    ++boxes_;
    const Share share = judge_(part);
    const int axis = part.widestAxis();
    const bool is_open = share == Share::UNDECIDED;
    if (is_open && part.width(axis) > min_width_ && part.canBisect(axis))
    {
      const auto halves = part.bisect(axis);
      open_.put(halves.first);
      open_.put(halves.second);
      return;
    }
    all_ = all_ || share == Share::ALL;
    none_ = none_ || share == Share::NONE;
    undecided_ = undecided_ || is_open;
  }

  const double min_width_;
  const Judge& judge_;
  DepthFirst<Box> open_;
  std::int64_t boxes_ = 0;
  bool all_ = false;
  bool none_ = false;
  bool undecided_ = false;
};

template <class Judge>
Share bisect(const Box& box, double min_width, std::int64_t max_boxes, const std::atomic<bool>* stop,
             const Judge& judge)
{
  return Bisect<Judge>(min_width, judge).run(box, { max_boxes, stop });
}

Share shareOf(BoxVerdict verdict)
{
  return verdict == BoxVerdict::INSIDE ? Share::ALL : verdict == BoxVerdict::OUTSIDE ? Share::NONE : Share::UNDECIDED;
}

Interval around(const Interval& centers, double edge)
{
  const Interval half = Interval(edge) * Interval(0.5);
  return centers + Interval(-half.upper(), half.upper());
}

/// What all intervals [c - edge / 2, c + edge / 2] with c in @p centers share, rounded inward; may be empty.
Interval common(const Interval& centers, double edge)
{
  const Interval half = Interval(edge) * Interval(0.5);
  const double lower = (Interval(centers.upper()) - half).upper();
  const double upper = (Interval(centers.lower()) + half).lower();
  return lower <= upper ? Interval(lower, upper) : Interval::empty();
}

/// Sets of coordinates along one axis, each of which meets all intervals [c - edge / 2, c + edge / 2] with c in
/// @p centers: single coordinates that these intervals share, or else where their ends and middles are.
std::vector<Interval> stations(const Interval& centers, double edge)
{
  if (edge == 0.0)
    return { centers };
  const Interval shared = common(centers, edge);
  if (!shared.isEmpty())
    return { shared.lower(), shared.upper(), shared.mid() };
  const Interval half = Interval(edge) * Interval(0.5);
  return { centers - half, centers + half, centers };
}

/// G without bisecting the box of centers.
class CenterCheck
{
public:
  CenterCheck(const BoxClassifier& classify, const Eigen::Vector3d& edges, const BisectionLimits& limits)
    : classify_(classify), edges_(edges), limits_(limits)
  {}

  Share operator()(const Box& centers) const
  {
    if (refusesEveryRegion(centers))
      return Share::NONE;
    // Property 1 of the paper: every region lies in the hull.
    const IntervalVector hull = map(centers, around);
    if (!hasBadCorner(hull) && verify(hull, centers) == Share::ALL)
      return Share::ALL;
    // A last look before these centers stay undecided: a bad point anywhere in what all regions share.
    const IntervalVector core = map(centers, common);
    if (centers.maxWidth() > limits_.center_width || core[0].isEmpty() || core[1].isEmpty() || core[2].isEmpty())
      return Share::UNDECIDED;
    const Share good = verify(core, centers);
    return good == Share::NONE || good == Share::SOME ? Share::NONE : Share::UNDECIDED;
  }

private:
  template <class Function>
  IntervalVector map(const Box& centers, const Function& function) const
  {
    return { function(centers.side(0), edges_[0]), function(centers.side(1), edges_[1]),
             function(centers.side(2), edges_[2]) };
  }

  bool isBad(const IntervalVector& points) const { return classify_(boundingBox(points)) == BoxVerdict::OUTSIDE; }

  Share verify(const IntervalVector& points, const Box& centers) const
  {
    // much narrower parts would tell the regions of different centers apart: no answer for all of them
    const double part_width = std::max(limits_.part_width, centers.maxWidth() / 16);
    return verifyBox(classify_, boundingBox(points), part_width, limits_.max_parts, limits_.stop);
  }

  /// The corner rule: regions are products of intervals, so a product of stations has a point in common with every
  /// region; when all of its points are bad, no region is good. The paper's corners of B are such points while B is at
  /// most w / 2 wide; those of what all regions share refuse more, and wider boxes.
  bool refusesEveryRegion(const Box& centers) const
  {
    for (const Interval& x : stations(centers.side(0), edges_[0]))
      for (const Interval& y : stations(centers.side(1), edges_[1]))
        for (const Interval& z : stations(centers.side(2), edges_[2]))
          if (isBad({ x, y, z }))
            return true;
    return false;
  }

  /// Saves looking for a proof that there is none of.
  bool hasBadCorner(const IntervalVector& hull) const
  {
    for (const double x : { hull[0].lower(), hull[0].upper() })
      for (const double y : { hull[1].lower(), hull[1].upper() })
        for (const double z : { hull[2].lower(), hull[2].upper() })
          if (isBad({ x, y, z }))
            return true;
    return false;
  }

  const BoxClassifier& classify_;
  const Eigen::Vector3d edges_;
  const BisectionLimits limits_;
};
}  // namespace

Share verifyBox(const BoxClassifier& classify, const Box& box, double part_width, std::int64_t max_boxes,
                const std::atomic<bool>* stop)
{
  return bisect(box, part_width, max_boxes, stop, [&classify](const Box& part) { return shareOf(classify(part)); });
}

Share checkCenters(const BoxClassifier& classify, const Box& centers, const Eigen::Vector3d& edges,
                   const BisectionLimits& limits)
{
  const CenterCheck check(classify, edges, limits);
  return bisect(centers, limits.center_width, limits.max_centers, limits.stop, [&](const Box& part) {
    const Share share = check(part);
    if (share == Share::ALL && limits.carried)
      limits.carried(part);
    return share;
  });
}
}  // namespace pkm_workspace
