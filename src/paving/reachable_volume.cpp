// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/paving/reachable_volume.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "pkm_workspace/common/parallel.h"

namespace pkm_workspace
{
namespace
{
using Form = AffineForm<double>;

/// Slopes below this share of the steepest one count as an error: the formula divides by each slope.
constexpr double FLAT = 1e-3;
/// Boxes that a thread takes at a time.
constexpr std::size_t BOUNDARY_CHUNK = 256;
/// Boxes that are held at a time.
constexpr std::size_t BOUNDARY_BLOCK = 256 * BOUNDARY_CHUNK;

Interval withinShares(const Interval& x)
{
  return { std::min(1.0, std::max(0.0, x.lower())), std::min(1.0, std::max(0.0, x.upper())) };
}

/// The share of a box at which all conditions hold, so far.
struct BoundaryShare
{
  const std::array<Interval, 3> deviation;  ///< of delta from where the box has it
  double lower = 1.0;                       ///< 1 - the sum of what each condition may cut off
  double upper = 1.0;                       ///< the least of what each one may leave

  void scalar(const Subject& /*subject*/, Form form, int /*power*/)
  {
    Interval radius(form.radius);
    for (std::size_t j = 0; j < 3; ++j)
      radius += Interval(std::abs(form.gradient[j])) * deviation[j];
    form.radius = radius.upper();
    if (form.lower() >= 0.0)
      return;
    const Interval error(form.radius);
    const Interval kept = shareAbove(Interval(form.center) - error, form.gradient);
    lower = std::max(0.0, (Interval(lower) - (Interval(1.0) - Interval(kept.lower()))).lower());
    upper = std::min(upper, shareAbove(Interval(form.center) + error, form.gradient).upper());
  }
};

/// A point of the box is in the set exactly when no condition is violated there. The forms of limits and aspect hold
/// where all struts reach only; elsewhere a b_i^2 is negative, whose form always holds.
Interval shareOfSet(const MachineModel<double>& model, const Box& box)
{
  const CenteredBox<double> centered(box);
  BoundaryShare share{ deviations(box, centered) };
  model.visitScalars(model.legs().evaluate(centered), centered, share);
  return { std::min(share.lower, share.upper), share.upper };
}
/// The slopes that are not nearly flat, as magnitudes.
struct Slopes
{
  std::array<Interval, 3> steep;
  std::size_t count = 0;
};

/// With n slopes a_j > 0 it is sum over the corners s of s_1 ... s_n max(0, constant + s . a)^n / (n! 2^n a_1 ... a_n).
Interval shareAbove(const Interval& constant, const Slopes& slopes)
{
  const Interval reach = slopes.steep[0] + slopes.steep[1] + slopes.steep[2];
  if (constant.mignitude() > reach.upper())
    return constant.lower() > 0.0 ? 1.0 : 0.0;
  Interval sum;
  for (unsigned corner = 0; corner < (1U << slopes.count); ++corner)
  {
    Interval height = constant;
    Interval power(1.0);
    for (std::size_t j = 0; j < slopes.count; ++j)
    {
      const bool minus = (corner >> j) % 2 == 1;
      height += minus ? -slopes.steep[j] : slopes.steep[j];
      power = minus ? -power : power;
    }
    const Interval above(std::max(0.0, height.lower()), std::max(0.0, height.upper()));
    for (std::size_t j = 0; j < slopes.count; ++j)
      power *= above;
    sum += power;
  }
  Interval divisor(1.0);
  for (std::size_t j = 0; j < slopes.count; ++j)
    divisor *= Interval(2.0 * static_cast<double>(j + 1)) * slopes.steep[j];
  return withinShares(sum / divisor);
}
}  // namespace

Interval shareAbove(const Interval& constant, const std::array<double, 3>& slopes)
{
  const double steepest = std::max({ std::abs(slopes[0]), std::abs(slopes[1]), std::abs(slopes[2]) });
  Slopes kept;
  Interval start = constant;
  for (const double slope : slopes)
    if (slope == 0.0 || std::abs(slope) < FLAT * steepest)
      start += Interval(-std::abs(slope), std::abs(slope));
    else
      kept.steep[kept.count++] = Interval(std::abs(slope));
  if (kept.count == 0)
    return { start.lower() >= 0.0 ? 1.0 : 0.0, start.upper() >= 0.0 ? 1.0 : 0.0 };
  return hull(shareAbove(Interval(start.lower()), kept), shareAbove(Interval(start.upper()), kept));
}

Interval reachableVolume(const Machine& machine, const Criterion& criterion, const Paving& paving, const Budget& budget)
{
  if (criterion.boundsFactors())
    throw std::invalid_argument("the volume between planes is known for reachable sets only");
  const MachineModel<double> model(machine, criterion);
  const RunningBudget running(budget);
  ThreadPool pool(budget.threads);
  const BoxTree& tree = paving.tree;
  Interval volume = paving.volume_inside;
  tree.each(CellState::BOUNDARY, BOUNDARY_BLOCK, [&](std::size_t level, const std::vector<Box>& boxes) {
    std::vector<Interval> shares((boxes.size() + BOUNDARY_CHUNK - 1) / BOUNDARY_CHUNK);
    pool.forEach(shares.size(), [&](std::size_t chunk) {
      const bool stopped = running.isOver();
      for (std::size_t k = chunk * BOUNDARY_CHUNK; k < std::min(boxes.size(), (chunk + 1) * BOUNDARY_CHUNK); ++k)
        shares[chunk] += stopped ? Interval(0.0, 1.0) : shareOfSet(model, boxes[k]);
    });
    for (const Interval& share : shares)
      volume += share * tree.bisection().volume(level);
  });
  const Interval pending = tree.volume(CellState::PENDING);
  volume += Interval(0.0, pending.upper());
  return intersection(volume, Interval(0.0, paving.volumeUpper()));
}
}  // namespace pkm_workspace
