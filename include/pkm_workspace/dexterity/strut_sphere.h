// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <vector>

#include "pkm_workspace/interval/affine_vector.h"
#include "pkm_workspace/machine/machine.h"

namespace pkm_workspace
{
/// A sphere on which two struts are one vector, so that det A is 0: where the lines c + t e of two legs meet in a point
/// o and the struts have one length L, each point p with |p - o| = L and s e . (p - o) >= 0 for both legs has
/// |q|^2 = L^2 - (e . (p - o))^2, hence eta = e . (p - o), and both struts are p - o. Where the third line passes
/// through o too, det A has the same sign on both sides of the sphere, and no form of it tells that it vanishes.
///
/// The points p with s e . (p - o) >= 0 for both legs are a cone, which is convex: what a convex region shares with
/// it lies within the sphere, or beyond it, or has a point on it.
class StrutSphere
{
public:
  /// @param center o [m] @param radius L [m] @param first, second s e of the two legs
  StrutSphere(const Eigen::Vector3d& center, double radius, const IntervalVector& first, const IntervalVector& second);

  const Eigen::Vector3d& center() const { return center_; }
  double radius() const { return radius_; }

  /// Whether all points of the box are proved to lie in the cone. The tip o does, whatever this says.
  bool hasInCone(const CenteredBox<double>& box) const;
  /// (|p - o|^2 - L^2) / (2 L^2) over the box: negative within the sphere, positive beyond it; without unit.
  AffineForm<double> excess(const CenteredBox<double>& box) const;

private:
  Eigen::Vector3d center_;
  double radius_;
  EnclosedMatrix<double> along_;  ///< rows: s e of both legs
  EnclosedMatrix<double> identity_;
  EnclosedVector<double> origin_;  ///< o
  Enclosed<double> per_square_;    ///< 1 / (2 L^2) [1/m^2]
};

/// The spheres of the machine, one for each pair of legs that has one. The lines have to meet exactly, and the lengths
/// to be the same doubles: a machine that is known up to rounding only has none.
std::vector<StrutSphere> strutSpheres(const Machine& machine);
}  // namespace pkm_workspace
