// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "pkm_workspace/dexterity/verdict.h"
#include "pkm_workspace/region/containment.h"

namespace pkm_workspace
{
/// INSIDE = 1, OUTSIDE = 2, UNDECIDED = 3, as all messages number them.
std::uint8_t constantOf(Containment verdict);
std::uint8_t constantOf(BoxVerdict verdict);
}  // namespace pkm_workspace
