// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <map>
#include <string>
#include <vector>

#include "pkm_workspace/machine/zone.h"

namespace pkm_workspace
{
/// What a zone is made of where people write it: a key of files, parameters and JSON, and its numbers.
struct ZoneKey
{
  const char* name;
  const char* field;            ///< of ToolZone, which has it
  const char* values;           ///< names of its numbers, for help
  std::vector<ZoneKind> kinds;  ///< of the zones that have it
  bool is_required;             ///< by them
  std::vector<double*> (*numbers)(Zone& zone);
};

/// In the order in which options give those that are required.
const std::vector<ZoneKey>& zoneKeys();

/// A zone as it is written: its keys, with as many numbers as were given.
using ZoneNumbers = std::map<std::string, std::vector<double>>;

/// How refusals name what a zone has.
enum class ZoneNames
{
  KEYS,   ///< of files and parameters
  FIELDS  ///< of messages, where 0 is what was not given
};

/// @throws std::invalid_argument naming everything that is wrong: an unknown kind, keys that are missing or of other
/// kinds, another count of numbers
Zone readZone(Zone::Use use, const std::string& kind, const std::string& name, const ZoneNumbers& numbers,
              ZoneNames names = ZoneNames::KEYS);

/// From the words of an option: the kind, and the numbers of all keys that it requires. @throws as above
Zone readZone(Zone::Use use, const std::vector<std::string>& words);

/// The other way: all keys that a zone has, but for those that say what is so by default.
ZoneNumbers numbersOf(const Zone& zone);

/// "box X Y Z SX SY SZ, cylinder X Y Z RADIUS HEIGHT, ...": what an option takes.
std::string zoneWords();
}  // namespace pkm_workspace
