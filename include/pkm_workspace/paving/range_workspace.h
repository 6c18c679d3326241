// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

#include "pkm_workspace/paving/paving.h"

namespace pkm_workspace
{
/// The three ranges of the joints as section 4.4 of the paper equalises them: each begins at its own least value and
/// has the largest stroke of the three, rounded up [m].
/// @throws std::invalid_argument for ranges that are not bounded
std::array<Interval, 3> equalisedRanges(const std::array<Interval, 3>& ranges);

/// The same machine with these joint limits [m].
Machine withJointLimits(const Machine& machine, const std::array<Interval, 3>& limits);

/// What to measure. Values with defaults; validate() tells what is wrong.
struct RangeQuery
{
  std::array<Interval, 3> ranges;  ///< of the joint values [m]; bounded
  double accuracy = 5e-3;          ///< wanted width of the volume, relative to its upper end; > 0
  Budget budget;                   ///< max_boxes and time_limit are shared by all pavings

  void validate(Problems& problems) const;
};

/// All that the tool can reach with the joints in given ranges and in the machine's working mode (paper, section 4.4).
struct RangeWorkspace
{
  Interval own_aspect;      ///< encloses the volume with the machine's own sign of det A [m^3]
  Interval other_aspect;    ///< and with the other sign [m^3]
  double resolution = 0.0;  ///< of the pavings [m]
  bool complete = false;    ///< the accuracy was met
  double seconds = 0.0;
};

/// Paves it more and more finely until the volume of the machine's own aspect is known to the accuracy or the budget
/// ends. The ranges are used as they are: equalise them first for what the paper does.
/// @throws std::invalid_argument for a query that is not valid, with all reasons
RangeWorkspace workspaceOfRanges(const Machine& machine, const RangeQuery& query);
}  // namespace pkm_workspace
