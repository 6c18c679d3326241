// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "pkm_workspace/region/shape.h"

namespace pkm_workspace
{
/// A shape of a given size: exactly what was asked for, nothing is rounded.
struct Solid
{
  ShapePtr shape;
  double size = 1.0;
};

/// A region by its middle and what it measures, as shape_msgs/SolidPrimitive has it.
struct CenteredSolid
{
  Eigen::Vector3d center;          ///< [m]
  std::vector<double> dimensions;  ///< rounded inward: about this center it lies in the region [m]
};
CenteredSolid centeredSolid(const Shape& shape, const Eigen::Vector3d& center, double size);

/// Solids that are given by what they measure.
enum class SolidKind
{
  BOX,       ///< full sides along x, y and z
  SPHERE,    ///< radius
  CYLINDER,  ///< height and radius; its axis is parallel to z
};

/// A solid without thickness is the disc, rectangle or line that it is.
/// @param dimensions as the kind has them [m]
/// @throws std::invalid_argument with what they must be: "must be one radius, ..."
Solid makeSolid(SolidKind kind, const std::vector<double>& dimensions);
/// @param size of the shape, in its unit @throws std::invalid_argument with its range
Solid makeSolid(const ShapePtr& shape, double size);
}  // namespace pkm_workspace
