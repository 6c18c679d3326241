// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/region/largest_cylinder.h"

#include <chrono>
#include <cmath>
#include <queue>

#include "pkm_workspace/region/center_search.h"

namespace pkm_workspace
{
namespace
{
/// Parts of the range of ratios narrower than this are not bisected further.
constexpr double LEAST_PART = 1e-9;

/// Regions of one ratio are searched to this share of the accuracy; the other part is for the ratios in between.
constexpr double SHARE = 0.25;

class CylinderSearch
{
public:
  CylinderSearch(const Machine& machine, const RegionQuery& query)
    : machine_(machine), query_(query), begin_(std::chrono::steady_clock::now())
  {
    best_.shape = query.shape;
  }

  LargestRegion run()
  {
    look(query_.ratio->lower, query_.ratio->upper);
    while (upperBound() > target() && open_.top().upper > open_.top().lower * (1.0 + LEAST_PART) && !isOver())
    {
      const Part part = open_.top();
      open_.pop();
      const double middle = std::sqrt(part.lower) * std::sqrt(part.upper);
      look(part.lower, middle);
      look(middle, part.upper);
    }
    best_.size_upper_bound = upperBound();
    best_.seconds = seconds();
    best_.boxes = boxes_;
    best_.verification_boxes = verification_boxes_;
    conclude(best_, query_.accuracy, query_.budget.endedBy(best_.seconds, boxes_));
    return best_;
  }

private:
  /// A range of ratios with an upper bound of volume / pi [m^3].
  struct Part
  {
    double lower;
    double upper;
    double bound;
    bool operator<(const Part& other) const { return bound < other.bound; }
  };

  double seconds() const { return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count(); }
  bool isOver() const { return query_.budget.isOver(seconds()) || (max_boxes_ > 0 && boxes_ >= max_boxes_); }
  double target() const { return rounding::add(best_.size, query_.accuracy).lower; }

  /// The height of a cylinder of the best ratio with the largest volume that is still possible.
  double upperBound() const
  {
    const double ratio = best_.shape->halfExtents().x();
    double height = std::cbrt(open_.top().bound) / std::cbrt(ratio * ratio);
    while (!(volumeOverPi(ratio, height).lower() >= open_.top().bound))
      height *= 1.0 + 1e-15;
    return std::max(best_.size, height);
  }

  static Interval volumeOverPi(double ratio, double height)
  {
    return sqr(Interval(ratio)) * Interval(height) * sqr(Interval(height));
  }

  void look(double lower, double upper)
  {
    const double ratio = std::min(upper, std::max(lower, std::cbrt(lower) * std::cbrt(upper) * std::cbrt(upper)));
    RegionQuery query = query_;
    query.ratio.reset();
    query.shape = makeCylinder(ratio);
    query.accuracy = SHARE * query_.accuracy;
    query.progress = nullptr;
    if (query_.budget.time_limit > 0.0)
      query.budget.time_limit = std::max(1e-3, query_.budget.time_limit - seconds());
    if (max_boxes_ > 0)
      query.budget.max_boxes = std::max<std::int64_t>(1, max_boxes_ - boxes_);
    const Interval factor = factorOf(lower, ratio, upper);
    LargestRegion region = CenterSearch(machine_, query, uninteresting(factor) - 2.0 * query.accuracy).run();
    boxes_ += region.boxes;
    verification_boxes_ += region.verification_boxes;
    const Interval height(region.size_upper_bound);
    open_.push({ lower, upper, (height * sqr(height) * factor).upper() });
    const double best = volumeOverPi(bestRatio(), best_.size).upper();
    if (volumeOverPi(ratio, region.size).lower() > best)
    {
      region.shape = query.shape;
      best_ = region;
    }
    report();
  }

  /// Encloses max(upper^2, ratio^3 / lower).
  static Interval factorOf(double lower, double ratio, double upper)
  {
    const Interval widest = sqr(Interval(upper));
    const Interval flattest = Interval(ratio) * sqr(Interval(ratio)) / Interval(lower);
    return { std::max(widest.lower(), flattest.lower()), std::max(widest.upper(), flattest.upper()) };
  }

  /// A height that keeps a part below the target, in floating point.
  double uninteresting(const Interval& factor) const
  {
    const double volume = volumeOverPi(bestRatio(), target()).lower();
    return std::max(2.0 * SHARE * query_.accuracy, std::cbrt(volume / factor.upper()));
  }

  double bestRatio() const { return best_.shape->halfExtents().x(); }

  void report()
  {
    if (query_.progress)
      query_.progress({ best_.size, upperBound(), boxes_, static_cast<std::int64_t>(open_.size()), seconds() });
  }

  const Machine& machine_;
  const RegionQuery& query_;
  const std::int64_t max_boxes_ = query_.budget.max_boxes;
  std::chrono::steady_clock::time_point begin_;
  LargestRegion best_;
  std::priority_queue<Part> open_;
  std::int64_t boxes_ = 0;
  std::int64_t verification_boxes_ = 0;
};
}  // namespace

LargestRegion findLargestCylinder(const Machine& machine, const RegionQuery& query)
{
  return CylinderSearch(machine, query).run();
}
}  // namespace pkm_workspace
