// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "path_looks.h"

namespace pkm_workspace
{
/// Encloses how fast the joints go along one segment, whether it is good or not: its pieces that allow the least tool
/// speed are divided until that is known to a thousandth of itself.
class RateSearch
{
public:
  /// @param pieces that the segment has at first
  RateSearch(const Way& way, std::size_t pieces, PathLooks& looks, const PathQuery& query);

  PathRates run();

private:
  struct Part
  {
    double first, last;
    LargestFeed feed;                    ///< that all of it allows, and one of its points
    std::array<double, 3> acceleration;  ///< upper bounds, for a tool speed of 1 m/s
  };

  static bool isFaster(const Part& one, const Part& other) { return one.feed.lower > other.feed.lower; }
  void add(double first, double last, std::size_t parts);
  Part partOf(const WaySpan& span, const PieceRates& rates) const;
  bool isDone() const;
  PathRates result() const;

  const Way& way_;
  const std::size_t pieces_;
  PathLooks& looks_;
  const PathQuery& query_;
  std::vector<Part> parts_;  ///< a heap, the slowest part first
  double upper_ = INF;       ///< of the feed
};

/// Takes in what is true of a part of the path.
void merge(const PathRates& part, PathRates& sum);
/// What merge() begins with.
PathRates noRates();
}  // namespace pkm_workspace
