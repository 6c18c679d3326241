// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "pkm_workspace/region/largest_region.h"

namespace pkm_workspace
{
/// A shape by its name and what goes with it, as options, parameters and requests give it.
struct ShapeWish
{
  std::string name = "cube";
  std::optional<Eigen::Vector3d> proportions = {};      ///< of a box, or the footprint
  std::optional<RatioRange> ratio = {};                 ///< of a cylinder, 1e-6 to 1e6; or one of the next two
  std::optional<double> radius = {};                    ///< of a cylinder that is to be as high as it can [m]
  std::optional<double> height = {};                    ///< of a cylinder that is to be as wide as it can [m]
  std::optional<std::array<double, 2>> footprint = {};  ///< of a box that is to be as high as it can: x and y [m]
  std::vector<Eigen::Vector3d> vertices = {};           ///< of a polytope, seen from its center [m]

  /// Whether any but the name is given.
  bool hasMeasures() const;
  /// A shape of that name with those of the measures that it takes.
  ShapeWish as(const std::string& shape) const;
};

/// Sets shape and ratio of a query.
/// @throws std::invalid_argument for an unknown name, for what is missing, out of range, too much or of another shape
void setShape(const ShapeWish& wish, RegionQuery& query);

/// Where a region may be: in a search box, about one center, on a plane, or on a plane within a search box; and whether
/// at any angle.
struct PlaceWish
{
  std::optional<Box> search_box = {};          ///< bounds the center, on a plane the middle of the base [m]
  std::optional<Eigen::Vector3d> center = {};  ///< [m]
  std::optional<double> base_z = {};           ///< the lowest face lies on z = base_z [m]
  bool turned = false;                         ///< whether it may be turned about the vertical: not for round shapes
};

/// Sets where the query looks; on a plane the shape, too: the family that stands on its center.
/// @pre the shape is set @throws std::invalid_argument for places that cannot be had together, by that shape, or at all
void setPlace(const PlaceWish& wish, RegionQuery& query);
}  // namespace pkm_workspace
