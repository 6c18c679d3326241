// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "output.h"
#include "pkm_workspace/study/comparison.h"

namespace pkm_workspace
{
namespace cli
{
/// "none", "undecided" or "at (x, y, z) m" for one kind of singularity.
std::string verdictOn(const SingularityAnswer& answer);

/// exists: null when undecided; least; box.
Json toJson(const SingularityAnswer& answer);
/// As bracket(), also where an end is not known.
std::string describe(const Interval& value);
}  // namespace cli
}  // namespace pkm_workspace
