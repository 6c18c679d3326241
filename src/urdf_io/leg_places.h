// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>
#include <string>

#include "machine_numbers.h"
#include "pkm_workspace/machine/description.h"
#include "placement.h"

namespace pkm_workspace
{
namespace urdf_io
{
/// Where the joints of one leg stand in their parent links, as a URDF has it, and the axes of those that move.
struct LegPlaces
{
  std::string comment;          ///< what the numbers are to a reader
  std::optional<Origin> tower;  ///< the leg's own axes
  std::optional<Origin> hip;    ///< turned to the axis of a crank, where that is not level
  Origin rail;                  ///< or crank
  Eigen::Vector3d rail_axis;
  Origin elbow;
  Origin revolute;
  Eigen::Vector3d revolute_axis;
  Origin parallelogram;
  Eigen::Vector3d parallelogram_axis;
  Origin parallelogram_back;
  Origin revolute_back;
  std::optional<Origin> flange;  ///< takes back the turn of the strut at zero
  std::optional<Origin> level;   ///< takes back that of the hip
  std::optional<Origin> plate;   ///< the middle of the platform, where that is not the tool point
  Origin tcp;
};

/// All frames are parallel to the root's.
LegPlaces placesOf(const LegNumbers& numbers);

/// A described leg: a yaw and a radius lead to its rail, crank or foot, and its strut is as long as the description
/// says to the last digit. Angles of the strut at zero are rounded to 1e-9 rad, and so are turned drawings of it: they
/// are not part of the machine.
struct DescribedLeg
{
  LegNumbers numbers;  ///< in the frame base_link
  LegPlaces places;
};

/// @throws std::invalid_argument when a number is out of range, or when the struts do not meet at joint values 0
std::array<DescribedLeg, 3> describedLegs(const MachineDescription& machine);
}  // namespace urdf_io
}  // namespace pkm_workspace
