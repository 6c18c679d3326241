// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/region/turned_region.h"

#include <algorithm>
#include <stdexcept>

#include "pkm_workspace/interval/turning.h"
#include "pkm_workspace/machine/frame.h"
#include "pkm_workspace/machine/rails.h"
#include "pkm_workspace/region/containment.h"
#include "pkm_workspace/region/region_height.h"

namespace pkm_workspace
{
namespace
{
/// Parts of half a turn: the narrower, the closer leastWidth() is.
constexpr int SECTORS = 64;
/// A region that is turned all the way round, to this [rad], is tried as one that is not turned; with so many boxes.
constexpr double NEARLY_ALL_ROUND = 1e-6;
constexpr std::int64_t PROOF_BOXES = 100000;

/// After how many quarters of a turn the shape is the same again.
double quartersOf(const Shape& shape)
{
  const GrowingVector lower = shape.lower();
  const GrowingVector upper = shape.upper();
  const auto equal = [](const GrowingVector& a, int j, const GrowingVector& b, int k, double sign) {
    return a.fixed[j] == sign * b.fixed[k] && a.per_size[j] == sign * b.per_size[k];
  };
  if (!shape.isBox() || !equal(lower, 0, upper, 0, -1.0) || !equal(lower, 1, upper, 1, -1.0))
    return 4.0;
  return equal(upper, 0, upper, 1, 1.0) ? 1.0 : 2.0;
}
}  // namespace

bool canTurn(const std::string& kind)
{
  return kind == "cube" || kind == "square" || kind == "box" || kind == "polytope";
}

void setTurned(RegionQuery& query)
{
  if (!canTurn(query.shape->kind()))
    throw std::invalid_argument("turned is for a square, cube, box or polytope: a " + query.shape->kind() +
                                " turned about the vertical is the same " + query.shape->kind());
  query.angles = Interval(0.0, (Interval(0.5 * quartersOf(*query.shape)) * pi()).upper());
}

SeenFrom seenFrom(const Machine& machine, const Criterion& criterion, const Eigen::Vector3d& center, double angle)
{
  const Interval around = Interval(angle) * Interval(1.0 - 0x1p-50, 1.0 + 0x1p-50);
  const IntervalMatrix rotation = rotationsAboutZ(-around);
  const EnclosedMotion motion{ rotation, rotation * IntervalVector{ -center.x(), -center.y(), 0.0 } };
  SeenFrom seen{ machineInFrame(machine, motion), criterion };
  for (Zone& zone : seen.criterion.zones)
    zone.view = motion;
  return seen;
}

namespace
{
bool isProvedAt(double angle, const Machine& machine, const RegionQuery& query, const RunningBudget& budget,
                LargestRegion& region)
{
  Budget left = budget.rest();
  left.max_boxes = PROOF_BOXES;
  const SeenFrom seen = seenFrom(machine, query.criterion, region.center, angle);
  const BoxTest test(seen.machine, seen.criterion, query.precision);
  const Eigen::Vector3d center(0.0, 0.0, region.center.z());
  const ContainmentResult proof = checkContainment(test, *region.shape, center, region.size, left);
  region.verification_boxes += proof.boxes;
  return proof.verdict == Containment::INSIDE;
}
}  // namespace

void settleTurned(const Machine& machine, const RegionQuery& query, const RunningBudget& budget, LargestRegion& region)
{
  if (!(region.size > 0.0))
    return;
  if (query.angles.upper() - *region.angle < NEARLY_ALL_ROUND && isProvedAt(0.0, machine, query, budget, region))
    region.angle = 0.0;
  const SeenFrom there = seenFrom(machine, query.criterion, region.center, *region.angle);
  const Machine& seen = there.machine;
  const Eigen::Vector3d foot(region.center.x(), region.center.y(), 0.0);
  region.center -= foot;
  RegionQuery from_there = query;
  from_there.angles = 0.0;
  from_there.criterion = there.criterion;
  for (int k = 0; from_there.search_box && k < 2; ++k)
    from_there.search_box->lower[k] = from_there.search_box->upper[k] = 0.0;
  if (!seen.hasParallelRails() || abs(directionOfRails(seen)[2]) == Interval(1.0))
    settleHeight(seen, from_there, budget, region);
  else
    region.joint_ranges = jointRanges(seen, *region.shape, region.center, region.size);
  region.center += foot;
}

std::vector<IntervalMatrix> halfTurns()
{
  std::vector<IntervalMatrix> turns;
  for (int k = 0; k < SECTORS; ++k)
    turns.push_back(rotationsAboutZ(pi() * Interval(k, k + 1) * Interval(1.0 / SECTORS)));
  return turns;
}

Growing<double> leastWidth(const Shape& shape)
{
  Growing<double> least{ INF, INF };
  for (const IntervalMatrix& turn : halfTurns())
  {
    const Growing<Interval> ahead = shape.support({ turn[0][0], turn[1][0], 0.0 });
    const Growing<Interval> behind = shape.support({ -turn[0][0], -turn[1][0], 0.0 });
    least.fixed = std::min(least.fixed, (ahead.fixed + behind.fixed).lower());
    least.per_size = std::min(least.per_size, (ahead.per_size + behind.per_size).lower());
  }
  return { std::max(0.0, least.fixed), std::max(0.0, least.per_size) };
}
}  // namespace pkm_workspace
