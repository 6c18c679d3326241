// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>

#include "pkm_workspace/dexterity/box_kernel.h"

namespace pkm_workspace
{
/// Where to look for the singularities of section 3.2 of the paper: at the reachable points of a box, or at all of
/// them. Values with defaults; validate() tells what is wrong.
struct SingularityQuery
{
  SingularityQuery() { budget.max_boxes = 200000; }

  Criterion::Aspect aspect = Criterion::Aspect::BOTH;  ///< which sign of det A counts; 0 counts in each
  bool joint_limits = false;                           ///< whether the joint limits of the machine hold
  /// Joint values with which points are proved to count, each within the limits of the machine [m]; empty: none. For
  /// limits that are themselves enclosures: no singularity is proved beyond these, and none excluded within the limits.
  /// Without it, the limits.
  std::optional<std::array<Interval, 3>> surely_within;
  std::optional<Box> box;  ///< points to look at [m]; without it, the bounds of all reachable points
  /// Whether all points of a box within it count, or none; without it, all count. Called by several threads at a time.
  std::function<BoxVerdict(const Box&)> part;
  double accuracy = 1e-3;  ///< wanted width of each enclosure, relative to its upper end; > 0
  Budget budget;           ///< max_boxes counts for each measure by itself; they share the memory

  void validate(Problems& problems) const;
};

/// What is proved of one measure that is zero at singularities: |eta_i|, or |det A|.
struct SingularityAnswer
{
  enum class Status
  {
    NONE,      ///< the measure is positive at every point that counts, proved
    PROVED,    ///< it is zero at a point that counts, proved
    UNDECIDED  ///< neither is proved within the budget and the precision of doubles
  };

  Status status = Status::UNDECIDED;
  Interval least;              ///< encloses the least value, |eta_i| [m] or |det A| [m^3]; empty where no point counts
  std::optional<Box> box;      ///< where PROVED: a point that counts and is singular lies in it [m]
  std::int64_t boxes = 0;      ///< boxes looked at
  bool out_of_memory = false;  ///< the memory ended the search
};

struct Singularities
{
  std::array<SingularityAnswer, 3> serial;  ///< eta_i = 0: strut i is at right angles to its rail
  SingularityAnswer parallel;               ///< det A = 0: the struts lie in parallel planes
  double seconds = 0.0;
};

/// Bounds |eta_i| and |det A| from below and above by a best-first bisection with affine forms (docs/theory.md).
/// A singularity is proved by continuity: all conditions but the measure's own sign hold on a whole box, and the
/// measure is proved not to be negative at one point of it and not to be positive at another.
/// @throws std::invalid_argument for a query that is not valid or has no bounds, with all reasons
Singularities findSingularities(const Machine& machine, const SingularityQuery& query);
}  // namespace pkm_workspace
