// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "pkm_workspace/interval/interval.h"

namespace pkm_workspace
{
/// Encloses the mean of a function from 0 to 1 over a set that is known by parts: some belong to it as a whole, of
/// others at its border an unknown share does. Sums up parts as they are added, so that mean() takes no longer than
/// sorting those at the border, however close it is.
class PartialMean
{
public:
  /// What a part at the border takes; others take nothing.
  static constexpr std::size_t BORDER_BYTES = 3 * sizeof(double);

  /// @param measure of the part, >= 0
  /// @param mean encloses the mean of the function over it
  void addWhole(const Interval& measure, const Interval& mean);
  /// @param range encloses the function at all points of the part
  void addBorder(const Interval& measure, const Interval& range);

  /// Encloses the measure of the set.
  Interval measure() const;
  /// Encloses the mean; [0, 1] where the set is not proved to have a measure.
  Interval mean();

private:
  struct Border
  {
    double measure;  ///< at most
    double lower;
    double upper;
    double end(bool below) const { return below ? lower : upper; }
  };
  static_assert(sizeof(Border) == BORDER_BYTES, "what a part at the border takes");

  double bound(bool below);
  double nearly(bool below) const;
  Interval excess(double ratio, bool below) const;

  Interval whole_;  ///< measure of the parts that belong to the set
  Interval sum_;    ///< of their means, each with its measure
  Interval border_measure_;
  Interval values_ = Interval::empty();  ///< of the function
  std::vector<Border> border_;           ///< in bound(): those first that make it worse
};
}  // namespace pkm_workspace
