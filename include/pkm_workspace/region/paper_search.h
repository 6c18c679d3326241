// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstdint>

#include "pkm_workspace/dexterity/region_check.h"

namespace pkm_workspace
{
/// What the algorithm of the paper's section 2.4 is given. Values with defaults; validate() tells what is wrong.
struct PaperQuery
{
  enum class Shape
  {
    CUBE,
    SQUARE  ///< parallel to the plane xy, no thickness in z
  };

  Shape shape = Shape::CUBE;
  double accuracy = 0.1;                            ///< alpha [m]; > 0
  Box centers;                                      ///< B_0, contains the workspace [m]; a side may have zero width
  Eigen::Vector3d start = Eigen::Vector3d::Zero();  ///< in place of (0, 0, 0): the zero configuration [m], inside B_0
  double start_size = 0.0;          ///< the incremental way: w of a coarser run, with its center as start [m]; >= 0
  std::int64_t list_size = 1000;    ///< N: below N / 2 open boxes the list grows at its end, else in place; > 0
  std::int64_t max_boxes = 100000;  ///< boxes of the list processed at the most; > 0

  void validate(Problems& problems) const;
};

struct PaperResult
{
  enum class Ending
  {
    EXHAUSTED,  ///< the list is empty: w + alpha is certified
    BUDGET,     ///< max_boxes
    PRECISION,  ///< a box of a single point was left undecided: alpha is below what doubles can settle
  };

  Ending ending = Ending::BUDGET;
  double size = 0.0;  ///< w, certified: a region of this edge is valid [m]; 0: none found
  Eigen::Vector3d center = Eigen::Vector3d::Zero();  ///< its center [m]
  double size_upper_bound = 0.0;  ///< with EXHAUSTED: w + alpha; no region of this edge has its center in B_0 [m]
  std::int64_t boxes = 0;         ///< boxes of the list processed
  std::int64_t looks = 0;         ///< boxes and points classified
  std::int64_t longest_list = 0;  ///< most boxes open at once
};

/// The largest cube or square of valid points by the paper's section 2.4, with the repairs that the project's design
/// names: a slow way to the answer of findLargestRegion() that shares none of its steps. w is the edge throughout.
/// @param classify verdicts on the workspace, those of a CharacteristicTest for instance
/// @throws std::invalid_argument for a query that is not valid, with all reasons
PaperResult findLargestByPaper(const BoxClassifier& classify, const PaperQuery& query);
}  // namespace pkm_workspace
