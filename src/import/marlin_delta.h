// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <optional>

#include "linear_delta.h"

namespace pkm_workspace
{
namespace firmware
{
constexpr Quantity MARLIN_ENDSTOP = { "mm", -100, 0, 1, -3, "m" };

/// The numbers of Marlin's delta, wherever they come from. In degrees and metres.
struct MarlinDelta
{
  using Three = std::array<std::optional<Decimal>, 3>;  ///< of the towers A, B, C; nothing is 0

  std::optional<Decimal> radius;
  std::optional<Decimal> rod;
  std::optional<Decimal> height;
  Decimal probe_z;
  Three endstop;
  Three angle_trim;
  Three radius_trim;
  Three rod_trim;
  SourcePlace place;
};

/// Marlin's model (MarlinFirmware/Marlin, src/module/delta.cpp): towers at 210, 330 and 90 degrees plus their trim,
/// radius and rod each plus its trim; the carriages home at endstop_adj, none above 0, below their switches, and the
/// tool is at height less the probe's offset then.
void applyMarlin(const MarlinDelta& marlin, LinearDelta& delta);
}  // namespace firmware
}  // namespace pkm_workspace
