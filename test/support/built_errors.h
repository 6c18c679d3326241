// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "support/built_machines.h"

namespace pkm_workspace
{
namespace test
{
/// Of a deviation, the parts that vary in a ball made those for which a function grows fastest.
template <class Function>
Deviation towardsLarger(const Deviation& from, const Function& function)
{
  Deviation result = from;
  for (std::size_t leg = 0; leg < 3; ++leg)
    for (std::size_t k = 6; k < 14; ++k)
    {
      Deviation up = from, down = from;
      up.share[leg][k] += 1e-3;
      down.share[leg][k] -= 1e-3;
      result.share[leg][k] = 1e12 * (function(up) - function(down));
    }
  result.project();
  return result;
}

/// The error with which the tool is farthest off [m]: from some starts, each share at whichever end is worse, and balls
/// along the slope, until none makes it worse.
inline double worstToolError(const Machine& meant, const JointValues& errors, const Eigen::Vector3d& point,
                             Random& random, int starts)
{
  const auto errorOf = [&](const Deviation& at) { return largestToolError(meant, at, errors, point); };
  double worst = 0.0;
  for (int start = 0; start < starts; ++start)
  {
    Deviation at = randomDeviation(random);
    double reached = errorOf(at);
    const auto attempt = [&](const Deviation& next) {
      const double error = errorOf(next);
      const bool is_worse = error > reached * (1.0 + 1e-12);
      at = is_worse ? next : at;
      reached = std::max(reached, error);
      return is_worse;
    };
    for (bool improved = true; improved;)
    {
      improved = attempt(towardsLarger(at, errorOf));
      for (std::size_t leg = 0; leg < 3; ++leg)
      {
        Deviation turned = at;  // what each leg does helps with one sign, and the signs go together
        for (double& share : turned.share[leg])
          share = -share;
        improved = attempt(turned) || improved;
        for (std::size_t k = 0; k < Deviation::COUNT; k += k == 5 ? 9 : 1)
        {
          Deviation next = at;
          next.share[leg][k] = -at.share[leg][k] > 0.0 ? 1.0 : -1.0;
          improved = attempt(next) || improved;
          next.share[leg][k] = -next.share[leg][k];
          improved = attempt(next) || improved;
        }
      }
    }
    worst = std::max(worst, reached);
  }
  return worst;
}
}  // namespace test
}  // namespace pkm_workspace
