// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <string>

#include "pkm_workspace/dexterity/point_evaluation.h"

namespace pkm_workspace
{
/// Where a bound may be any positive number, it starts here and ends at LARGEST_BOUND: squares of it stay ordinary
/// numbers.
constexpr double LEAST_POSITIVE = 1e-100;
constexpr double LARGEST_BOUND = 1e100;
/// Where a bound is an angle, it ends here, at or below pi / 2.
constexpr double QUARTER_TURN = 1.5707963;

/// A number of a Criterion, and all that people and programs are told of it.
struct CriterionBound
{
  const char* name;                ///< of parameter, message field and JSON member; an option has '-' for '_'
  double Criterion::*value;        ///< the number itself
  double Criterion::*lower_value;  ///< the lower bound that it must not be below; nullptr where there is none
  Limit::Kind kind;                ///< what it is at a point
  bool is_lower;                   ///< what is bounded is at least the number; otherwise at most
  bool is_optional;                ///< 0 stands for none. Of those that are not, every dextrous set has one.
  double least;                    ///< LEAST_POSITIVE, or the least that makes sense
  double most;                     ///< LARGEST_BOUND, or the most that makes sense
  /// What is bounded, where there are values; nullptr where its condition tells it for each leg.
  Interval (*enclose)(const PointEvaluation& there);
  const char* quantity;  ///< of what kind the number is
  const char* unit;      ///< empty for a number without unit
  const char* subject;   ///< what is bounded
  const char* brief;     ///< its part of describe(), {} for the number
  const char* full;      ///< its part of a definition of the set, {} for the number
  const char* help;      ///< of its option

  bool isAskedBy(const Criterion& criterion) const
  {
    return is_optional ? criterion.*value > 0.0 : criterion.set == Criterion::Set::DEXTROUS;
  }
};

/// { 1 / x : x in the set }, which is not negative.
Interval inverse(const Interval& x);

/// In the order of Limit::Kind, which files and messages have, too. A bound more is a number of Criterion, a kind of
/// Limit and a row here; its fields of CriterionRequest.msg and Hypotheses.msg with their row in
/// src/ros/criterion_fields.h; its constant in BindingLimit.msg, its row in docs/node.md, and what the tests' oracle
/// knows of it. What it counts with besides, for each joint, is a row of joint_data.h.
// clang-format off
inline constexpr std::array<CriterionBound, 12> CRITERION_BOUNDS = { {
  { "psi_min", &Criterion::psi_min, nullptr, Limit::Kind::PSI_MIN, true, false, LEAST_POSITIVE,
    LARGEST_BOUND,
    [](const PointEvaluation& there) { return there.psi[0]; },
    "transmission factor", "", "the least velocity transmission factor",
    " with psi in [{}", ", with all velocity transmission factors in [{}",
    "least velocity transmission factor that is allowed" },
  { "psi_max", &Criterion::psi_max, &Criterion::psi_min, Limit::Kind::PSI_MAX, false, false, LEAST_POSITIVE,
    LARGEST_BOUND,
    [](const PointEvaluation& there) { return there.psi[2]; },
    "transmission factor", "", "the largest velocity transmission factor",
    ", {}]", ", {}]",
    "largest velocity transmission factor that is allowed" },
  { "force_min", &Criterion::force_min, nullptr, Limit::Kind::FORCE_MIN, true, true, LEAST_POSITIVE,
    LARGEST_BOUND, [](const PointEvaluation& there) { return inverse(there.psi[2]); },
    "transmission factor", "", "the least force transmission factor",
    ", force factors at least {}", ", with force transmission factors of at least {}",
    "least force transmission factor 1 / psi that is allowed; without it, any" },
  { "force_max", &Criterion::force_max, &Criterion::force_min, Limit::Kind::FORCE_MAX, false, true, LEAST_POSITIVE,
    LARGEST_BOUND, [](const PointEvaluation& there) { return inverse(there.psi[0]); },
    "transmission factor", "", "the largest force transmission factor",
    ", force factors at most {}", ", with force transmission factors of at most {}",
    "largest force transmission factor 1 / psi that is allowed; without it, any" },
  { "kappa_max", &Criterion::kappa_max, nullptr, Limit::Kind::KAPPA_MAX, false, true, 1.0, LARGEST_BOUND,
    [](const PointEvaluation& there) { return there.condition; },
    "condition number", "", "the condition number of J",
    ", condition number at most {}", ", with a condition number of J of at most {}",
    "largest condition number of J (largest psi over least psi) that is allowed; without it, any" },
  { "tool_speed_min", &Criterion::tool_speed_min, nullptr, Limit::Kind::TOOL_SPEED_MIN, true, true, LEAST_POSITIVE,
    LARGEST_BOUND, nullptr, "speed", "m/s", "the speed of the tool in every direction",
    ", tool speed at least {} m/s", ", with a tool speed of at least {} m/s in every direction",
    "speed that the joints have to allow the tool in every direction; without it, any" },
  { "tool_force_min", &Criterion::tool_force_min, nullptr, Limit::Kind::TOOL_FORCE_MIN, true, true, LEAST_POSITIVE,
    LARGEST_BOUND, nullptr, "force", "N", "the force of the tool in every direction",
    ", tool force at least {} N", ", with a static tool force of at least {} N in every direction",
    "static force that the joints have to allow the tool in every direction; without it, any" },
  { "stiffness_min", &Criterion::stiffness_min, nullptr, Limit::Kind::STIFFNESS_MIN, true, true, LEAST_POSITIVE,
    LARGEST_BOUND, nullptr, "stiffness", "N/m", "the stiffness at the tool in the softest direction",
    ", stiffness at least {} N/m", ", with a stiffness of at least {} N/m in every direction",
    "least stiffness at the tool in every direction; without it, any" },
  { "position_error_max", &Criterion::position_error_max, nullptr, Limit::Kind::POSITION_ERROR_MAX, false, true,
    LEAST_POSITIVE, LARGEST_BOUND, nullptr, "length", "m", "the largest error of the tool's position",
    ", position error at most {} m", ", with an error of the tool's position of at most {} m",
    "largest error of the tool's position, to first order, that the joints' errors may cause; without it, any" },
  { "strut_angle_min", &Criterion::strut_angle_min, nullptr, Limit::Kind::STRUT_ANGLE_MIN, true, true, LEAST_POSITIVE,
    QUARTER_TURN, nullptr, "angle", "rad", "the angle between the strut and its rail",
    ", struts at least {} rad off their rails", ", with struts at least {} rad off their rails",
    "least angle between a strut and its rail that is allowed; without it, any" },
  { "strut_angle_max", &Criterion::strut_angle_max, &Criterion::strut_angle_min, Limit::Kind::STRUT_ANGLE_MAX, false,
    true, LEAST_POSITIVE, QUARTER_TURN, nullptr, "angle", "rad", "the angle between the strut and its rail",
    ", struts at most {} rad off their rails", ", with struts at most {} rad off their rails",
    "largest angle between a strut and its rail that is allowed; without it, any" },
  { "ball_tilt_max", &Criterion::ball_tilt_max, nullptr, Limit::Kind::BALL_TILT_MAX, false, true, LEAST_POSITIVE,
    QUARTER_TURN, nullptr, "angle", "rad", "the tilt of the strut's ball joints",
    ", ball joints tilted by at most {} rad", ", with ball joints tilted by at most {} rad",
    "largest tilt of the ball joints from their axes that is allowed; without it, any" },
} };
// clang-format on

/// The bound that is this limit at a point, or nullptr: reach, joints and aspect have no number in a Criterion.
const CriterionBound* boundOf(Limit::Kind kind);
/// The bound that it must not be below, or nullptr.
const CriterionBound* lowerBoundOf(const CriterionBound& bound);
/// "m/s", or "without unit".
std::string unitOf(const CriterionBound& bound);
/// "positive and finite (1e-100 to 1e100)", the values that it may have besides 0 for none.
std::string rangeOf(const CriterionBound& bound);
/// "a number >= force_min, or 0 for none, without unit".
std::string allowedInWords(const CriterionBound& bound);

/// What all bounds that the criterion asks for say, one after the other.
/// @param part CriterionBound::brief or CriterionBound::full
std::string boundsInWords(const Criterion& criterion, const char* CriterionBound::*part);
}  // namespace pkm_workspace
