// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "pkm_workspace/study/machine_family.h"
#include "values.h"

namespace pkm_workspace
{
namespace cli
{
/// The machines of the catalogue that are families, and the parameters of all of them.
Words familyMachines();
Words familyParameters();

/// @throws std::invalid_argument naming the parameters of the machine where this is none of them
MachineFamily familyNamed(const std::string& machine, const std::string& parameter);
}  // namespace cli
}  // namespace pkm_workspace
