// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "pkm_workspace/machine/zone.h"

namespace pkm_workspace
{
/// Zones to keep in and out of, with the tool's radius.
struct ZoneFile
{
  std::vector<Zone> zones;
  double tool_radius = 0.0;  ///< [m]; 0 where the file has none
};

/// Reads the text of a file in YAML: tool_radius, and lists keep_in and keep_out of maps with kind, name and the keys
/// of zoneKeys().
/// @param name of the file, for places
/// @throws std::invalid_argument naming everything that is wrong, each with file and line
ZoneFile readZoneText(const std::string& text, const std::string& name);

/// Reads the file, then as above.
ZoneFile readZoneFile(const std::string& path);
}  // namespace pkm_workspace
