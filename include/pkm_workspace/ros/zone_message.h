// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <XmlRpcValue.h>
#include <pkm_workspace/ToolZone.h>

#include <vector>

#include "pkm_workspace/machine/zone.h"

namespace pkm_workspace
{
/// Reads a zone; that of an answer is in_root where its numbers are in the frame of the root link.
/// @throws std::invalid_argument naming everything that is wrong: unknown numbers, fields without effect or missing
Zone fromMessage(const ToolZone& message);
ToolZone toMessage(const Zone& zone);

/// Reads a list of maps with kind, name and the keys of zoneKeys(), in the frame of the root link.
/// @throws std::invalid_argument naming everything that is wrong
std::vector<Zone> readZones(Zone::Use use, const XmlRpc::XmlRpcValue& list);
}  // namespace pkm_workspace
