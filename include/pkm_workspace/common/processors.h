// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace pkm_workspace
{
/// How many threads this machine runs at a time; at least 1.
int processors();
}  // namespace pkm_workspace
