// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "pkm_workspace/dexterity/criterion.h"
#include "pkm_workspace/machine/machine.h"

namespace pkm_workspace
{
/// Encloses the eta of a leg at which it can satisfy the criterion [m]: s times L / psi_max to L, or s times 0 to L.
Interval etaRange(const Leg& leg, const Criterion& criterion);
}  // namespace pkm_workspace
