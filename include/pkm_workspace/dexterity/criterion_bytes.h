// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "pkm_workspace/common/byte_order.h"
#include "pkm_workspace/dexterity/criterion.h"

namespace pkm_workspace
{
/// The same question with the values of a Criterion() where nothing depends on them. What is not asked for makes no
/// difference to the bytes, which operator== compares.
Criterion canonical(const Criterion& criterion);

/// Puts the canonical criterion: set, aspect, the bounds in their order, joint limits; what counts for machines with
/// motors and tolerances only where it is asked for.
void put(const Criterion& criterion, ByteWriter& writer);
/// Takes it out again. @throws std::runtime_error for what put() does not write, but numbers are not looked at
Criterion takeCriterion(ByteReader& reader);
}  // namespace pkm_workspace
