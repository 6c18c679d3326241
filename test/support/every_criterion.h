// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "support/driven_criteria.h"
#include "support/machines.h"
#include "support/zones.h"

namespace pkm_workspace
{
namespace test
{
/// Bounds on transmission factors and on the condition number, and none, in each aspect.
inline std::vector<Criterion> everyCriterion()
{
  std::vector<Criterion> criteria(9);
  criteria[1].psi_min = 1.0 / 3.0;
  criteria[1].psi_max = 3.0;
  criteria[2].aspect = Criterion::Aspect::OTHER;
  criteria[3].set = Criterion::Set::REACHABLE;
  criteria[4].set = Criterion::Set::REACHABLE;
  criteria[4].aspect = Criterion::Aspect::BOTH;
  for (std::size_t k = 5; k < 8; ++k)
    criteria[k].set = Criterion::Set::REACHABLE;
  criteria[5].force_min = 0.4;
  criteria[6].force_max = 3.0;
  criteria[7].kappa_max = 4.0;
  criteria[8].force_min = 0.6;
  criteria[8].force_max = 1.9;
  criteria[8].kappa_max = 2.5;
  return criteria;
}

/// The same machine with limits of passive hinges.
inline Machine hinged(const Machine& machine)
{
  Machine::Legs legs = machine.legs();
  for (Leg& leg : legs)
  {
    const IntervalVector& axis = slidingStrut(leg).axis;
    const IntervalVector across = cross(axis, IntervalVector{ 0.3, 0.5, 0.7 });
    passiveJoints(leg).stops = { { "hinge", false, -0.3, across, Interval(-0.2 * machine.scale()) },
                                 { "hinge", true, 0.3, Interval(-1.0) * across, Interval(-0.1 * machine.scale()) } };
  }
  return Machine("hinged", legs, machine.zero());
}

/// A machine, and what is asked of it.
struct MachineCase
{
  std::string name;
  Machine machine;
  Criterion criterion;
};

/// Every condition that there is, by itself and with others.
inline std::vector<MachineCase> everyCondition(const Machine& machine)
{
  std::vector<MachineCase> cases;
  for (const Criterion& criterion : everyCriterion())
    cases.push_back({ describe(criterion), machine, criterion });
  for (const auto& [name, criterion] : drivenCriteria(machine))
    cases.push_back({ name, machine, criterion });
  cases.push_back({ "joint limits", limited(machine), everyCriterion()[3] });
  cases.back().criterion.joint_limits = true;
  cases.push_back({ "joint limits and factors", limited(machine), everyCriterion()[1] });
  cases.back().criterion.joint_limits = true;
  if (std::all_of(machine.legs().begin(), machine.legs().end(),
                  [](const Leg& leg) { return std::holds_alternative<SlidingStrut>(leg.kind); }))
  {
    cases.push_back({ "hinges", hinged(machine), withMotors(machine) });
    cases.back().criterion.hinge_limits = true;
  }
  Random random(SEED);
  for (int k = 0; k < 4; ++k)
  {
    cases.push_back({ "zones " + std::to_string(k), machine, everyCriterion()[k % 2 == 0 ? 4 : 0] });
    cases.back().criterion.zones = randomZones(random, spaceOf(machine));
    cases.back().criterion.tool_radius = 0.02 * machine.scale();
  }
  return cases;
}
}  // namespace test
}  // namespace pkm_workspace
