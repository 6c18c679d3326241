// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <string>

#include "pkm_workspace/region/path_check.h"

namespace pkm_workspace
{
/// Says what is proved about a path, where it first offends, and which limit binds there. "The set" is what the
/// criterion asks for.
/// @param place names a segment by its index: "segment 3"
/// @param stopped_by what has set the stop flag, if it was set
std::string describe(const PathResult& result, const Machine& machine,
                     const std::function<std::string(std::size_t segment)>& place,
                     const std::string& stopped_by = "a request to stop");
}  // namespace pkm_workspace
