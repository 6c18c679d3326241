// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "leg_chain.h"
#include "pkm_workspace/common/problems.h"

namespace pkm_workspace
{
namespace urdf_io
{
/// What one leg contributes to the machine: enclosures in the slider's frame, all joints at zero.
struct LegGeometry
{
  IntervalVector slider_point;  ///< A: where the passive axes at the slider meet [m]
  IntervalVector strut;         ///< vector from A to B, where those of the wrist meet [m]
  Interval length;              ///< L = |AB| [m]
  IntervalVector platform;      ///< b: B seen from the tool point, in all orientations that the wrist leaves [m]
  double misfit = 0.0;          ///< upper bound of how far the axes are from meeting, the worse end [m]
};

/// Measures the leg that leads to @p station, a link on the platform. Where the axes meet or repeat only nearly, the
/// enclosures hold all positions that A and B, as points of an ideal leg, then take.
/// @param problems gets what is out of tolerance
LegGeometry measureLeg(const Station& station, Problems& problems);

/// The two passive joints at the slider that are best at turning the strut, and how far the leg is from letting it
/// reach all directions: the larger cosine between the two axes, and between the second axis and the strut. 0 is ideal.
struct HingePair
{
  std::size_t first;
  std::size_t second;
  double defect;
};
HingePair bestPair(const std::vector<Hinge>& at_slider, const IntervalVector& strut);
}  // namespace urdf_io
}  // namespace pkm_workspace
