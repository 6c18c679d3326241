// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <optional>
#include <string>

#include "reading.h"

namespace pkm_workspace
{
namespace firmware
{
/// One crank of a rotary delta, as its controller knows it. In degrees.
struct DrivenCrank
{
  std::string joint;
  Decimal angle;                 ///< of the way that it points, counter-clockwise from x, seen from above
  std::optional<Decimal> lower;  ///< joint limits
  std::optional<Decimal> upper;
  double speed = 0.0;  ///< the largest [rad/s]; 0 where none is known
  SourcePlace place;   ///< of its limits, for problems
};

/// A controller's model of a rotary delta, the same in all that are read here (docs/firmware.md): cranks about level
/// axes in the plane z = 0, which point outwards and are level at joint value 0 and further down at larger ones;
/// forearms to a platform below, whose elbows are out. Lengths in metres.
struct RotaryDelta
{
  std::array<DrivenCrank, 3> cranks;
  std::optional<Decimal> base_radius;      ///< from the middle to the cranks' axes
  std::optional<Decimal> crank;            ///< from its axis to the forearm
  std::optional<Decimal> forearm;          ///< from joint to joint
  std::optional<Decimal> platform_radius;  ///< from the tool point to the forearms' ends
  SourcePlace place;                       ///< of the forearm, for problems
};

constexpr Quantity CRANK_DEGREES = { "degrees", -180, 180, 1, 0, "degrees" };  ///< a joint value

/// Looks at what no value shows by itself: forearms that are too short, no travel.
void checkDelta(const RotaryDelta& delta, Reading& reading);

/// @pre nothing was wrong
MachineDescription describe(const RotaryDelta& delta, const std::string& name);
}  // namespace firmware
}  // namespace pkm_workspace
