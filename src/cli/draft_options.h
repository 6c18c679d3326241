// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <string>

#include "pkm_workspace/import/machine_draft.h"
#include "values.h"

namespace pkm_workspace
{
namespace cli
{
/// Whether any machine may have it.
inline bool isDrive(const DraftKey& key)
{
  return key.kind == DraftKey::Kind::SPEED || key.kind == DraftKey::Kind::FORCE;
}

/// "rail-radius" of "rail_radius".
inline std::string optionName(const DraftKey& key)
{
  std::string name = key.name;
  std::replace(name.begin(), name.end(), '_', '-');
  return name;
}

inline Quantity quantityOfKey(const DraftKey& key)
{
  const std::string name = key.name;
  if (name == "length" || name == "rail_radius" || name == "base_radius" || name == "crank" ||
      name == "platform_radius")
    return LENGTH_POSITIVE;
  if (isDrive(key))
    return { key.kind == DraftKey::Kind::SPEED ? "m/s, rad/s" : "N, N m", 0.0, false };
  if (key.kind == DraftKey::Kind::JOINT)
    return Quantity{ "m, degrees" };
  return key.kind == DraftKey::Kind::LENGTH ? LENGTH : Quantity{ key.kind == DraftKey::Kind::ANGLE ? "degrees" : "" };
}
}  // namespace cli
}  // namespace pkm_workspace
