// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "pkm_workspace/region/shape.h"

namespace pkm_workspace
{
/// The most corners that a polytope may have.
constexpr std::size_t MOST_CORNERS = 256;
/// The most points that it may be given by.
constexpr std::size_t MOST_VERTICES = 100000;

/// K(h) = h times the convex hull of the points, as seen from the center, which lies in it. Size: factor on the
/// vertices. It stands on its base where the center lies in its lowest face.
/// @param vertices [m], in any order; those that are proved to lie between others are left out
/// @throws std::invalid_argument for fewer than four, points in one plane, out of range, or around another point than
/// the center, and for too many corners
ShapePtr makePolytope(const std::vector<Eigen::Vector3d>& vertices);
}  // namespace pkm_workspace
