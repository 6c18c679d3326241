// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/region/largest_cylinder.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "pkm_workspace/common/branch_and_bound.h"
#include "pkm_workspace/region/center_search.h"

namespace pkm_workspace
{
namespace
{
/// Parts of the range of ratios narrower than this are not bisected further.
constexpr double LEAST_PART = 1e-9;

/// Regions of one ratio are searched to this share of the accuracy; the other part is for the ratios in between.
constexpr double SHARE = 0.25;

/// A number whose cube is not below the given one.
double cubeRootAbove(double volume)
{
  if (volume <= 0.0)
    return 0.0;
  double root = std::cbrt(volume) * (1.0 + 0x1p-50);
  while (std::isfinite(root) && !((Interval(root) * sqr(Interval(root))).lower() >= volume))
    root *= 2.0;
  return root;
}

/// Branch and bound over the ratios.
class CylinderSearch : public BranchingDefaults
{
public:
  CylinderSearch(const Machine& machine, const RegionQuery& query)
    : machine_(machine), query_(query), budget_(query.budget)
  {
    best_.shape = query.shape;
    best_.ratio = query.ratio;
  }

  LargestRegion run()
  {
    look(query_.ratio->lower, query_.ratio->upper, std::numeric_limits<double>::infinity());
    branchAndBound(open_, *this, budget_);
    narrow();
    best_.size_upper_bound = heightBound();
    best_.volume_upper_bound = volumeBound();
    best_.seconds = budget_.seconds();
    best_.boxes = boxes_;
    best_.verification_boxes = verification_boxes_;
    best_.out_of_memory = budget_.isFull(bytes(open_.size()));
    conclude(best_, query_.accuracy, budget_.endedBy(boxes_, best_.out_of_memory),
             query_.precision == Precision::DOUBLE);
    return best_;
  }

  /// A range of ratios with an upper bound of volume / pi [m^3].
  struct Part
  {
    double lower;
    double upper;
    double bound;
    bool operator<(const Part& other) const { return bound < other.bound; }
  };

  std::int64_t looks() const { return boxes_; }
  static bool isDivisible(const Part& part) { return part.upper > part.lower * (1.0 + LEAST_PART); }
  /// More than there is where the memory has ended the search of one ratio.
  std::size_t bytes(std::size_t open) const
  {
    return is_full_ ? std::numeric_limits<std::size_t>::max() : 3 * sizeof(Part) * (open + 2);
  }
  /// As conclude() asks for it.
  bool isSettled() const
  {
    return (pi() * Interval(open_.first().bound)).upper() <= best_.shape->volume(target()).lower();
  }

  bool expand(const std::vector<Part>& wave)
  {
    for (const Part& part : wave)
      divide(part);
    return true;
  }

  void tellProgress()
  {
    narrow();
    if (query_.progress && pace_.isDue(budget_.seconds()))
      query_.progress({ best_.size, heightBound(), best_.shape->volume(best_.size).lower(), volumeBound(), boxes_,
                        static_cast<std::int64_t>(open_.size()), budget_.seconds() });
  }

private:
  double target() const { return rounding::add(best_.size, query_.accuracy).lower; }

  /// No cylinder has a larger volume.
  double volumeBound() const { return (pi() * Interval(bracket_.upper())).upper(); }

  /// No cylinder is higher than the one of the least ratio with the largest volume that is still possible.
  double heightBound() const
  {
    return cubeRootAbove((Interval(bracket_.upper()) / sqr(Interval(query_.ratio->lower))).upper());
  }

  static Interval volumeOverPi(double ratio, double height)
  {
    return sqr(Interval(ratio)) * Interval(height) * sqr(Interval(height));
  }

  void divide(const Part& part)
  {
    const double middle = std::sqrt(part.lower) * std::sqrt(part.upper);
    in_hand_ = part.bound;
    look(part.lower, middle, part.bound);
    in_hand_ = 0.0;
    if (budget_.isOver(boxes_) || budget_.isFull(bytes(open_.size())))
      open_.put({ middle, part.upper, part.bound });
    else
      look(middle, part.upper, part.bound);
  }

  /// @param known bound of volume / pi [m^3]
  void look(double lower, double upper, double known)
  {
    const double ratio = std::min(upper, std::max(lower, std::cbrt(lower) * std::cbrt(upper) * std::cbrt(upper)));
    RegionQuery query = query_;
    query.ratio.reset();
    query.shape = cylinderOf(ratio);
    query.accuracy = SHARE * query_.accuracy;
    query.progress = nullptr;
    query.closed = nullptr;
    query.budget = budget_.rest(boxes_);
    const Interval factor = factorOf(lower, ratio, upper);
    LargestRegion region = CenterSearch(machine_, query, uninteresting(factor) - 2.0 * query.accuracy).run();
    boxes_ += region.boxes;
    is_full_ = is_full_ || region.out_of_memory;
    verification_boxes_ += region.verification_boxes;
    const Interval height(region.size_upper_bound);
    open_.put({ lower, upper, std::min(known, (height * sqr(height) * factor).upper()) });
    keep(region, query.shape);
    tellProgress();
  }

  ShapePtr cylinderOf(double ratio) const
  {
    const ShapePtr about_center = makeCylinder(ratio);
    return query_.base_z ? about_center->standing() : about_center;
  }

  /// Takes the region if its volume is the largest so far.
  void keep(const LargestRegion& region, const ShapePtr& shape)
  {
    if (volumeOverPi(shape->halfExtents().per_size.x(), region.size).lower() <=
        volumeOverPi(bestRatio(), best_.size).upper())
      return;
    best_ = region;
    best_.shape = shape;
    best_.ratio = query_.ratio;
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

  double bestRatio() const { return best_.shape->halfExtents().per_size.x(); }

  void narrow()
  {
    bracket_.narrow(0.0, std::max({ volumeOverPi(bestRatio(), best_.size).upper(), in_hand_, open_.first().bound }));
  }

  const Machine& machine_;
  const RegionQuery& query_;
  const RunningBudget budget_;
  LargestRegion best_;
  BestFirst<Part> open_;
  Pace pace_{ query_.progress_period };
  RunningBracket bracket_;  ///< of volume / pi [m^3]
  double in_hand_ = 0.0;    ///< bound of the part of which half is still to be looked at
  bool is_full_ = false;
  std::int64_t boxes_ = 0;
  std::int64_t verification_boxes_ = 0;
};
}  // namespace

LargestRegion findLargestCylinder(const Machine& machine, const RegionQuery& query)
{
  return CylinderSearch(machine, query).run();
}
}  // namespace pkm_workspace
