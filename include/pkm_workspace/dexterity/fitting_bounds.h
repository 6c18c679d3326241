// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>

#include "pkm_workspace/dexterity/criterion.h"
#include "pkm_workspace/machine/machine.h"

namespace pkm_workspace
{
/// Bounds [1/f, f] of the velocity transmission factors that fit a machine, in floating point: a choice of what to ask
/// for, of which nothing has to be proved.
struct FittingBounds
{
  Eigen::Vector3d point;  ///< where the factors are nearest to 1: where max(psi_3, 1 / psi_1) is least [m]
  Eigen::Vector3d psi;    ///< the factors there, ascending
  double psi_min;         ///< 1 / f and f, to two digits: f is twice as much as at that point, so that the paper's two
  double psi_max;         ///< machines nearly get the paper's bounds
};

/// @param criterion whose other conditions count @return nothing where no point of the set was found
std::optional<FittingBounds> fittingBounds(const Machine& machine, const Criterion& criterion);

/// Sets them. @return what was chosen @throws std::invalid_argument where there are none
FittingBounds chooseBounds(const Machine& machine, Criterion& criterion);

/// "psi in [0.24, 4.1]: twice as wide as at the best point, (0, 0, 0.3) m, where the factors are 0.49 to 1.73".
std::string describe(const FittingBounds& bounds);

/// What a user should know whose bounds are the default: that the middle of the machine, where all sliders are in the
/// middle of their travel (at the zero configuration where the travel has no end), fails them, with the factors there,
/// and which bounds would do. @param remedy how to ask for these: "--psi auto" @return empty where the middle is good
std::string remarkOnDefaultBounds(const Machine& machine, const Criterion& criterion, const std::string& remedy);
}  // namespace pkm_workspace
