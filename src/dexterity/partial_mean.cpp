// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/dexterity/partial_mean.h"

#include <algorithm>

namespace pkm_workspace
{
namespace
{
/// How far outside a floating-point estimate a bound is tried first, and how much farther each time after that.
constexpr double FIRST_STEP = 1e-12;
constexpr double STEPS = 10.0;
}  // namespace

void PartialMean::addWhole(const Interval& measure, const Interval& mean)
{
  whole_ += measure;
  sum_ += measure * mean;
  values_ = hull(values_, mean);
}

void PartialMean::addBorder(const Interval& measure, const Interval& range)
{
  border_measure_ += measure;
  border_.push_back({ measure.upper(), range.lower(), range.upper() });
  values_ = hull(values_, range);
}

Interval PartialMean::measure() const
{
  return { whole_.lower(), (whole_ + border_measure_).upper() };
}

Interval PartialMean::mean()
{
  if (!whole_.certainlyPositive())
    return { 0.0, 1.0 };
  const double lower = bound(true);
  return intersection(Interval(lower, bound(false)), values_);
}

/// The mean is at least a ratio exactly where the excess over it is not negative, whatever counts at the border; for
/// the other side the other way round.
double PartialMean::bound(bool below)
{
  std::sort(border_.begin(), border_.end(),
            [below](const Border& a, const Border& b) { return below ? a.lower < b.lower : a.upper > b.upper; });
  double ratio = nearly(below);
  const double sign = below ? -1.0 : 1.0;
  for (double step = FIRST_STEP; below ? ratio > 0.0 : ratio < 1.0; step *= STEPS)
  {
    ratio += sign * step;
    const Interval found = excess(ratio, below);
    if (below ? found.lower() >= 0.0 : found.upper() <= 0.0)
      return std::min(1.0, std::max(0.0, ratio));
  }
  return below ? 0.0 : 1.0;
}

/// In floating point: the mean is at its worst with all of the border that is worse than it.
double PartialMean::nearly(bool below) const
{
  double measure = whole_.mid();
  double sum = below ? sum_.lower() : sum_.upper();
  for (const Border& part : border_)
  {
    if (below ? part.lower * measure >= sum : part.upper * measure <= sum)
      break;
    measure += part.measure;
    sum += part.measure * part.end(below);
  }
  return sum / measure;
}

/// Encloses the sum over the set of (value - ratio) dV, with the parts at the border that make it worse for a bound
/// from @p below.
Interval PartialMean::excess(double ratio, bool below) const
{
  Interval sum = sum_ - Interval(ratio) * whole_;
  for (const Border& part : border_)
  {
    if (below ? part.lower >= ratio : part.upper <= ratio)
      break;
    sum += Interval(part.measure) * (Interval(part.end(below)) - Interval(ratio));
  }
  return sum;
}
}  // namespace pkm_workspace
