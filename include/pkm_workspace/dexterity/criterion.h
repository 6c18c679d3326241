// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <cstdint>
#include <string>
#include <vector>

#include "pkm_workspace/interval/box.h"
#include "pkm_workspace/parallel.h"

namespace pkm_workspace
{
/// Collects what is wrong with a user's values; each entry is one sentence with value, unit, range and place.
using Problems = std::vector<std::string>;

/// Throws all problems as one std::invalid_argument, one a line; does nothing when there are none.
void throwProblems(const Problems& problems);

/// Limits that any computation may be given. Values with defaults; validate() tells what is wrong.
struct Budget
{
  double time_limit = 0.0;                  ///< [s]; 0 = none, otherwise > 0
  std::int64_t max_boxes = 0;               ///< boxes looked at; 0 = no limit
  int threads = processors();               ///< 1 to 1024; no answer depends on it
  const std::atomic<bool>* stop = nullptr;  ///< when set, the computation ends with the best proven so far

  void validate(Problems& problems) const;
  /// Whether the stop flag is set or @p seconds is past the time limit.
  bool isOver(double seconds) const;
};

/// Appends one sentence when a box of the user's is not finite or not in order; @p name says which box.
void validateBox(const char* name, const Box& box, Problems& problems);
/// Appends one sentence unless the value is positive and finite.
void validatePositive(const char* name, double value, const char* unit, Problems& problems);

/// What is asked of every point of a region (paper, section 2.1.1). Values with defaults; validate() tells what is
/// wrong.
struct Criterion
{
  /// REACHABLE asks for the struts' reach only; DEXTROUS for bounded velocity transmission factors too.
  enum class Set
  {
    DEXTROUS,
    REACHABLE
  };

  /// Which sign of det A counts: the machine's own, the opposite one, or either of them.
  enum class Aspect
  {
    OWN,
    OTHER,
    BOTH
  };

  Set set = Set::DEXTROUS;
  Aspect aspect = Aspect::OWN;
  double psi_min = 0.5;       ///< least velocity transmission factor, without unit, > 0
  double psi_max = 2.0;       ///< largest velocity transmission factor, without unit, >= psi_min
  bool joint_limits = false;  ///< whether the joint limits of the machine hold too

  /// Appends one sentence for each value that is out of range.
  void validate(Problems& problems) const;
};

/// @return the value itself @throws std::invalid_argument with everything that its validate() finds
template <class Values>
const Values& validated(const Values& values)
{
  Problems problems;
  values.validate(problems);
  throwProblems(problems);
  return values;
}
}  // namespace pkm_workspace
