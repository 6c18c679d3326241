// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <string>

#include "pkm_workspace/dexterity/criterion_bounds.h"
#include "pkm_workspace/dexterity/criterion_text.h"
#include "pkm_workspace/machine/machine.h"

namespace pkm_workspace
{
/// A number of each leg that bounds of a Criterion are reckoned with, and all that people and programs are told of it.
struct JointDatum
{
  const char* name;                ///< of parameter, message field and JSON member; an option has '-' for '_'
  JointValues Criterion::*values;  ///< the numbers themselves, > 0; 0 where none is known
  double Criterion::*bound;        ///< the bound that they count for
  bool is_needed;                  ///< whether that bound cannot do without
  double Leg::*own;                ///< what a machine's legs tell of themselves; nullptr where that is nothing
  double most;                     ///< LARGEST_BOUND, or the most that makes sense
  const char* unit;
  const char* angle_unit;  ///< where the joint's value is an angle
  const char* subject;     ///< "the largest speed"
  const char* brief;       ///< its part of describe(), {} for the numbers
  const char* help;        ///< of its option

  /// Whether it is itself a bound, of each leg: the best value of its bound is found without it.
  bool isBound() const { return values == &Criterion::strut_tilt_max; }
  bool isAskedBy(const Criterion& criterion) const
  {
    return criterion.*bound > 0.0 && criterion.*values != JointValues{};
  }
};

// clang-format off
inline constexpr std::array<JointDatum, 6> JOINT_DATA = { {
  { "joint_speed_max", &Criterion::joint_speed_max, &Criterion::tool_speed_min, true, &Leg::speed, LARGEST_BOUND,
    "m/s", "rad/s", "the largest speed", " by joints up to {} m/s",
    "largest speed of a joint, of one that turns [rad/s]; without it, the URDF's velocity" },
  { "joint_effort_max", &Criterion::joint_effort_max, &Criterion::tool_force_min, true, &Leg::effort, LARGEST_BOUND,
    "N", "N m", "the largest force", " by joints up to {} N",
    "largest force of a joint, of one that turns torque [N m]; without it, the URDF's effort" },
  { "joint_stiffness", &Criterion::joint_stiffness, &Criterion::stiffness_min, true, nullptr, LARGEST_BOUND, "N/m",
    "N m/rad", "the stiffness of its drive", " by drives of {} N/m",
    "stiffness of a joint's drive along its rail, of one that turns [N m/rad]" },
  { "strut_stiffness", &Criterion::strut_stiffness, &Criterion::stiffness_min, false, nullptr, LARGEST_BOUND, "N/m",
    "N/m", "the stiffness of its strut", " and struts of {} N/m",
    "stiffness of a strut along itself; without it, struts are rigid" },
  { "joint_error_max", &Criterion::joint_error_max, &Criterion::position_error_max, true, nullptr, LARGEST_BOUND, "m",
    "rad", "the largest error", " by joints off by up to {} m",
    "largest error of a joint's position (encoder, backlash), of one that turns [rad]" },
  { "strut_tilt_max", &Criterion::strut_tilt_max, &Criterion::ball_tilt_max, false, nullptr, QUARTER_TURN, "rad",
    "rad", "the largest tilt of its strut's ball joints", " and those of each strut by at most {} rad",
    "largest tilt of the ball joints of a strut, where it is less than that of all" },
} };
// clang-format on

/// The bound that they count for.
const CriterionBound& boundOf(const JointDatum& datum);

/// "1" where all legs have one number, else "(1, 2, 1)", each by all its digits.
std::string exact(const JointValues& values);
/// "positive and finite (1e-100 to 1e100)", what each of the numbers has to be.
std::string rangeOf(const JointDatum& datum);

/// What is known of the joints that the criterion counts with, in words: "" where that is nothing.
/// @param bound of the criterion that it is said of
std::string jointDataInWords(const Criterion& criterion, double Criterion::*bound);

/// The same criterion with what the machine tells of its joints wherever a number is needed and not given.
Criterion withJointData(const Machine& machine, Criterion criterion);

/// Tells which number is out of range.
void validateJointData(const Criterion& criterion, Problems& problems);
/// Tells what the criterion asks of this machine and cannot be proved of it: a number that is needed and not known, a
/// passive hinge whose limits are no stops of its strut.
void requireProvable(const Machine& machine, const Criterion& criterion, Problems& problems);
}  // namespace pkm_workspace
