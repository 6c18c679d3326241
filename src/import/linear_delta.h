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
/// One tower of a linear delta, as its controller knows it. In degrees and metres.
struct Tower
{
  std::string joint;
  std::optional<Decimal> angle;  ///< counter-clockwise from x, seen from above
  std::optional<Decimal>
      radius;                   ///< across, from the strut's lower end to its upper one where the tool is in the middle
  std::optional<Decimal> arm;   ///< the strut
  std::optional<Decimal> home;  ///< z of the tool in the middle where this carriage is at its switch
  Decimal height;               ///< z of the carriage at joint value 0
  std::optional<Decimal> lower;  ///< joint limits, where the controller has any
  std::optional<Decimal> upper;
  std::optional<Decimal> speed;  ///< the largest of the carriage, where the controller has one; 0 as well for none
  SourcePlace place;             ///< of its arm, for problems
};

/// A controller's model of a linear delta: q_i = z + sqrt(arm_i^2 - |(x, y) - tower_i|^2) - height_i, the same in all
/// that are read here (docs/firmware.md); z grows by the bed's slope times (x, y).
struct LinearDelta
{
  std::array<Tower, 3> towers;
  std::optional<Decimal> print_radius;  ///< how far from the middle the controller takes the tool
  std::optional<Decimal> lowest;        ///< and how low
  Decimal slope_x;                      ///< of the bed against the towers
  Decimal slope_y;
};

/// A degree in radians.
const Decimal& radianOfDegree();

/// Looks at what no value shows by itself: arms that are too short, towers that stand in one place, no travel.
void checkDelta(const LinearDelta& delta, Reading& reading);

/// Joint limits that the controller does not have follow from the moves that it allows: from the carriage's lowest
/// place to its switch, rounded inwards to the micrometre. @pre nothing was wrong
MachineDescription describe(const LinearDelta& delta, const std::string& name);
}  // namespace firmware
}  // namespace pkm_workspace
