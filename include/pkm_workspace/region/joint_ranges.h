// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

#include "pkm_workspace/machine/machine.h"
#include "pkm_workspace/region/shape.h"

namespace pkm_workspace
{
/// What one rail does while the tool goes through a region (paper, section 4.4). All enclosures [m].
struct JointRange
{
  Interval lower;   ///< of the least joint value
  Interval upper;   ///< of the largest joint value
  Interval stroke;  ///< of Delta rho = largest - least
  Interval across;  ///< of Delta f: the range of eta_i, the part of the stroke that serves motion across the rail
};

/// Encloses the joint ranges over c + h K, to a few roundings. The height sqrt(L^2 - |q|^2) of a strut along its rail
/// is a concave function of the tool point, so that one end of each range is taken at a vertex of the polytope K, and
/// the other one is bounded by a tangent plane.
/// @throws std::domain_error when a strut does not reach all of the region, or only just
std::array<JointRange, 3> jointRanges(const Machine& machine, const Shape& shape, const Eigen::Vector3d& center,
                                      double size);
}  // namespace pkm_workspace
