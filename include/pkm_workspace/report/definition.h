// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "pkm_workspace/dexterity/criterion.h"
#include "pkm_workspace/machine/machine.h"

namespace pkm_workspace
{
/// One sentence that says what is asked of a point: "Dextrous: reachable ..., with ... in [0.5, 2]; ...".
std::string definition(const Machine& machine, const Criterion& criterion);
}  // namespace pkm_workspace
