// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cmath>

#include "expect_import.h"

namespace pkm_workspace
{
namespace test
{
/// What Marlin's recalc_delta_settings() and DELTA_IK compute: towers at 210, 330 and 90 degrees and a trim, radius and
/// rod with a trim each. [mm, degrees]
struct MarlinNumbers
{
  using Three = std::array<double, 3>;

  double radius;
  double rod;
  Three angle_trim;
  Three radius_trim;
  Three rod_trim;

  Three operator()(double x, double y, double z) const
  {
    const Three directions = { 210.0, 330.0, 90.0 };
    Three carriages{};
    for (std::size_t i = 0; i < 3; ++i)
    {
      const double angle = (directions[i] + angle_trim[i]) * M_PI / 180.0;
      const double distance = radius + radius_trim[i];
      carriages[i] = z + std::sqrt(std::pow(rod + rod_trim[i], 2) - std::pow(std::cos(angle) * distance - x, 2) -
                                   std::pow(std::sin(angle) * distance - y, 2));
    }
    return carriages;
  }
};

/// The upper limit is the switch: as far above the carriage at home as the adjustment says.
inline void expectSwitches(const MachineDescription& machine, const MarlinNumbers& marlin, double home,
                           const MarlinNumbers::Three& adjustments)
{
  const MarlinNumbers::Three carriages = marlin(0, 0, home);
  for (std::size_t i = 0; i < 3; ++i)
  {
    EXPECT_LE(machine.legs[i].upper, (carriages[i] - adjustments[i]) * 1e-3);
    EXPECT_GE(machine.legs[i].upper, (carriages[i] - adjustments[i]) * 1e-3 - 1.1e-6);
  }
}
}  // namespace test
}  // namespace pkm_workspace
