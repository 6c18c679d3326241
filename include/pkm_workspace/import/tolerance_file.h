// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "pkm_workspace/machine/tolerances.h"

namespace pkm_workspace
{
/// Reads the text of a file in YAML: the names of TOLERANCE_KINDS, each with one number or a list.
/// @param name of the file, for places
/// @throws std::invalid_argument naming everything that is wrong, each with file and line
GivenTolerances readToleranceText(const std::string& text, const std::string& name);

/// Reads the file, then as above.
GivenTolerances readToleranceFile(const std::string& path);
}  // namespace pkm_workspace
