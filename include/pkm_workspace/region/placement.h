// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <optional>

#include "pkm_workspace/region/largest_region.h"
#include "pkm_workspace/region/path_body.h"

namespace pkm_workspace
{
/// What is to be placed, and where. Values with defaults; validate() tells what is wrong.
struct PlacementQuery
{
  std::shared_ptr<const Workpiece> workpiece;
  Criterion criterion;
  JointRateLimits limits = {};                          ///< that joints keep at the speeds of the moves
  std::optional<Box> translations;                      ///< that may be chosen [m]; a side may have zero width
  double accuracy = 1e-3;                               ///< wanted: upper bound - margin [m], > 0
  bool wants_scale = false;                             ///< whether the largest scale is asked for
  double scale_accuracy = 1e-3;                         ///< wanted: of its bracket, > 0
  Budget budget;                                        ///< of the scale as much again
  std::function<void(const RegionProgress&)> progress;  ///< called now and then, if given
  double progress_period = PROGRESS_PERIOD;             ///< [s], >= 0

  void validate(Problems& problems) const;
};

/// How much larger the workpiece could be, scaled about its reference and placed anew. Good at one place are all points
/// of it at every scale from the least one to the largest; limits on rates are left aside.
struct LargestScale
{
  double least = 1.0;                                     ///< 1, or 0 where no place for it as it is was proved
  double scale = 0.0;                                     ///< certified; 0 where nothing is
  Eigen::Vector3d translation = Eigen::Vector3d::Zero();  ///< [m]; meaningless then
  double upper_bound =
      INF;               ///< certified: for no translation are all points good at every scale from the least to more
  LargestRegion search;  ///< what the search says of itself
};

/// Where a workpiece is good with the largest margin.
struct Placement
{
  Box translations;  ///< looked among [m]; not valid where no translation brings it into the bounds of the set
  /// The center is the translation, the size the margin [m]: each point of the workpiece is good, moved by up to it
  /// along each axis, and keeps the limits on rates there. NONE with an upper bound of 0: it is good nowhere.
  LargestRegion found;
  std::optional<LargestScale> largest = {};  ///< where it was asked for
};

/// Finds a translation with the largest margin, with a certified upper bound on the margins of all translations.
/// @throws std::invalid_argument for a query that is not valid or has no bounded answer
Placement findPlacement(const Machine& machine, const PlacementQuery& query);
}  // namespace pkm_workspace
