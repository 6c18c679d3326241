// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "pkm_workspace/dexterity/criterion.h"
#include "pkm_workspace/machine/machine.h"

namespace pkm_workspace
{
namespace test
{
/// Telescopic struts have no angle against a rail.
inline bool hasTelescopes(const Machine& machine)
{
  return std::any_of(machine.legs().begin(), machine.legs().end(),
                     [](const Leg& leg) { return std::holds_alternative<TelescopicStrut>(leg.kind); });
}

/// What is known of motors, drives and encoders: different for each leg.
inline Criterion withMotors(const Machine& machine)
{
  Criterion criterion;
  criterion.set = Criterion::Set::REACHABLE;
  criterion.joint_speed_max = { 1.0, 1.2, 0.9 };
  criterion.joint_effort_max = { 200.0, 150.0, 250.0 };
  criterion.joint_stiffness = { 1e6, 2e6, 1.5e6 };
  criterion.joint_error_max = { 1e-5 * machine.scale(), 2e-5 * machine.scale(), 1.5e-5 * machine.scale() };
  return criterion;
}

/// Each condition of a machine with motors by itself, with its name, then all of them.
inline std::vector<std::pair<std::string, Criterion>> drivenCriteria(const Machine& machine)
{
  const Criterion none = withMotors(machine);
  Criterion all = none;
  std::vector<std::pair<std::string, Criterion>> criteria;
  const auto add = [&](const char* name, double Criterion::*bound, double value) {
    Criterion one = none;
    one.*bound = all.*bound = value;
    criteria.emplace_back(name, one);
  };
  add("tool_speed_min", &Criterion::tool_speed_min, 0.6);
  add("tool_force_min", &Criterion::tool_force_min, 75.0);
  add("stiffness_min", &Criterion::stiffness_min, 3e5);
  add("position_error_max", &Criterion::position_error_max, 6e-5 * machine.scale());
  add("strut_angle_max", &Criterion::strut_angle_max, 0.8);
  add("ball_tilt_max", &Criterion::ball_tilt_max, 0.5);
  criteria.emplace_back("soft struts", none);
  criteria.back().second.stiffness_min = 2e5;
  criteria.back().second.strut_stiffness = { 3e6, 4e6, 5e6 };
  criteria.emplace_back("tilts of each strut", none);
  criteria.back().second.ball_tilt_max = 0.6;
  criteria.back().second.strut_tilt_max = { 0.5, 0.0, 0.4 };
  if (!hasTelescopes(machine))
  {
    criteria.emplace_back("struts off their rails", none);
    criteria.back().second.strut_angle_min = 0.1;
  }
  criteria.emplace_back("everything", all);
  criteria.back().second.set = Criterion::Set::DEXTROUS;
  return criteria;
}
}  // namespace test
}  // namespace pkm_workspace
