// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "pkm_workspace/region/largest_region.h"
#include "pkm_workspace/study/machine_family.h"

namespace pkm_workspace
{
/// How far a study has come; sizes as in LargestRegion.
struct StudyProgress
{
  double size = 0.0;
  double parameter = 0.0;  ///< of the machine with that size
  double size_upper_bound = 0.0;
  std::size_t parts_open = 0;
  double seconds = 0.0;
};

/// Which machine of a family has the largest region? Values with defaults; validate() tells what is wrong.
struct StudyQuery
{
  MachineFamily family;
  Interval range;      ///< of the parameter [the family's unit]
  RegionQuery region;  ///< its accuracy and budget are for the whole study; its progress is not called
  std::function<void(const StudyProgress&)> progress;  ///< called now and then, if given
  double progress_period = PROGRESS_PERIOD;            ///< [s], >= 0

  void validate(Problems& problems) const;
};

/// Some of the parameters.
struct StudyPart
{
  Interval parameters;
  double size_upper_bound = 0.0;  ///< certified: none of their machines has a larger region
};

struct BestParameter
{
  Interval range;          ///< of the parameter, as asked for
  double parameter = 0.0;  ///< of the best machine that was found; meaningless when the size is 0
  /// The region of that machine, with the upper bound of the sizes of all machines; status and message say how close
  /// the two are.
  LargestRegion region;
  /// What is left of the range: no machine with another parameter has a region larger than region.size. Ascending,
  /// apart from each other.
  std::vector<StudyPart> candidates;
};

/// Maximises the size of the largest region over the parameter, by branch and bound: the family's machine for a part of
/// the range encloses all the machines within, so that the upper bound of its regions holds for all of them; the
/// largest region so far bounds from below. The size may jump at some parameter; the parts get small there.
/// @throws std::invalid_argument for a query that is not valid or has no bounded answer, with all reasons
BestParameter findBestParameter(const StudyQuery& query);

/// The same for each of so many equal parts of the range: how the size goes with the parameter, with its jumps. The
/// budget is shared evenly; the family is asked by several threads at a time.
/// @param count of the parts, >= 1 @param whole what findBestParameter() answered: it bounds the parts, too
/// @throws std::invalid_argument as above
std::vector<BestParameter> bestOfParts(const StudyQuery& query, int count, const BestParameter& whole);
}  // namespace pkm_workspace
