// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace pkm_workspace
{
/// @return the version of the library, as in package.xml
const char* version();
}  // namespace pkm_workspace
