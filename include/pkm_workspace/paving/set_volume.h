// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <functional>

#include "pkm_workspace/paving/paving.h"

namespace pkm_workspace
{
/// How closely a volume is wanted. Values with defaults; validate() tells what is wrong.
struct VolumeQuery
{
  double accuracy = 1.0;  ///< wanted width of the bracket, relative to its upper end, > 0; with 1 no box is divided
  double width = 0.0;     ///< or this width, where it is more [m^dimension]
  Budget budget;          ///< of boxes looked at, time and memory
  /// Called now and then, if given; what it tells counts the parts of boxes, too.
  std::function<void(const PavingProgress&)> progress;
  double progress_period = PROGRESS_PERIOD;  ///< [s], >= 0

  void validate(Problems& problems) const;
};

/// The volume of a set within a box; of flat boxes the area, of lines the length.
struct SetVolume
{
  Interval volume;         ///< encloses it [m^dimension]
  std::int64_t boxes = 0;  ///< boxes looked at
  bool complete = false;   ///< the accuracy was met
  double seconds = 0.0;
};

/// Encloses the volume of the criterion's set within the box of its paving, by parts of boxes: in a box at the border
/// every condition lies between two parallel planes (docs/volumes.md), and what they cut off is known. The uncertainty
/// goes down with the square of the width of the boxes. Divides the boxes that leave most of it open, until the
/// accuracy is met or the budget ends.
/// @throws std::invalid_argument for a query that is not valid, with all reasons
SetVolume setVolume(const Machine& machine, const Paving& paving, const VolumeQuery& query);
}  // namespace pkm_workspace
