// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <vector>

#include "pkm_workspace/common/problems.h"
#include "pkm_workspace/machine/machine.h"

namespace pkm_workspace
{
/// Along each leg's strut, from slider to platform, where its ball joints are not tilted: one for all legs or one for
/// each, in the frame of the machine; none: as at the zero configuration.
using BallAxes = std::vector<Eigen::Vector3d>;

/// Appends one sentence for each thing that is wrong.
void validateBallAxes(const BallAxes& axes, Problems& problems);
/// Gives them to the struts. @pre they are valid
void setBallAxes(const BallAxes& axes, Machine::Legs& legs);
/// The same machine with these. @throws std::invalid_argument where they are not valid
Machine withBallAxes(const Machine& machine, const BallAxes& axes);
/// One for each leg, to the nearest doubles; empty where they are as at the zero configuration.
BallAxes givenBallAxes(const Machine& machine);
}  // namespace pkm_workspace
