// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

#include "pkm_workspace/interval/curve.h"
#include "pkm_workspace/interval/pencil_bounds.h"

namespace pkm_workspace
{
/// What the machine does while the tool is on a piece of a path: bounds that hold at all of its points.
struct PieceMotion
{
  std::array<Span<double>, 3> psi;    ///< velocity transmission factors, ascending; the upper ones may be infinite
  std::array<Span<double>, 3> joint;  ///< rho_i [m]
  std::array<double, 3> speed;        ///< upper bounds of |(J^-1 t)_i|: joint speed over tool speed
};

/// How fast the joints go there while the tool goes at a constant speed, in magnitude: what every point has is between
/// the two.
struct PieceRates
{
  std::array<Span<double>, 3> speed;         ///< |q_i'|: joint speed over tool speed
  std::array<Span<double>, 3> acceleration;  ///< |q_i''|: joint acceleration over the square of the tool speed [1/m]
};
}  // namespace pkm_workspace
