// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <string>

#include "pkm_workspace/machine/catalogue.h"
#include "pkm_workspace/machine/tolerances.h"

namespace pkm_workspace
{
/// Machines that differ by one number.
struct MachineFamily
{
  std::string parameter;  ///< its name
  std::string unit;       ///< "m", or empty for a number without unit
  /// For a set of parameters a machine whose numbers enclose those of all its members; at a point, the member itself.
  /// @throws std::invalid_argument where a member does not exist, or where no machine can be told to enclose them all
  std::function<Machine(const Interval&)> at;
};

/// The UraneSX by R - r [m], which is all that its regions depend on.
/// @param length strut length L [m]
MachineFamily uranesxByRadius(double length = 1.0);

/// The UraneSX of the paper's table 2 by lambda [m]: L = 1 m, R = 7/13 + lambda, r = 3/26.
MachineFamily uranesxByLambda();

/// The Delta, and the tripod, of the catalogue by one of their dimensions [m], the others as they are; with joint
/// limits.
MachineFamily deltaBy(Interval DeltaDimensions::*dimension, const std::string& name);
MachineFamily tripodBy(Interval TripodDimensions::*dimension, const std::string& name);

/// All machines on the way from one to another: every number of the geometry is (1 - t) first + t last, directions of
/// rails made to unit length; the parameter t has no unit.
/// @param joint_limits whether joint limits will be asked for: they must be the same then, as a limit is no number that
/// could be enclosed; where they are not, the joint has none
/// @throws std::invalid_argument when their working modes, aspects, tolerances, or limits that matter differ
MachineFamily familyBetween(const Machine& first, const Machine& last, bool joint_limits = false);

/// The same family, where each member stands for all machines within tolerances of it, given in place of its own.
MachineFamily withinTolerances(const MachineFamily& family, const GivenTolerances& tolerances);
}  // namespace pkm_workspace
