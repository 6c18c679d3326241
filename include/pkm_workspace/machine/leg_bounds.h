// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include "pkm_workspace/interval/interval_vector.h"

namespace pkm_workspace
{
/// Points p with |E (p - c)| <= r, for a projector E: a cylinder about a line, for E = I a ball, for E = 0 all points.
struct OuterBound
{
  IntervalMatrix projector;  ///< E
  IntervalVector center;     ///< c [m]
  Interval radius;           ///< r [m]

  /// Whether it bounds anything: E is not 0.
  bool isBound() const;
  /// Encloses the vectors E (p - c): |q_k| <= r sqrt(E_kk) [m].
  IntervalVector offsets() const;
};

/// How far a leg has to reach [m].
struct LegReach
{
  Interval value;
  Interval most;
};

/// [m]
struct LegSphere
{
  Eigen::Vector3d center;
  double radius;
};
}  // namespace pkm_workspace
