// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>

#include "pkm_workspace/dexterity/point_evaluation.h"

namespace pkm_workspace
{
/// What the speeds and accelerations of the joints are held against while the tool goes along a path, leg by leg; INF
/// where there is no limit.
struct JointRateLimits
{
  std::array<double, 3> speed = { INF, INF, INF };         ///< [m/s], > 0
  std::array<double, 3> acceleration = { INF, INF, INF };  ///< [m/s^2], > 0

  bool any() const { return std::min(least(speed), least(acceleration)) < INF; }
  void validate(Problems& problems) const;

private:
  static double least(const std::array<double, 3>& limits) { return *std::min_element(limits.begin(), limits.end()); }
};

/// A bracket of the largest constant tool speed that keeps all joints within their limits: every speed up to `lower`
/// does, proved, and none above `upper` does. INF where no joint that has a limit moves.
struct LargestFeed
{
  double lower = INF;                           ///< [m/s]
  double upper = INF;                           ///< [m/s]
  Limit::Kind kind = Limit::Kind::JOINT_SPEED;  ///< which limit is met first, ...
  int leg = -1;                                 ///< ... and of which leg; -1 where none is
};

/// How fast the joints go along a path or a segment.
struct PathRates
{
  std::array<double, 3> joint_acceleration;  ///< upper bounds of |qddot_i| at the tool speed asked for [m/s^2]
  LargestFeed feed;
};
}  // namespace pkm_workspace
