// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "pkm_workspace/region/guarantee.h"

namespace pkm_workspace
{
/// What is proved, and what binds where: "Proved for every point: ... is at least 0.71 m/s; near (0, 0, 0.7) m it is
/// ...".
std::string describe(const Guarantee& guarantee, const Machine& machine, const Budget& budget);
}  // namespace pkm_workspace
