// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <string>

#include "pkm_workspace/interval/interval_vector.h"

namespace pkm_workspace
{
/// By how much a sliding strut, as it was built, may differ from its numbers; either way (docs/tolerances.md).
struct StrutTolerance
{
  std::array<double, 3> slider = { 0.0, 0.0, 0.0 };    ///< each coordinate of the slider point A [m]
  std::array<double, 3> platform = { 0.0, 0.0, 0.0 };  ///< each coordinate of the platform point B [m]
  double slider_ball = 0.0;                            ///< besides, the distance of A from where that leaves it [m]
  double platform_ball = 0.0;                          ///< the same of B [m]
  double direction = 0.0;                              ///< angle between the rail and its direction [rad]
  double length = 0.0;                                 ///< the strut's length [m]
  double zero = 0.0;                                   ///< the joint value: where the joint's zero is [m]
  /// The axes of these coordinates, in the machine's frame: columns of a rotation.
  IntervalMatrix axes = { IntervalVector{ 1.0, 0.0, 0.0 }, IntervalVector{ 0.0, 1.0, 0.0 },
                          IntervalVector{ 0.0, 0.0, 1.0 } };

  bool isZero() const;
};

/// Its numbers, digit by digit: "" where all are 0.
std::string exactText(const StrutTolerance& tolerance);

/// The parameters of one strut on which forms depend, each from -1 to 1: three coordinates of c = a - b, the joint's
/// zero, two of the rail's direction, and the length.
constexpr std::size_t STRUT_PARAMETERS = 7;

/// A set of parameters (p_0, .., p_6) of one strut: p_k = box_k s_k + ball_k t_k for k < 3, |s_k| <= 1, |t| <= 1; the
/// joint's zero |p_3| <= 1; the direction p_4^2 + p_5^2 <= 1; the length |p_6| <= 1.
struct ParameterSet
{
  std::array<double, 3> box = { 0.0, 0.0, 0.0 };
  std::array<double, 3> ball = { 0.0, 0.0, 0.0 };
};
}  // namespace pkm_workspace
