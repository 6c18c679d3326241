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
}  // namespace pkm_workspace
