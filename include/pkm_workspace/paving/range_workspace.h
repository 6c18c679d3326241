// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

#include "pkm_workspace/paving/paving.h"

namespace pkm_workspace
{
/// Ranges of the three joints [m] whose ends may be known by enclosures only.
struct JointIntervals
{
  JointIntervals() = default;
  /// Known exactly.
  JointIntervals(const std::array<Interval, 3>& exact) : outer(exact), inner(exact) {}

  std::array<Interval, 3> outer;  ///< hold the ranges: what is absent within these is absent within the ranges
  std::array<Interval, 3> inner;  ///< lie in the ranges, empty where no part is known: what exists within these exists
};

/// The three ranges of the joints as section 4.4 of the paper equalises them: each begins at its own least value and
/// has the largest stroke of the three.
/// @param least encloses the least value of each joint [m] @param strokes enclose the strokes [m]
/// @throws std::invalid_argument for enclosures that are not bounded
JointIntervals equalisedRanges(const std::array<Interval, 3>& least, const std::array<Interval, 3>& strokes);

/// The same machine with these joint limits [m].
Machine withJointLimits(const Machine& machine, const std::array<Interval, 3>& limits);

/// What to measure. Values with defaults; validate() tells what is wrong.
struct RangeQuery
{
  JointIntervals ranges;                              ///< of the joint values [m]; bounded
  double accuracy = 5e-3;                             ///< wanted width of the volume, relative to its upper end; > 0
  Budget budget;                                      ///< time_limit is shared by the aspects, max_boxes is for each
  Criterion::Aspect aspect = Criterion::Aspect::OWN;  ///< whose volume the accuracy is about: OWN or OTHER

  void validate(Problems& problems) const;
};

/// All that the tool can reach with the joints in given ranges and in the machine's working mode (paper, section 4.4).
struct RangeWorkspace
{
  Interval own_aspect;    ///< encloses the volume with the machine's own sign of det A [m^3]
  Interval other_aspect;  ///< and with the other sign [m^3]
  bool complete = false;  ///< the accuracy was met
  double seconds = 0.0;
};

/// Paves it, and divides the boxes at the border until the volume of the aspect in question is known to the accuracy or
/// the budget ends; the other one is known as closely, in m^3. Paved are the outer ranges; what they hold beyond the
/// inner ones goes off the lower bounds: a length w of a joint's values takes at most the volume pi L^2 w. Equalise the
/// ranges first for what the paper does.
/// @throws std::invalid_argument for a query that is not valid, with all reasons
RangeWorkspace workspaceOfRanges(const Machine& machine, const RangeQuery& query);
}  // namespace pkm_workspace
