// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdint>
#include <string>

#include "pkm_workspace/common/problems.h"
#include "pkm_workspace/common/processors.h"

namespace pkm_workspace
{
/// Limits that any computation may be given. Values with defaults; validate() tells what is wrong.
struct Budget
{
  static constexpr std::int64_t LEAST_MEMORY = 4096;

  double time_limit = 0.0;                  ///< [s]; 0 = none, otherwise > 0
  double whole_time = 0.0;                  ///< that time_limit is a share of [s]; 0: it is all there is
  std::int64_t max_boxes = 0;               ///< boxes looked at; 0 = no limit
  int threads = processors();               ///< 1 to 1024; no answer depends on it
  std::int64_t max_memory = 0;              ///< that boxes may take [bytes]; at least LEAST_MEMORY, or 0 = no limit
  std::int64_t whole_memory = 0;            ///< that max_memory is a share of [bytes]; 0: it is all there is
  const std::atomic<bool>* stop = nullptr;  ///< when set, the computation ends with the best proven so far

  void validate(Problems& problems) const;
  /// Whether the stop flag is set or @p seconds is past the time limit.
  bool isOver(double seconds) const;
  /// Whether boxes would take more than the memory [bytes].
  bool isFull(std::size_t bytes) const;
  /// The same limits where memory is shared by so many computations at a time.
  Budget sharedBy(std::size_t computations) const;
  /// The same limits with this time, a part of what there is [s], > 0. Where there is no limit, none.
  Budget within(double seconds) const;
  /// The same limits where the time is shared by so many computations, one after the other.
  Budget inTurns(double computations) const { return within(time_limit / computations); }
  /// What has ended a computation by then, as the subject of a sentence: "the time limit of 60 s", "20 s, its share of
  /// the time limit of 60 s"; empty when none of the limits has.
  std::string endedBy(double seconds, std::int64_t boxes, bool out_of_memory = false) const;
};

/// A budget whose time has begun to run. Thread-safe.
class RunningBudget
{
public:
  explicit RunningBudget(const Budget& budget) : budget_(budget), begin_(std::chrono::steady_clock::now()) {}

  /// Since the beginning [s].
  double seconds() const { return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count(); }

  /// Whether the stop flag is set or the time limit is past.
  bool isOver() const { return budget_.isOver(budget_.time_limit > 0.0 ? seconds() : 0.0); }

  /// Whether so many boxes are all that may be looked at.
  bool hasSpent(std::int64_t boxes) const { return budget_.max_boxes > 0 && boxes >= budget_.max_boxes; }
  /// Either.
  bool isOver(std::int64_t boxes) const { return hasSpent(boxes) || isOver(); }

  bool isFull(std::size_t bytes) const { return budget_.isFull(bytes); }

  /// What has ended the computation by now: Budget::endedBy().
  std::string endedBy(std::int64_t boxes, bool out_of_memory = false) const
  {
    return budget_.endedBy(seconds(), boxes, out_of_memory);
  }

  /// What is left after so many boxes, for a part of the computation: a moment and a box at the least, as 0 is no
  /// limit.
  Budget rest(std::int64_t boxes = 0) const
  {
    Budget left = budget_.within(std::max(1e-9, budget_.time_limit - seconds()));
    if (left.max_boxes > 0)
      left.max_boxes = std::max<std::int64_t>(1, left.max_boxes - boxes);
    return left;
  }

private:
  Budget budget_;
  std::chrono::steady_clock::time_point begin_;
};
}  // namespace pkm_workspace
