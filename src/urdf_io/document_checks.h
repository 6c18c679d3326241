// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "element.h"
#include "notice.h"
#include "pkm_workspace/common/problems.h"

namespace pkm_workspace
{
namespace urdf_io
{
/// Checks each <joint> by itself: its elements, numbers, limits and axis.
void checkJoints(const XMLElement& robot, Problems& problems, std::vector<Notice>& warnings);

/// Checks how links and joints hang together: names, parents, loops, whom a <mimic> follows.
void checkStructure(const XMLElement& robot, Problems& problems);
}  // namespace urdf_io
}  // namespace pkm_workspace
