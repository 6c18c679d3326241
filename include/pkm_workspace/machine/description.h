// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>
#include <string>

#include "pkm_workspace/common/problems.h"
#include "pkm_workspace/machine/tolerances.h"

namespace pkm_workspace
{
/// One leg with a sliding strut, by the numbers that are measured on a machine. Its own axes are those of the machine,
/// turned about z by `angle` and moved to `foot`: x points outwards.
struct LegDescription
{
  std::string joint;                                         ///< name of the rail's joint
  double angle = 0.0;                                        ///< of its axes, counter-clockwise from x [rad]
  Eigen::Vector2d foot = Eigen::Vector2d::Zero();            ///< x and y of where its axes stand [m]
  double radius = 0.0;                                       ///< of the rail, along its own x [m]
  double lean = 0.0;                                         ///< of the rail outwards, from z towards x [rad]
  double side_lean = 0.0;                                    ///< of the rail sideways, then, towards its own y [rad]
  double height = 0.0;                                       ///< z of the rail's slider at joint value 0 [m]
  Eigen::Vector3d slider_joint = Eigen::Vector3d::Zero();    ///< the strut's upper end, seen from the slider [m]
  Eigen::Vector3d platform_joint = Eigen::Vector3d::Zero();  ///< its other end, seen from the platform's middle [m]
  double length = 0.0;                                       ///< of the strut [m]
  double lower = 0.0;                                        ///< joint limits [m]
  double upper = 0.0;
  double speed = 0.0;     ///< the largest of its slider [m/s]; 0 where none is known
  double effort = 0.0;    ///< the largest force on it [N]; 0 where none is known
  int working_mode = -1;  ///< -1: the strut points against the rail, +1: along it
};

/// Where a machine stands, as a URDF's <origin> has it.
struct Mount
{
  Eigen::Vector3d xyz = Eigen::Vector3d::Zero();  ///< [m]
  Eigen::Vector3d rpy = Eigen::Vector3d::Zero();  ///< [rad]
};

/// A machine with three sliding struts by its measured numbers: what writeUrdf() turns into a URDF. Vectors of a leg
/// are in the leg's own axes.
struct MachineDescription
{
  std::string name = "machine";
  std::array<LegDescription, 3> legs;
  Eigen::Vector3d tool = Eigen::Vector3d::Zero();  ///< the tool point, seen from the platform's middle [m]
  bool is_upper = false;                           ///< of two assemblies in these working modes, the upper one
  Tolerances tolerances;                           ///< by how much what was built may differ
  std::optional<Mount> mount;                      ///< of the machine's frame "base_link" in the frame "world"

  /// Appends a sentence for each number that no machine has.
  void validate(Problems& problems) const;
};

/// The unit direction of a rail in the leg's own axes: (sin lean cos side, sin side, cos lean cos side). Exact for
/// leans of 0.
Eigen::Vector3d railDirection(const LegDescription& leg);

/// The rotation from the leg's own axes to the machine's.
Eigen::Matrix3d legAxes(const LegDescription& leg);

/// The point A of the leg at a joint value, in the machine's axes [m].
Eigen::Vector3d sliderJoint(const LegDescription& leg, double joint);

/// The tool point at given joint values, in floating point: all struts in their working modes, and of two such points
/// the lower or the upper one, as the machine says.
/// @param joints [m] @return in the machine's axes [m]; nothing where the struts do not meet so
std::optional<Eigen::Vector3d> assembledTool(const MachineDescription& machine, const Eigen::Vector3d& joints);
}  // namespace pkm_workspace
