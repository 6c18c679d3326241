// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "pkm_workspace/machine/description.h"

namespace pkm_workspace
{
/// A machine file to fill in, in YAML, with comments: as it stands a calibrated linear delta, a tripod or a Delta.
std::string machineFileTemplate(LegDescription::Kind kind = LegDescription::Kind::RAIL);

/// Reads a machine from the text of such a file: its keys are legKeys() and machineKeys() (import/machine_draft.h).
/// @param name of the file, for places
/// @throws std::invalid_argument naming everything that is wrong, each with file and line
MachineDescription readMachineText(const std::string& text, const std::string& name);

/// Reads the file, then as above.
MachineDescription readMachineFile(const std::string& path);
}  // namespace pkm_workspace
