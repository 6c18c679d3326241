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
  Interval lower;         ///< of the least joint value
  Interval upper;         ///< of the largest joint value
  Interval stroke;        ///< of Delta rho = largest - least
  Interval across;        ///< of Delta f: the range of eta_i, the part of the stroke that serves motion across the rail
};

/// Encloses the joint ranges over c + h K.
/// @pre the region is reachable (for instance proved INSIDE) @throws std::domain_error otherwise
/// @param accuracy width at which the enclosures of lower and upper are narrow enough [m]; > 0
std::array<JointRange, 3> jointRanges(const Machine& machine, const Shape& shape, const Eigen::Vector3d& center, double size,
                                      double accuracy);
}  // namespace pkm_workspace
