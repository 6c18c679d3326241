// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pkm_workspace/CriterionRequest.h>
#include <pkm_workspace/Hypotheses.h>

#include <array>
#include <cstdint>
#include <iterator>

#include "pkm_workspace/dexterity/criterion_bounds.h"
#include "pkm_workspace/dexterity/joint_data.h"

namespace pkm_workspace
{
/// Where the messages have the bounds.
struct MessageFields
{
  double Criterion::*value;
  double CriterionRequest::*request;
  double Hypotheses::*hypotheses;
};
inline constexpr MessageFields FIELDS[] = {
  { &Criterion::psi_min, &CriterionRequest::psi_min, &Hypotheses::psi_min },
  { &Criterion::psi_max, &CriterionRequest::psi_max, &Hypotheses::psi_max },
  { &Criterion::force_min, &CriterionRequest::force_min, &Hypotheses::force_min },
  { &Criterion::force_max, &CriterionRequest::force_max, &Hypotheses::force_max },
  { &Criterion::kappa_max, &CriterionRequest::kappa_max, &Hypotheses::kappa_max },
  { &Criterion::tool_speed_min, &CriterionRequest::tool_speed_min, &Hypotheses::tool_speed_min },
  { &Criterion::tool_force_min, &CriterionRequest::tool_force_min, &Hypotheses::tool_force_min },
  { &Criterion::stiffness_min, &CriterionRequest::stiffness_min, &Hypotheses::stiffness_min },
  { &Criterion::position_error_max, &CriterionRequest::position_error_max, &Hypotheses::position_error_max },
  { &Criterion::strut_angle_min, &CriterionRequest::strut_angle_min, &Hypotheses::strut_angle_min },
  { &Criterion::strut_angle_max, &CriterionRequest::strut_angle_max, &Hypotheses::strut_angle_max },
  { &Criterion::ball_tilt_max, &CriterionRequest::ball_tilt_max, &Hypotheses::ball_tilt_max },
};

/// Where they have what is known of the joints.
struct JointFields
{
  JointValues Criterion::*values;
  CriterionRequest::_joint_speed_max_type CriterionRequest::*request;
  Hypotheses::_joint_speed_max_type Hypotheses::*hypotheses;
};
inline constexpr JointFields JOINT_FIELDS[] = {
  { &Criterion::joint_speed_max, &CriterionRequest::joint_speed_max, &Hypotheses::joint_speed_max },
  { &Criterion::joint_effort_max, &CriterionRequest::joint_effort_max, &Hypotheses::joint_effort_max },
  { &Criterion::joint_stiffness, &CriterionRequest::joint_stiffness, &Hypotheses::joint_stiffness },
  { &Criterion::strut_stiffness, &CriterionRequest::strut_stiffness, &Hypotheses::strut_stiffness },
  { &Criterion::joint_error_max, &CriterionRequest::joint_error_max, &Hypotheses::joint_error_max },
  { &Criterion::strut_tilt_max, &CriterionRequest::strut_tilt_max, &Hypotheses::strut_tilt_max },
};

constexpr bool fieldsAreInOrder()
{
  bool in_order = std::size(FIELDS) == CRITERION_BOUNDS.size();
  for (std::size_t k = 0; in_order && k < CRITERION_BOUNDS.size(); ++k)
    in_order = FIELDS[k].value == CRITERION_BOUNDS[k].value;
  in_order = in_order && std::size(JOINT_FIELDS) == JOINT_DATA.size();
  for (std::size_t k = 0; in_order && k < JOINT_DATA.size(); ++k)
    in_order = JOINT_FIELDS[k].values == JOINT_DATA[k].values;
  return in_order;
}
static_assert(fieldsAreInOrder(), "each bound needs its fields of both messages, in the order of CRITERION_BOUNDS");

template <class Message>
constexpr bool numbersAsCriterion()
{
  return int(Message::DEXTROUS) == 1 && int(Message::REACHABLE) == 2 && int(Message::OWN) == 1 &&
         int(Message::OTHER) == 2 && int(Message::BOTH) == 3;
}
static_assert(numbersAsCriterion<CriterionRequest>() && numbersAsCriterion<Hypotheses>(), "messages differ");

/// The number of a choice in messages, where 0 stands for the default.
template <class Choice>
std::uint8_t toNumber(Choice choice)
{
  return static_cast<std::uint8_t>(static_cast<int>(choice) + 1);
}

/// @param names of the choices @return the fallback for any other number
template <class Choice, std::size_t N>
Choice fromNumber(std::uint8_t number, const std::array<const char*, N>& names, Choice fallback)
{
  return number >= 1 && number <= names.size() ? static_cast<Choice>(number - 1) : fallback;
}
}  // namespace pkm_workspace
