// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>
#include <string>
#include <utility>

#include "leg_forms.h"
#include "pkm_workspace/machine/machine.h"

namespace pkm_workspace
{
namespace urdf_io
{
/// The doubles that a URDF has for one leg: read back, their enclosures overlap those of the machine.
struct LegNumbers
{
  std::string joint;
  LegForm form = LegForm::SLIDER;
  Eigen::Vector3d origin;  ///< A at joint value 0, the foot, or what a crank's tip turns about [m]
  Eigen::Vector3d arm = Eigen::Vector3d::Zero();  ///< of a crank: from there to its tip A at joint value 0 [m]
  Eigen::Vector3d axis;      ///< along e, along the strut that gets longer, or of a crank; nearly of unit length
  Eigen::Vector3d platform;  ///< b [m]
  Eigen::Vector3d strut;     ///< A to B at joint values 0 [m]
  double lower;              ///< joint limits [m, rad]; infinite where a crank has none
  double upper;
  double speed;                     ///< of the joint [m/s, rad/s]; 0 where none is known, as a URDF has it
  double effort;                    ///< on the joint [N, N m]; 0 where none is known
  std::pair<double, double> drawn;  ///< the part of its travel that a rail is drawn for [m]
  Eigen::Vector3d revolute;  ///< axis of the first passive joint: perpendicular to the strut, and to the rail if it can
  Eigen::Vector3d parallelogram;  ///< axis of the second one: perpendicular to the first and to the strut
};

/// @throws std::invalid_argument when the machine is not assembled at joint values 0
std::array<LegNumbers, 3> numbersOf(const Machine& machine);
}  // namespace urdf_io
}  // namespace pkm_workspace
