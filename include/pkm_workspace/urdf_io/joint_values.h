// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <map>
#include <string>

#include "pkm_workspace/urdf_io/urdf_reader.h"

namespace pkm_workspace
{
/// Closes the loops of the model at one tool point, in floating point.
/// @param p tool point [m] @return the value [m, rad] of every joint, by name, that moves with the machine: rails,
/// passive joints and all that follow them by <mimic>
/// @throws std::invalid_argument when a leg, or the passive joints of one, cannot reach p
std::map<std::string, double> jointValues(const UrdfMachine& urdf, const Eigen::Vector3d& p);
}  // namespace pkm_workspace
