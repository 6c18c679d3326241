// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

namespace pkm_workspace
{
/// Indices of the corners of a triangle, counterclockwise as seen from outside.
using HullTriangle = std::array<std::size_t, 3>;

/// The surface of the convex hull of points, in floating point: points that stick out of the others by less than 1e-10
/// of all they measure may lie outside.
/// @throws std::invalid_argument for fewer than four points, for points that are not finite or that lie in one plane,
/// or nearly
std::vector<HullTriangle> convexHull(const std::vector<Eigen::Vector3d>& points);
}  // namespace pkm_workspace
