// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "reading.h"

namespace pkm_workspace
{
namespace firmware
{
/// Lines of C without comments, those that end with a backslash joined to the next. A comment or a string without end
/// is a problem.
std::vector<SourceLine> codeLines(const std::vector<SourceLine>& lines, Reading& reading);
}  // namespace firmware
}  // namespace pkm_workspace
