// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "pkm_workspace/machine/zone.h"
#include "scene.h"

namespace pkm_workspace
{
/// Adds a body for each zone, in namespace "zones": red to keep out of, green to keep within; without what the tool's
/// radius adds. What has no end is drawn as long as 2 of @p length [m].
void addZones(const std::vector<Zone>& zones, double length, Scene& scene);
}  // namespace pkm_workspace
