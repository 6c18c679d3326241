// SPDX-License-Identifier: BSD-3-Clause
#include <limits>

#include "pkm_workspace/machine/catalogue.h"
#include "problem.h"
#include "rows.h"
#include "support/machines.h"

namespace pkm_workspace
{
namespace bench
{
namespace
{
constexpr double INFINITE = std::numeric_limits<double>::infinity();

struct Case
{
  std::string way;
  Criterion criterion;
};

/// Motors, drives and encoders of a machine with struts of one metre.
Criterion ofMotors()
{
  Criterion criterion;
  criterion.joint_speed_max = { 1.0, 1.0, 1.0 };
  criterion.joint_effort_max = { 280.0, 280.0, 280.0 };
  criterion.joint_stiffness = { 1e6, 1e6, 1e6 };
  criterion.joint_error_max = { 1e-5, 1e-5, 1e-5 };
  return criterion;
}

Zone zoneAt(const Eigen::Vector3d& center, ZoneKind kind, double radius)
{
  Zone zone;
  zone.kind = kind;
  zone.pose.translation = center;
  zone.radius = radius;
  zone.height = INFINITE;
  zone.sides = Eigen::Vector3d::Constant(2.0 * radius);
  return zone;
}

/// The bound is one that makes the region smaller by a tenth or so.
template <class Change>
Case with(const std::string& way, const Change& change)
{
  Case result{ way, ofMotors() };
  change(result.criterion);
  return result;
}

Case withZone(const std::string& way, const Eigen::Vector3d& center, ZoneKind kind)
{
  return with(way, [&](Criterion& c) { c.zones = { zoneAt(center, kind, 0.05) }; });
}

std::vector<Case> cases(const Eigen::Vector3d& zero)
{
  return {
    { OURS + std::string(", psi only"), Criterion() },
    with("force factors", [](Criterion& c) { c.force_min = 0.55; }),
    with("condition number", [](Criterion& c) { c.kappa_max = 3.2; }),
    with("tool speed", [](Criterion& c) { c.tool_speed_min = 0.45; }),
    with("tool force", [](Criterion& c) { c.tool_force_min = 155.0; }),
    with("stiffness", [](Criterion& c) { c.stiffness_min = 3e5; }),
    with("position error", [](Criterion& c) { c.position_error_max = 3.2e-5; }),
    with("strut angle", [](Criterion& c) { c.strut_angle_max = 0.8; }),
    with("all of these together",
         [](Criterion& c) {
           c.force_min = 0.55;
           c.kappa_max = 3.2;
           c.tool_speed_min = 0.45;
           c.tool_force_min = 155.0;
           c.stiffness_min = 3e5;
           c.position_error_max = 3.2e-5;
           c.strut_angle_max = 0.8;
         }),
    withZone("out of a column through the middle", zero, ZoneKind::CYLINDER),
    withZone("out of a column beside it", zero + Eigen::Vector3d(0.2, 0.2, 0.0), ZoneKind::CYLINDER),
  };
}

/// Zones that end along z leave no rails along z without limits.
std::vector<Case> casesWithEnds(const Eigen::Vector3d& zero)
{
  std::vector<Case> result = cases(zero);
  result.push_back(withZone("out of a sphere in the middle", zero, ZoneKind::SPHERE));
  result.push_back(withZone("out of a box beside it", zero + Eigen::Vector3d(0.2, 0.2, 0.0), ZoneKind::BOX));
  return result;
}

void addCase(const std::string& name, const Machine& machine, bool is_square, const Case& what)
{
  addRow(name, "1e-3", what.way, 5, [=](benchmark::State& state) {
    LargestRegion region;
    for (auto _ : state)
      region = findByOurWay(machine, is_square, 1e-3, what.criterion);
    if (region.status != LargestRegion::Status::PROVEN)
      state.SkipWithError("not proved");
    state.counters["edge"] = region.size;
    state.counters["centers"] = static_cast<double>(region.boxes);
    state.counters["points"] = static_cast<double>(region.verification_boxes);
  })->UseRealTime();
}

/// Struts, sliders and platform within 0.1 mm for struts of 1 m, and rails within an angle: within any, parallel ones
/// have sets that do not end.
Machine tolerated(const Machine& machine, double direction)
{
  Machine::Legs legs = machine.legs();
  for (Leg& leg : legs)
  {
    StrutTolerance& tolerance = slidingStrut(leg).tolerance;
    tolerance.length = 1e-4;
    tolerance.direction = direction;
    tolerance.slider = tolerance.platform = { 1e-4, 1e-4, 1e-4 };
  }
  return { machine.name(), legs, machine.zero() };
}
}  // namespace

void addConditionRows()
{
  const Case within{ "within tolerances", Criterion() };
  for (const Case& what : casesWithEnds(orthoglide().zero()))
    addCase("Orthoglide, cube, one more condition", orthoglide(), false, what);
  addCase("Orthoglide, cube, one more condition", tolerated(orthoglide(), 1e-4), false, within);
  for (const Case& what : cases(uranesx().zero()))
    addCase("UraneSX, square, one more condition", uranesx(), true, what);
  addCase("UraneSX, square, one more condition", tolerated(uranesx(), 0.0), true, within);
  for (const Case& what : casesWithEnds(test::crooked(4).zero()))
    addCase("a crooked machine, cube, one more condition", test::crooked(4), false, what);
  addCase("a crooked machine, cube, one more condition", tolerated(test::crooked(4), 1e-4), false, within);
}
}  // namespace bench
}  // namespace pkm_workspace
