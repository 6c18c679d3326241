// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <optional>

#include "pkm_workspace/region/region_wish.h"
#include "support/oracle.h"
#include "support/random.h"

namespace pkm_workspace
{
namespace test
{
/// A family of regions as it is asked for, and by its definition: the points that c + K(h) has, in 100 digits.
struct Body
{
  enum class Kind
  {
    BOX,         ///< full sides
    ROUND,       ///< radius in x, height in z
    BALL,        ///< radius in x
    OCTAHEDRON,  ///< |x| / a + |y| / b + |z| / c <= 1
    CORNER       ///< x, y, z >= 0, x / a + y / b + z / c <= 1
  };

  ShapeWish wish;
  Kind kind = Kind::BOX;
  Eigen::Vector3d fixed = Eigen::Vector3d::Zero();     ///< what each of its measures is at size 0 [m]
  Eigen::Vector3d per_size = Eigen::Vector3d::Zero();  ///< and by what it grows
  bool stands = false;                                 ///< on its center
  double angle = 0.0;                                  ///< by which it is turned about z [rad]

  /// Whether c + K(h) has the point.
  bool holds(const Eigen::Vector3d& point, const Eigen::Vector3d& center, double size) const;
  /// Nearly the point of c + K(h) that is at u, from -1 to 1: on its surface where u is on that of the cube, mostly.
  Eigen::Vector3d place(const Eigen::Vector3d& u, const Eigen::Vector3d& center, double size) const;
  /// The same, as a point that c + K(h) has for certain; nothing where no double near to it is.
  std::optional<Eigen::Vector3d> pointAt(const Eigen::Vector3d& u, const Eigen::Vector3d& center, double size) const;
  /// Whether it is another one when it is turned.
  bool canTurn() const { return kind != Kind::ROUND && kind != Kind::BALL; }
};

/// Any of them. @param scale of the machine [m]
Body drawnBody(Random& random, double scale);
}  // namespace test
}  // namespace pkm_workspace
