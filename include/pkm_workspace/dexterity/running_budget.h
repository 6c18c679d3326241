// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <string>

#include "pkm_workspace/dexterity/criterion.h"

namespace pkm_workspace
{
/// A budget whose time has begun to run. Thread-safe.
class RunningBudget
{
public:
  explicit RunningBudget(const Budget& budget) : budget_(budget), begin_(std::chrono::steady_clock::now()) {}

  /// Since the beginning [s].
  double seconds() const { return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count(); }

  /// Whether the stop flag is set or the time limit is past.
  bool isOver() const { return budget_.isOver(budget_.time_limit > 0.0 ? seconds() : 0.0); }

  /// The same, or whether so many boxes are all that may be looked at.
  bool isOver(std::int64_t boxes) const { return (budget_.max_boxes > 0 && boxes >= budget_.max_boxes) || isOver(); }

  /// What has ended the computation by now: Budget::endedBy().
  std::string endedBy(std::int64_t boxes) const { return budget_.endedBy(seconds(), boxes); }

  /// What is left after so many boxes, for a part of the computation: a moment and a box at the least, as 0 is no
  /// limit.
  Budget rest(std::int64_t boxes = 0) const
  {
    Budget left = budget_;
    if (left.time_limit > 0.0)
      left.time_limit = std::max(1e-9, left.time_limit - seconds());
    if (left.max_boxes > 0)
      left.max_boxes = std::max<std::int64_t>(1, left.max_boxes - boxes);
    return left;
  }

private:
  Budget budget_;
  std::chrono::steady_clock::time_point begin_;
};
}  // namespace pkm_workspace
