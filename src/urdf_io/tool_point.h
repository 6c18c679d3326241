// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "closure.h"

namespace pkm_workspace
{
namespace urdf_io
{
/// Where the link is that was named as the tool point, seen from where the legs meet, in the root frame [m].
/// @throws std::invalid_argument when it is not fixed to the platform
IntervalVector toolAt(const std::string& link, const Model& model, const std::array<Rail, 3>& rails,
                      const Stations& stations, const Closure& closure);

/// Ends of the platform elsewhere than where the legs meet: a spindle, a nozzle.
std::vector<Beyond> linksBeyond(const Model& model, const Stations& stations, const Closure& closure);
}  // namespace urdf_io
}  // namespace pkm_workspace
