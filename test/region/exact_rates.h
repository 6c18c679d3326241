// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Speeds and accelerations of joints along segments by their definition: the joint values at which the sliders are a
// strut's length from the platform, solved to 100 digits by Newton's method, and their differences.

#include <array>

#include "pkm_workspace/dexterity/path_piece.h"
#include "region/paths.h"

namespace pkm_workspace
{
namespace test
{
/// The joint value q for which the slider, at origin + q axis, is a strut's length from the platform point; of other
/// legs that of their triangles.
inline Number solvedJoint(const Machine& machine, int i, const Oracle::Vector& p, double guess)
{
  if (!std::holds_alternative<SlidingStrut>(machine.leg(i).kind))
    return legAt(machine.leg(i), p).joint;
  const SlidingStrut& strut = slidingStrut(machine.leg(i));
  Oracle::Vector e, offset;
  Number square = 0;
  for (std::size_t k = 0; k < 3; ++k)
  {
    e[k] = strut.axis[k].mid();
    square += e[k] * e[k];
    offset[k] = p[k] - machine.center(i)[k].mid();
  }
  const Number length = strut.length.mid(), per_size = 1 / sqrt(square);
  Number q = guess;
  for (int step = 0; step < 4; ++step)  // from 1e-10 or so to 1e-100
  {
    Number miss = -length * length, slope = 0;
    for (std::size_t k = 0; k < 3; ++k)
    {
      const Number d = offset[k] - q * per_size * e[k];
      miss += d * d;
      slope -= 2 * per_size * d * e[k];
    }
    q -= miss / slope;
  }
  return q;
}

/// |q'| and |q''| of the three joints by the length of the way, at t of a segment that the machine reaches there.
struct ExactRates
{
  std::array<Number, 3> speed, acceleration;

  ExactRates(const Machine& machine, const ExactSegment& exact, double t)
  {
    const Number step = Number(1e-20);
    const std::array<Oracle::Vector, 3> points = { exact.point(t - step), exact.point(t), exact.point(t + step) };
    Number square = 0;
    for (std::size_t k = 0; k < 3; ++k)
      square += (points[2][k] - points[0][k]) * (points[2][k] - points[0][k]);
    const Number way = sqrt(square) / 2;  // of one step: t goes with the length
    const Vector3d guess = *inverseKinematics(machine, exact.segment.point(t));
    for (int i = 0; i < 3; ++i)
    {
      std::array<Number, 3> q;
      for (std::size_t k = 0; k < 3; ++k)
        q[k] = solvedJoint(machine, i, points[k], guess[i]);
      speed[static_cast<std::size_t>(i)] = abs((q[2] - q[0]) / (2 * way));
      acceleration[static_cast<std::size_t>(i)] = abs((q[2] - 2 * q[1] + q[0]) / (way * way));
    }
  }
};

inline bool isWithin(const Number& value, const Span<double>& span)
{
  const Number slack = Number(1e-15) * (1 + value);  // of the differences
  return value >= span.lower - slack && (span.upper == INF || value <= span.upper + slack);
}
}  // namespace test
}  // namespace pkm_workspace
