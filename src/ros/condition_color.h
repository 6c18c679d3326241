// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "pkm_workspace/dexterity/condition.h"
#include "pkm_workspace/ros/legend.h"

namespace pkm_workspace
{
/// A colour by its numbers from 0 to 255.
constexpr Color opaque(int r, int g, int b)
{
  return { static_cast<float>(r) / 255.0F, static_cast<float>(g) / 255.0F, static_cast<float>(b) / 255.0F, 1.0F };
}

// A condition without a row does not compile.
#pragma GCC diagnostic push
#pragma GCC diagnostic error "-Wswitch"

/// The colour of a condition in all pictures. What is asked for most has the colours of M. Okabe and K. Ito ("Color
/// Universal Design", 2008), which people tell apart whatever colours they see; the others are as far from these and
/// from each other, as a test holds. Bounds of velocity and of force factors on the same side share one: only the
/// closer of the two ends a set.
constexpr Color conditionColor(ConditionKind kind)
{
  using Kind = ConditionKind;
  // clang-format off
  switch (kind)
  {
    case Kind::REACH: return opaque(0, 0, 0);
    case Kind::JOINT_LOWER: return opaque(86, 180, 233);
    case Kind::JOINT_UPPER: return opaque(0, 114, 178);
    case Kind::ASPECT: return opaque(64, 0, 64);
    case Kind::PSI_MIN: return opaque(230, 159, 0);
    case Kind::FORCE_MAX: return opaque(230, 159, 0);
    case Kind::PSI_MAX: return opaque(204, 121, 167);
    case Kind::FORCE_MIN: return opaque(204, 121, 167);
    case Kind::KAPPA_MAX: return opaque(240, 228, 66);
    case Kind::TOOL_SPEED_MIN: return opaque(213, 94, 0);
    case Kind::TOOL_FORCE_MIN: return opaque(128, 0, 224);
    case Kind::STIFFNESS_MIN: return opaque(0, 32, 128);
    case Kind::POSITION_ERROR_MAX: return opaque(160, 0, 128);
    case Kind::STRUT_ANGLE_MIN: return opaque(96, 128, 64);
    case Kind::STRUT_ANGLE_MAX: return opaque(0, 158, 115);
    case Kind::BALL_TILT_MAX: return opaque(96, 32, 0);
    case Kind::HINGE_LOWER: return opaque(192, 224, 128);
    case Kind::HINGE_UPPER: return opaque(96, 64, 64);
    case Kind::KEEP_IN: return opaque(176, 240, 240);
    case Kind::KEEP_OUT: return opaque(0, 240, 176);
    case Kind::JOINT_SPEED: case Kind::JOINT_ACCELERATION: break;  // of paths, which end no set
  }
  // clang-format on
  return opaque(128, 128, 128);
}
#pragma GCC diagnostic pop
}  // namespace pkm_workspace
