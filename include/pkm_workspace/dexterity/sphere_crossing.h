// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "pkm_workspace/dexterity/strut_sphere.h"

namespace pkm_workspace
{
/// A point that is proved to lie within a distance of a point of doubles.
struct NearPoint
{
  Eigen::Vector3d point;  ///< [m]
  double distance;        ///< [m]

  /// Contains all points within the distance.
  Box box() const
  {
    const Interval around(-distance, distance);
    return boundingBox(enclose(point) + IntervalVector{ around, around, around });
  }
};

/// Proves that a convex set has a point at which two struts are one vector, although that point is hardly ever one of
/// doubles: it lies between a point of the set within the sphere and one beyond it, both in the sphere's cone.
class SphereCrossing
{
public:
  /// Keeps a reference.
  explicit SphereCrossing(const std::vector<StrutSphere>& spheres) : spheres_(spheres), sides_(spheres.size()) {}

  /// @param point that is proved to lie in the set [m]
  /// @return where a point of the set lies on a sphere, once that is proved
  std::optional<NearPoint> add(const Eigen::Vector3d& point);

private:
  struct Sides
  {
    std::optional<Eigen::Vector3d> within;
    std::optional<Eigen::Vector3d> beyond;
  };

  const std::vector<StrutSphere>& spheres_;
  std::vector<Sides> sides_;
};
}  // namespace pkm_workspace
