// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "pkm_workspace/region/containment.h"

namespace pkm_workspace
{
/// Why a proof ended UNDECIDED, as a sentence without its full stop: "the limit of 1000 boxes ended the proof".
/// @param budget that it was given
std::string whyUndecided(const ContainmentResult& result, const Budget& budget);
}  // namespace pkm_workspace
