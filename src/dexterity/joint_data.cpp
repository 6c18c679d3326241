// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/dexterity/joint_data.h"

#include <algorithm>
#include <cmath>

#include "pkm_workspace/dexterity/criterion_bounds.h"
#include "pkm_workspace/dexterity/machine_model.h"
#include "pkm_workspace/interval/decimal.h"

namespace pkm_workspace
{
const CriterionBound& boundOf(const JointDatum& datum)
{
  return *std::find_if(CRITERION_BOUNDS.begin(), CRITERION_BOUNDS.end(),
                       [&datum](const CriterionBound& bound) { return bound.value == datum.bound; });
}

std::string exact(const JointValues& values)
{
  if (values[0] == values[1] && values[1] == values[2])
    return exact(values[0]);
  return "(" + exact(values[0]) + ", " + exact(values[1]) + ", " + exact(values[2]) + ")";
}

std::string rangeOf(const JointDatum& datum)
{
  return datum.most < LARGEST_BOUND ? "positive and at most " + exact(datum.most)
                                    : "positive and finite (1e-100 to 1e100)";
}

namespace
{
/// "1 m/s", "(1, 2, 1) m/s", or where some joints turn and some do not "(1 m/s, 2 rad/s, 1 m/s)".
std::string withUnits(const JointDatum& datum, const Criterion& criterion)
{
  const JointValues& values = criterion.*datum.values;
  const auto unitOf = [&](std::size_t leg) {
    return std::string(" ") + (criterion.has_angle[leg] ? datum.angle_unit : datum.unit);
  };
  if (unitOf(0) == unitOf(1) && unitOf(1) == unitOf(2))
    return exact(values) + unitOf(0);
  return "(" + exact(values[0]) + unitOf(0) + ", " + exact(values[1]) + unitOf(1) + ", " + exact(values[2]) +
         unitOf(2) + ")";
}
}  // namespace

std::string jointDataInWords(const Criterion& criterion, double Criterion::*bound)
{
  std::string text;
  for (const JointDatum& datum : JOINT_DATA)
    if (datum.bound == bound && datum.isAskedBy(criterion))
    {
      const std::string words = datum.brief;
      const std::string numbers = std::string("{} ") + datum.unit;
      const std::size_t place = words.find(numbers);
      text += words.substr(0, place) + withUnits(datum, criterion) + words.substr(place + numbers.size());
    }
  return text;
}

Criterion withJointData(const Machine& machine, Criterion criterion)
{
  for (std::size_t leg = 0; leg < 3; ++leg)
    criterion.has_angle[leg] = hasAngle(machine.legs()[leg]);
  for (const JointDatum& datum : JOINT_DATA)
    for (int leg = 0; datum.own != nullptr && criterion.*datum.bound > 0.0 && leg < 3; ++leg)
    {
      double& value = (criterion.*datum.values)[static_cast<std::size_t>(leg)];
      const double own = machine.leg(leg).*datum.own;
      if (value == 0.0 && std::isfinite(own))
        value = own;
    }
  return criterion;
}

void validateJointData(const Criterion& criterion, Problems& problems)
{
  for (const JointDatum& datum : JOINT_DATA)
    for (const double value : criterion.*datum.values)
      if (!(value >= LEAST_POSITIVE && value <= datum.most) && value != 0.0)
      {
        complain(problems, datum.name, " = ", exact(criterion.*datum.values), " (", datum.subject, " [", datum.unit,
                 "]) must be ", rangeOf(datum), ", one number or one for each joint");
        break;
      }
}

void requireProvable(const Machine& machine, const Criterion& criterion, Problems& problems)
{
  for (int leg = 0; criterion.hinge_limits && leg < 3; ++leg)
    for (const std::string& reason : passiveJoints(machine.leg(leg)).open_hinges)
      complain(problems, "hinge_limits cannot be proved: ", reason);
  for (int leg = 0; criterion.strut_angle_min > 0.0 && leg < 3; ++leg)
    if (std::holds_alternative<TelescopicStrut>(machine.leg(leg).kind))
      complain(problems, "strut_angle_min cannot hold: joint '", machine.leg(leg).joint,
               "' lengthens its strut, which has no angle against the way of its drive; leave it at 0");
  // of a machine that is off by its tolerances, joints may be exact
  const auto isNeeded = [&](const JointDatum& datum) {
    return datum.is_needed && !(datum.bound == &Criterion::position_error_max && machine.hasTolerances());
  };
  for (const JointDatum& datum : JOINT_DATA)
    for (std::size_t leg = 0; isNeeded(datum) && criterion.*datum.bound > 0.0 && leg < 3; ++leg)
      if ((criterion.*datum.values)[leg] == 0.0)
      {
        const std::string joint = "'" + machine.leg(static_cast<int>(leg)).joint + "'";
        const std::string source = datum.own == nullptr ? "" : ", which its URDF does not tell";
        complain(problems, boundOf(datum).name, " needs ", datum.subject, " [",
                 hasAngle(machine.legs()[leg]) ? datum.angle_unit : datum.unit, "] of joint ", joint, source, ": give ",
                 datum.name, ", one number or one for each joint");
      }
}

const Criterion& validated(const Machine& machine, const Criterion& criterion)
{
  Problems problems;
  criterion.validate(problems);
  requireProvable(machine, criterion, problems);
  throwProblems(problems);
  return criterion;
}
}  // namespace pkm_workspace
