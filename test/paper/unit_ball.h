// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "pkm_workspace/dexterity/verdict.h"

namespace pkm_workspace
{
namespace test
{
/// The squared distances from the origin to the farthest and the nearest point of the box, rounded.
inline double farthest(const Box& box)
{
  return box.lower.cwiseAbs().cwiseMax(box.upper.cwiseAbs()).squaredNorm();
}

inline double nearest(const Box& box)
{
  return box.lower.cwiseMax(-box.upper).cwiseMax(0.0).squaredNorm();
}

/// A workspace whose regions are known: the ball of radius 1. UNDECIDED within more than rounding of its border.
inline BoxVerdict unitBall(const Box& box)
{
  constexpr double BAND = 1e-12;
  if (farthest(box) < 1.0 - BAND)
    return BoxVerdict::INSIDE;
  return nearest(box) > 1.0 + BAND ? BoxVerdict::OUTSIDE : BoxVerdict::UNDECIDED;
}
}  // namespace test
}  // namespace pkm_workspace
