// SPDX-License-Identifier: BSD-3-Clause
#include "marlin_delta.h"

namespace pkm_workspace
{
namespace firmware
{
namespace
{
constexpr long MARLIN_ANGLES[] = { 210, 330, 90 };  // degrees
constexpr const char* MARLIN_JOINTS[] = { "tower_a", "tower_b", "tower_c" };

std::optional<Decimal> trimmedBy(const std::optional<Decimal>& value, const std::optional<Decimal>& trim)
{
  return value ? std::optional<Decimal>(*value + trim.value_or(0)) : std::nullopt;
}
}  // namespace

void applyMarlin(const MarlinDelta& marlin, LinearDelta& delta)
{
  for (std::size_t i = 0; i < delta.towers.size(); ++i)
  {
    Tower& tower = delta.towers[i];
    tower.joint = MARLIN_JOINTS[i];
    tower.place = marlin.place;
    tower.angle = trimmedBy(Decimal(MARLIN_ANGLES[i]), marlin.angle_trim[i]);
    tower.radius = trimmedBy(marlin.radius, marlin.radius_trim[i]);
    tower.arm = trimmedBy(marlin.rod, marlin.rod_trim[i]);
    if (marlin.height)
      tower.home = *marlin.height - marlin.probe_z - marlin.endstop[i].value_or(0);
  }
}
}  // namespace firmware
}  // namespace pkm_workspace
