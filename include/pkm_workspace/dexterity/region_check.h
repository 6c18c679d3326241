// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <functional>

#include "pkm_workspace/dexterity/verdict.h"

namespace pkm_workspace
{
/// One look at a box, or at a point as a box of zero width: a BoxTest, a CharacteristicTest, or a test of one's own.
using BoxClassifier = std::function<BoxVerdict(const Box&)>;

/// How many points of a box are proved to have a property.
enum class Share
{
  ALL,
  NONE,
  SOME,       ///< a point that has it and a point that has not are proved to exist
  UNDECIDED,  ///< the limits ended the proof
};

/// Where a proof by bisection ends.
struct BisectionLimits
{
  double center_width = 1e-2;               ///< boxes of centers no wider than this are not bisected [m]; > 0
  std::int64_t max_centers = 1000000;       ///< boxes of centers; > 0
  double part_width = 1e-5;                 ///< parts of one region no wider than this are not bisected [m]; > 0
  std::int64_t max_parts = 1000000;         ///< parts of one region; > 0
  const std::atomic<bool>* stop = nullptr;  ///< when set, what is left stays undecided
  std::function<void(const Box&)> carried;  ///< if given, told boxes of centers all of which carry a valid region
};

/// M(B) by bisection (paper, section 2.2), on top of single looks: how many points of the box are valid. ALL stands for
/// the paper's 1, NONE for its -1.
Share verifyBox(const BoxClassifier& classify, const Box& box, double part_width, std::int64_t max_parts,
                const std::atomic<bool>* stop = nullptr);

/// G(B, w) (paper, section 2.3): how many points of a box of centers carry a region with edges w whose points are all
/// valid. Of a box of zero width, which is a single center, ALL is the containment of its region and NONE the refusal.
/// @param centers the box B [m]; a side may have zero width
/// @param edges w [m]: (w, w, w) for a cube, (w, w, 0) for a square parallel to the plane xy; >= 0
Share checkCenters(const BoxClassifier& classify, const Box& centers, const Eigen::Vector3d& edges,
                   const BisectionLimits& limits);
}  // namespace pkm_workspace
