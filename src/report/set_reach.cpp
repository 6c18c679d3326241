// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/report/set_reach.h"

#include <algorithm>
#include <array>
#include <limits>

#include "pkm_workspace/dexterity/workspace_bounds.h"
#include "pkm_workspace/machine/leg_forms.h"
#include "pkm_workspace/region/containment.h"

namespace pkm_workspace
{
namespace
{
using Eigen::Vector3d;

constexpr double MOST = std::numeric_limits<double>::max();
/// Boxes of a coarse paving, boxes that are looked at of any, and boxes in which a region is proved to be reachable.
constexpr std::int64_t MOST_BOXES = 20000;
/// Along the widest side of a coarse paving.
constexpr double FINEST = 1.0 / 256.0;
/// Boxes that are held at a time.
constexpr std::size_t BLOCK = 4096;

const JointReaches UNKNOWN = reachAt({ Interval::entire(), Interval::entire(), Interval::entire() });

template <class Array>
auto& at(Array& array, int i)
{
  return array[static_cast<std::size_t>(i)];
}

/// Encloses the joint values at those points of a box that the strut reaches.
Interval jointsOver(const Machine& machine, int i, const Box& box)
{
  const EnclosedLeg& leg = machine.enclosed(i);
  LegState<Interval, IntervalVector> state;
  evaluate(leg, enclose(box), sqrtAboveZero, state);
  return state.squared_drive.upper() < 0.0 ? Interval::empty() : jointOf(leg, enclose(box), state);
}

/// Takes in boxes that together hold all points of a set: open ones, and those all of whose points belong to it.
class SetReach
{
public:
  explicit SetReach(const Machine& machine) : machine_(machine) { all_.fill(Interval::empty()); }

  void addOpen(const Box& box)
  {
    const std::array<Interval, 3> joints = { jointsOver(machine_, 0, box), jointsOver(machine_, 1, box),
                                             jointsOver(machine_, 2, box) };
    if (std::any_of(joints.begin(), joints.end(), [](const Interval& x) { return x.isEmpty(); }))
      return;
    for (std::size_t i = 0; i < 3; ++i)
      all_[i] = hull(all_[i], joints[i]);
  }

  /// Its corners tell what is reached: s rho is a convex function, largest at one of them.
  void addInside(const Box& box)
  {
    addOpen(box);
    for (unsigned corner = 0; corner < 8; ++corner)
    {
      Vector3d point = box.lower;
      for (unsigned axis = 0; axis < 3; ++axis)
        if ((corner >> axis) % 2 == 1)
          point[axis] = box.upper[axis];
      if (const auto rho = inverseKinematics(machine_, point))
        for (int i = 0; i < 3; ++i)
        {
          note(-(*rho)[i], point, at(least_, i));
          note((*rho)[i], point, at(largest_, i));
        }
    }
  }

  bool isEmpty() const { return all_[0].isEmpty(); }
  bool hasInside() const { return least_[0].value > -INF; }

  JointReaches reaches() const
  {
    JointReaches reaches;
    for (int i = 0; i < 3; ++i)
    {
      const Interval& all = at(all_, i);
      at(reaches, i) = { Interval(all.lower(), std::min(all.upper(), valueAt(at(least_, i), i).upper())),
                         Interval(std::max(all.lower(), valueAt(at(largest_, i), i).lower()), all.upper()) };
    }
    return reaches;
  }

private:
  /// The point of the set where a number is largest in floating point.
  struct Extreme
  {
    double value = -INF;
    Vector3d point = Vector3d::Zero();
  };

  static void note(double value, const Vector3d& point, Extreme& extreme)
  {
    if (value > extreme.value)
      extreme = { value, point };
  }

  /// Encloses the joint value there, which is a point of the set.
  Interval valueAt(const Extreme& extreme, int i) const
  {
    const auto there = extreme.value > -INF ? configurationAt(machine_, extreme.point) : std::nullopt;
    return there ? at(there->rho, i) : Interval::entire();
  }

  const Machine& machine_;
  std::array<Interval, 3> all_;  ///< hold all joint values
  std::array<Extreme, 3> least_;
  std::array<Extreme, 3> largest_;
};

bool isNoMatter(const Machine& machine, const Criterion& criterion)
{
  return criterion.joint_limits || !machine.hasJointLimits();
}

JointReaches withoutEnd()
{
  JointReaches reaches;
  reaches.fill({ Interval(-INF, -MOST), Interval(MOST, INF) });
  return reaches;
}

/// Sides of the box about the middle of @p centers that the boxes with all of these centers fill together, rounded.
Vector3d sidesOver(const Box& centers, const Vector3d& sides, bool inward)
{
  Vector3d all;
  const Vector3d middle = centers.center();
  for (int axis = 0; axis < 3; ++axis)
  {
    const Interval below = Interval(middle[axis]) - Interval(centers.lower[axis]);
    const Interval above = Interval(centers.upper[axis]) - Interval(middle[axis]);
    const Interval way = inward ? std::min(below.lower(), above.lower()) : std::max(below.upper(), above.upper());
    const Interval side = Interval(sides[axis]) + Interval(2.0) * way;
    all[axis] = inward ? side.lower() : side.upper();
  }
  return all;
}

/// Over the boxes of all of these centers, which are good: what is reached is known from a little less.
JointReaches reachOverAll(const Machine& machine, const Box& centers, const Vector3d& sides)
{
  return reachOver(machine, *makeBox(sidesOver(centers, sides, true)), centers.center(), 1.0);
}

/// What is never passed from the one, what is reached from the other, which is about a part of it.
JointReaches joined(const JointReaches& all, const JointReaches& part)
{
  JointReaches reaches;
  for (std::size_t i = 0; i < 3; ++i)
  {
    const double least = std::max(all[i].least.lower(), part[i].least.upper());
    const double largest = std::min(all[i].largest.upper(), part[i].largest.lower());
    reaches[i] = { Interval(all[i].least.lower(), least), Interval(largest, all[i].largest.upper()) };
  }
  return reaches;
}

std::optional<JointReaches> coarseReach(const Machine& machine, const Criterion& criterion,
                                        const std::optional<Box>& box)
{
  PavingQuery query;
  query.criterion = criterion;
  query.box = box ? *box : defaultBox(machine, criterion);
  if (!query.box->isValid())
    return std::nullopt;
  query.resolution = FINEST * query.box->maxWidth();
  query.budget.max_boxes = MOST_BOXES;
  query.budget.threads = 1;
  return reachOver(machine, pave(machine, query));
}
}  // namespace

bool isSectionOfAll(const Machine& machine, const Paving& paving)
{
  if (!slidesAlongRails(machine, paving.premises.criterion))
    return false;
  const Box section = defaultBox(machine, paving.premises.criterion);
  return paving.box.lower == section.lower && paving.box.upper == section.upper;
}

std::optional<JointReaches> reachOver(const Machine& machine, const Paving& paving)
{
  SetReach reach(machine);
  const BoxTree tree = paving.tree.coarsened(MOST_BOXES);
  const auto each = [&tree](CellState state, const auto& take) {
    tree.each(state, BLOCK,
              [&take](std::size_t, const std::vector<Box>& boxes) { std::for_each(boxes.begin(), boxes.end(), take); });
  };
  each(CellState::INSIDE, [&reach](const Box& box) { reach.addInside(box); });
  each(CellState::BOUNDARY, [&reach](const Box& box) { reach.addOpen(box); });
  each(CellState::PENDING, [&reach](const Box& box) { reach.addOpen(box); });
  if (reach.isEmpty())
    return std::nullopt;
  if (isSectionOfAll(machine, paving))
    return reach.hasInside() ? withoutEnd() : UNKNOWN;
  return reach.reaches();
}

std::optional<JointReaches> reachOver(const Machine& machine, const Criterion& criterion, const std::optional<Box>& box)
{
  if (isNoMatter(machine, criterion))
    return std::nullopt;
  const auto reaches = coarseReach(machine, criterion, box);
  if (criterion.boundsFactors() || criterion.aspect == Criterion::Aspect::BOTH)
    return reaches;
  Criterion closed = criterion;
  closed.aspect = Criterion::Aspect::BOTH;
  const auto all = coarseReach(machine, closed, box);
  return all ? std::optional(joined(*all, reaches.value_or(UNKNOWN))) : std::nullopt;
}

JointReaches reachOverCenters(const Machine& machine, const Criterion& criterion, const Box& centers,
                              const Vector3d& sides, Share share, const std::vector<Box>& carriers)
{
  const Vector3d hull = sidesOver(centers, sides, false);
  if (share == Share::ALL)
    return joined(reachOver(machine, *makeBox(hull), centers.center(), 1.0), reachOverAll(machine, centers, sides));
  const Box everywhere = boundingBox(enclose(centers.center()) + IntervalVector{ Interval(-0.5, 0.5) * hull[0],
                                                                                 Interval(-0.5, 0.5) * hull[1],
                                                                                 Interval(-0.5, 0.5) * hull[2] });
  const JointReaches all = reachOver(machine, criterion, everywhere).value_or(UNKNOWN);
  std::optional<JointReaches> known;
  for (const Box& part : carriers)
  {
    const JointReaches reaches = reachOverAll(machine, part, sides);
    known = known ? united(*known, reaches) : reaches;
  }
  return joined(all, known.value_or(UNKNOWN));  // a good point of another box belongs to none of these
}

std::optional<JointReaches> reachOver(const Machine& machine, const Criterion& criterion, const Shape& shape,
                                      const Vector3d& center, double size)
{
  if (isNoMatter(machine, criterion))
    return std::nullopt;
  Budget budget;
  budget.max_boxes = MOST_BOXES;
  const ContainmentResult result = checkContainment(BoxTest(machine, criterion), shape, center, size, budget);
  return result.verdict == Containment::INSIDE ? reachOver(machine, shape, center, size) : UNKNOWN;
}
}  // namespace pkm_workspace
