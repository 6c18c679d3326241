// SPDX-License-Identifier: BSD-3-Clause
// The part of CenterSearch that asks about boxes of centers.
#include <algorithm>

#include "pkm_workspace/region/center_search.h"

namespace pkm_workspace
{
namespace
{
/// From so many boxes on the bounds of boxes are lowered on the way; a search that ends before has no use for them.
constexpr std::int64_t LONG_SEARCH = 512;
/// Looks that lower them.
constexpr int LOWERING_LOOKS = 256;
/// Angles over which the ends of regions go less are not divided [longest strut].
constexpr double LEAST_SWEEP = 1e-14;
}  // namespace

CenterSearch::Look CenterSearch::ask(const Node& node, double size, CenterTest& center_test) const
{
  if (node.bound <= size)
    return { size, Closing::BOUND, node.bound, node.room, { Closing::BOUND, node.centers, node.bound, {} } };
  const std::optional<Closing> excluded = center_test.excludes(node.centers, size, node.angles);
  return { size, excluded, node.bound, center_test.room(), center_test.reason() };
}

/// How far the ends of a region go over the angles, next to nothing where they do not [m].
double CenterSearch::sweepOf(const Node& node) const
{
  if (!query_.turns())
    return 0.0;
  double arm = 0.0;
  for (const GrowingVector& point : witnesses_.ofShape())
    arm = std::max(arm, point.at(target()).head<2>().norm());
  return arm * node.angles.width();
}

/// Whether the angles are what a node is to be divided by.
bool CenterSearch::dividesAngles(const Node& node) const
{
  const double sweep = sweepOf(node);
  return sweep > node.centers.maxWidth() && sweep > LEAST_SWEEP * scale_;
}

/// Whether the second order of the forms over the box is below what the accuracy makes of a region.
bool CenterSearch::isNarrow(const Node& node) const
{
  const double width = std::max(node.centers.maxWidth(), sweepOf(node));
  return width * width <= accuracy_ * query_.shape->halfExtents().per_size.maxCoeff() * scale_;
}

/// Asks whether the box can be excluded at the target; if not, whether the gap between its bound and the target can be
/// halved. As long as nothing is found, size 0 comes first where this is no point: boxes that all exclude it prove that
/// there is no region of any size.
CenterSearch::Look CenterSearch::lookAt(const Node& node, double size, CenterTest& center_test) const
{
  const bool may_be_none = !query_.shape->isScaling() && incumbent_.size() == 0.0;
  Look look = ask(node, may_be_none ? 0.0 : size, center_test);
  if (may_be_none && !look.excluded && isNarrow(node))
    look = ask(node, size, center_test);
  const double middle = 0.5 * (size + node.bound);
  const bool is_long = boxes_ >= LONG_SEARCH;
  if (is_long && !look.excluded && middle < node.bound && center_test.excludes(node.centers, middle, node.angles))
  {
    look.bound = middle;
    look.reason = center_test.reason();
  }
  return look;
}

void CenterSearch::settle(const Node& node, const Look& look)
{
  ++boxes_;
  if (look.excluded)
  {
    excluded_bound_ = std::max(excluded_bound_, std::min(node.bound, look.size));
    close(node, look.reason);
    return;
  }
  if (look.bound < node.bound)
    noteLowered(look.reason);
  tryCenter(node, target());
  if (boxes_ >= LONG_SEARCH && look.bound == node.bound)
    tryCenter(node, 0.5 * (target() + node.bound));
  if (!dividesAngles(node) && test_.isBeyondPrecision(node.centers))
  {
    unsettled_bound_ = std::max(unsettled_bound_, look.bound);
    close(node, { Closing::UNSETTLED, node.centers, look.bound, {} });
    return;
  }
  divide(node, look);
}

void CenterSearch::divide(const Node& node, const Look& look)
{
  if (dividesAngles(node))
  {
    const double middle = node.angles.mid();
    open_.put({ node.centers, look.bound, look.room, { node.angles.lower(), middle } });
    open_.put({ node.centers, look.bound, look.room, { middle, node.angles.upper() } });
    return;
  }
  const auto halves = node.centers.bisect(node.centers.widestAxis());
  open_.put({ halves.first, look.bound, look.room, node.angles });
  open_.put({ halves.second, look.bound, look.room, node.angles });
}

void CenterSearch::noteLowered(const Reason& reason)
{
  if (tellsReasons())
    lowered_.push_back(reason);
}

/// A bound that is worth as much was proved of a box that holds this one.
void CenterSearch::close(const Node& node, Reason reason) const
{
  if (!tellsReasons())
    return;
  const auto proves = [&node](const Reason& lowered) {
    return lowered.size == node.bound && (lowered.centers.lower.array() <= node.centers.lower.array()).all() &&
           (lowered.centers.upper.array() >= node.centers.upper.array()).all();
  };
  if (reason.closing == Closing::BOUND)
  {
    const auto earlier = std::find_if(lowered_.begin(), lowered_.end(), proves);
    if (earlier != lowered_.end())
      reason = *earlier;
    reason.closing = Closing::BOUND;
  }
  query_.closed(node.centers, reason);
}

/// Lowers the upper bound as far as looks at whole open boxes can.
void CenterSearch::lowerBounds()
{
  for (int look = 0; look < LOWERING_LOOKS && !open_.isEmpty(); ++look)
  {
    const Node& first = open_.first();
    const double middle = 0.5 * (target() + first.bound);
    if (first.bound <= target() || middle >= first.bound ||
        !center_tests_.front().excludes(first.centers, middle, first.angles))
      break;
    Node node = open_.take();
    noteLowered(center_tests_.front().reason());
    node.bound = middle;
    open_.put(node);
  }
  bracket_.narrow(0.0, upperBound());
}
}  // namespace pkm_workspace
