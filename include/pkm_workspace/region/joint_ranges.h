// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

#include "pkm_workspace/machine/machine.h"
#include "pkm_workspace/region/shape.h"

namespace pkm_workspace
{
/// What one joint does while the tool goes through a region (paper, section 4.4). All enclosures [m], of an angle
/// [rad].
struct JointRange
{
  Interval lower;   ///< of the least joint value
  Interval upper;   ///< of the largest joint value
  Interval stroke;  ///< of Delta rho = largest - least
  Interval across;  ///< of Delta f: the range of eta_i, the part of the stroke that serves motion across the rail; 0
                    ///< where there is no rail
};

/// Encloses the joint ranges over c + K(h): to a few roundings over polytopes and balls, to those and 1e-12 h over
/// discs and cylinders. s rho is a convex function of the tool point. It is largest at a vertex of a polytope, over a
/// ball by a closed form, and otherwise on a circle, which is bisected; its least value is where the region comes
/// within the strut's length of the slider first. Some hundreds of looks at the most, where a strut just reaches some
/// thousands.
/// @pre the struts reach all of the region; where one only just does, its eta is enclosed to the root of a rounding
/// @throws std::domain_error when a strut is seen not to reach part of it
std::array<JointRange, 3> jointRanges(const Machine& machine, const Shape& shape, const Eigen::Vector3d& center,
                                      double size);
}  // namespace pkm_workspace
