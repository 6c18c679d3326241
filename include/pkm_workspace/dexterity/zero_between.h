// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

namespace pkm_workspace
{
/// Steps of narrowZero(): ten times as many as lead from a thousand struts to a millionth of one.
constexpr int MOST_STEPS = 400;

/// Brings the ends of a line closer together between which a function has a zero: not positive at the one, not negative
/// at the other. Ends where they are no further apart than that, where neither sign is proved, where doubles end, and
/// after MOST_STEPS steps whatever the numbers are.
/// @param finest [m] @param sign of the function at a point: -1 where it is proved not to be positive, 1 where it is
/// proved not to be negative, otherwise 0; called twice a step at the most
template <class Sign>
void narrowZero(Eigen::Vector3d& low, Eigen::Vector3d& high, double finest, const Sign& sign)
{
  bool is_narrower = true;
  for (int step = 0; step < MOST_STEPS && is_narrower && (high - low).squaredNorm() > finest * finest; ++step)
  {
    is_narrower = false;
    for (const double share : { 0.5, 0.4375 })  // the second place is for a zero at the first
    {
      const Eigen::Vector3d point = share * low + (1.0 - share) * high;
      const int side = sign(point);
      const Eigen::Vector3d& other = side < 0 ? high : low;
      is_narrower = side != 0 && (other - point).squaredNorm() < (high - low).squaredNorm();
      if (!is_narrower)
        continue;
      (side < 0 ? low : high) = point;
      break;
    }
  }
}
}  // namespace pkm_workspace
