// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "pkm_workspace/paving/paving.h"

namespace pkm_workspace
{
/// Writes pavings to a file from which resume() can go on. The file appears, or replaces the one of that name, only
/// when all of it is on the disk.
/// @throws std::invalid_argument with the file's name and the reason of the system
void savePavings(const std::string& path, const std::vector<Paving>& pavings);

/// Reads what savePavings() wrote: one paving for each query, in order, about the same machine, criterion and box, at
/// any resolution. Their boxes_here and seconds are 0.
/// @throws std::invalid_argument with the file's name and the reason: not such a file, cut, altered, written by another
/// version, or about something else
std::vector<Paving> loadPavings(const std::string& path, const Machine& machine,
                                const std::vector<PavingQuery>& queries);
}  // namespace pkm_workspace
