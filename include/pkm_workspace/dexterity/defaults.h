// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "pkm_workspace/dexterity/criterion.h"
#include "pkm_workspace/machine/machine.h"

namespace pkm_workspace
{
/// What the command, the node and its requests ask for where nobody says otherwise.

/// A Criterion's own values, but within the joint limits. Of a machine that has none, that asks for nothing more.
Criterion defaultCriterion();

/// Where all points of a region count: nothing but that the struts reach them, in whatever aspect.
Criterion anyReachable();

/// Of a size: a thousandth of the longest strut, to one digit [m].
double defaultAccuracy(const Machine& machine);

/// Of a paving of the box: a twentieth of the longest strut, of a flat box a fortieth [m].
double defaultResolution(const Machine& machine, const Box& box);

/// Boxes that are looked at for a verdict on a region before it stays undecided.
constexpr std::int64_t DEFAULT_CHECK_BOXES = 1000000;

/// The most that boxes may take [bytes].
constexpr std::int64_t DEFAULT_MEMORY = std::int64_t(1) << 30;
}  // namespace pkm_workspace
