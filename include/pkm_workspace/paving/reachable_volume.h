// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

#include "pkm_workspace/paving/paving.h"

namespace pkm_workspace
{
/// Encloses the share of the cube [-1, 1]^3 at whose points constant + slopes . delta >= 0, from 0 to 1.
Interval shareAbove(const Interval& constant, const std::array<double, 3>& slopes);

/// Encloses the volume [m^3] of the criterion's set within the box of its paving, more closely than the paving by
/// itself: in a box at the border every condition lies between two parallel planes (an affine form, docs/theory.md),
/// and what they cut off is known. The uncertainty goes down with the square of the resolution.
/// @param budget its threads share the work; after its time limit or stop flag boxes at the border count as undecided
/// @throws std::invalid_argument for a set with transmission factors, whose borders are not known as single conditions
Interval reachableVolume(const Machine& machine, const Criterion& criterion, const Paving& paving,
                         const Budget& budget = {});
}  // namespace pkm_workspace
