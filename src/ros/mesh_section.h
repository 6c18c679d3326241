// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "set_paint.h"

namespace pkm_workspace
{
/// Part of a surface as it is drawn; seen from outside its corners turn to the left.
struct PaintedTriangle
{
  std::array<Eigen::Vector3d, 3> corners;     ///< [m]
  std::array<float, 3> shades = { 1, 1, 1 };  ///< of the corners: 0 is black
  SetPaint paint = NO_END;
};
using PaintedSurface = std::vector<PaintedTriangle>;

/// What of a closed surface is not above a height, closed by its section at that height, which nothing ends.
/// @param hole what the solid of this surface leaves free in the section
PaintedSurface below(const PaintedSurface& surface, const PaintedSurface& hole, double height);
}  // namespace pkm_workspace
