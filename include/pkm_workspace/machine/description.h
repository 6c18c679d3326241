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
/// One leg, by the numbers that are measured on a machine. Its own axes are those of the machine, turned about z by
/// `angle` and moved to `foot`: x points outwards.
struct LegDescription
{
  enum class Kind
  {
    RAIL,       ///< a strut of fixed length on a slider
    TELESCOPE,  ///< a strut of variable length, as long as `length` at joint value 0
    CRANK       ///< a forearm at the end of a crank, which turns about its own y, or an axis that leans from there
  };
  Kind kind = Kind::RAIL;
  std::string joint;                               ///< name of the joint that a motor moves
  double angle = 0.0;                              ///< of its axes, counter-clockwise from x [rad]
  Eigen::Vector2d foot = Eigen::Vector2d::Zero();  ///< x and y of where its axes stand [m]
  double radius = 0.0;                             ///< of rail, foot or crank's axis, along its own x [m]
  double lean = 0.0;                               ///< of the rail outwards, from z towards x [rad]
  double side_lean = 0.0;                          ///< of the rail sideways, then, towards its own y [rad]
  double height = 0.0;                             ///< z of slider at joint value 0, foot or axis [m]
  double crank = 0.0;                              ///< r: from the crank's axis to its tip [m]
  double axis_lean = 0.0;                          ///< of the crank's axis: from its own y towards z [rad]
  double crank_zero = 0.0;  ///< how far the crank points down from its own x at joint value 0 [rad]
  int turn = 1;             ///< 1: larger joint values turn the crank further down, -1: up
  Eigen::Vector3d slider_joint = Eigen::Vector3d::Zero();    ///< the strut's upper end, seen from the slider [m]
  Eigen::Vector3d platform_joint = Eigen::Vector3d::Zero();  ///< its other end, seen from the platform's middle [m]
  double length = 0.0;                                       ///< of the strut or forearm [m]
  double lower = 0.0;                                        ///< joint limits [m, rad]
  double upper = 0.0;
  double speed = 0.0;   ///< the largest of its joint [m/s, rad/s]; 0 where none is known
  double effort = 0.0;  ///< the largest force or torque on it [N, N m]; 0 where none is known
  /// -1: the strut points against the rail, or against the way of the crank's tip when that goes up; +1: along it
  int working_mode = -1;
};

/// Where a machine stands, as a URDF's <origin> has it.
struct Mount
{
  Eigen::Vector3d xyz = Eigen::Vector3d::Zero();  ///< [m]
  Eigen::Vector3d rpy = Eigen::Vector3d::Zero();  ///< [rad]
};

/// A machine with three legs by its measured numbers: what writeUrdf() turns into a URDF. Vectors of a leg
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

/// The same to those of a crank: x level and outwards, y along its axis. Of another leg, legAxes().
Eigen::Matrix3d crankAxes(const LegDescription& leg);

/// From a crank's axis to its tip at a joint value [rad], in the machine's axes [m]; 0 of another leg.
Eigen::Vector3d crankArm(const LegDescription& leg, double joint);

/// The end of the strut that the joint moves, at a joint value, in the machine's axes [m]: at the slider, the crank's
/// tip, or the foot, which stays.
Eigen::Vector3d drivenJoint(const LegDescription& leg, double joint);

/// The tool point at given joint values, in floating point: all struts in their working modes, and of two such points
/// the lower or the upper one, as the machine says.
/// @param joints [m, rad] @return in the machine's axes [m]; nothing where the struts do not meet so
std::optional<Eigen::Vector3d> assembledTool(const MachineDescription& machine, const Eigen::Vector3d& joints);
}  // namespace pkm_workspace
