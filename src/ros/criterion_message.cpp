// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/ros/criterion_message.h"

#include <algorithm>
#include <iterator>
#include <limits>

#include "criterion_fields.h"
#include "pkm_workspace/dexterity/criterion_bounds.h"
#include "pkm_workspace/dexterity/criterion_bytes.h"
#include "pkm_workspace/dexterity/fitting_bounds.h"
#include "pkm_workspace/dexterity/joint_data.h"
#include "pkm_workspace/interval/text_stream.h"
#include "pkm_workspace/machine/ball_axes.h"
#include "pkm_workspace/machine/tolerances.h"
#include "pkm_workspace/ros/conversions.h"
#include "pkm_workspace/ros/solid_message.h"
#include "pkm_workspace/ros/zone_message.h"

namespace pkm_workspace
{
namespace
{
void readSet(const CriterionRequest& request, Criterion& criterion, Problems& problems)
{
  if (request.set <= CriterionRequest::REACHABLE)
    criterion.set = fromNumber(request.set, SET_NAMES, criterion.set);
  else
    problems.push_back("set = " + std::to_string(request.set) + " must be DEFAULT = 0, DEXTROUS = 1 or REACHABLE = 2");
}

/// Of a bound, 0 is the default and +inf none: 0 in a Criterion.
void readBounds(const CriterionRequest& request, Criterion& criterion, Problems& problems)
{
  bool any_without_effect = false;
  for (std::size_t k = 0; k < CRITERION_BOUNDS.size(); ++k)
  {
    const double value = request.*FIELDS[k].request;
    const bool is_optional = CRITERION_BOUNDS[k].is_optional;
    const bool is_none = is_optional && value == std::numeric_limits<double>::infinity();
    any_without_effect |= !is_optional && criterion.set == Criterion::Set::REACHABLE && value != 0.0;
    double& bound = criterion.*FIELDS[k].value;
    bound = is_none ? 0.0 : valueOr(value, bound);
  }
  if (any_without_effect)
    problems.push_back("psi_min and psi_max must be 0 unless the set is DEXTROUS: in a reachable set they are free");
}

bool counts(const JointDatum& datum, JointUse use, const Criterion& criterion)
{
  return use == JointUse::ALL || criterion.*datum.bound != 0.0 ||
         (use == JointUse::SPEEDS_TOO && datum.bound == &Criterion::tool_speed_min);
}

/// Empty for the default; +inf for nothing known.
void readJointData(const CriterionRequest& request, JointUse use, Criterion& criterion, Problems& problems)
{
  for (std::size_t k = 0; k < JOINT_DATA.size(); ++k)
  {
    const auto& values = request.*JOINT_FIELDS[k].request;
    if (values.empty())
      continue;
    if (!counts(JOINT_DATA[k], use, criterion))
      problems.push_back(std::string(JOINT_DATA[k].name) + " must be empty unless " + boundOf(JOINT_DATA[k]).name +
                         " is asked for, which it counts for");
    else if (values.size() != 1 && values.size() != 3)
      problems.push_back(std::string(JOINT_DATA[k].name) + " has " + std::to_string(values.size()) +
                         " numbers, it must have one for all legs, or three, or none for the node's");
    else
      for (std::size_t leg = 0; leg < 3; ++leg)
      {
        const double value = values[values.size() == 1 ? 0 : leg];
        (criterion.*JOINT_FIELDS[k].values)[leg] = value == std::numeric_limits<double>::infinity() ? 0.0 : value;
      }
  }
}

void readSwitch(const char* name, std::uint8_t value, bool& target, Problems& problems)
{
  if (value == CriterionRequest::ON || value == CriterionRequest::OFF)
    target = value == CriterionRequest::ON;
  else if (value != CriterionRequest::DEFAULT)
    problems.push_back(std::string(name) + " = " + std::to_string(value) + " must be DEFAULT = 0, ON = 1 or OFF = 2");
}

/// Besides the node's own, unless these are off.
void readZonesOf(const CriterionRequest& request, Criterion& criterion, Problems& problems)
{
  bool counts_own = true;
  readSwitch("own_zones", request.own_zones, counts_own, problems);
  if (!counts_own)
    criterion.zones.clear();
  criterion.tool_radius = request.tool_radius == INF ? 0.0 : valueOr(request.tool_radius, criterion.tool_radius);
  for (std::size_t k = 0; k < request.zones.size(); ++k)
    try
    {
      criterion.zones.push_back(fromMessage(request.zones[k]));
    }
    catch (const std::invalid_argument& reason)
    {
      problems.push_back("zones[" + std::to_string(k) + "]: " + reason.what());
    }
  if (criterion.zones.empty() && request.tool_radius == 0.0)
    criterion.tool_radius = 0.0;  // the node's counts for nothing
  requireEffect(criterion.tool_radius, criterion.zones, problems);
}

/// They are the machine's; here it is looked whether they count.
void checkBallAxes(const CriterionRequest& request, JointUse use, const Criterion& criterion, Problems& problems)
{
  if (!request.ball_axes.empty() && use != JointUse::ALL && criterion.ball_tilt_max == 0.0)
    problems.push_back("ball_axes must be empty unless ball_tilt_max is asked for, which they count for");
}

/// @pre aspect and joint limits have been read
void choosePsi(const CriterionRequest& request, const Machine& machine, Criterion& criterion, Problems& problems)
{
  if (request.psi == CriterionRequest::DEFAULT)
    return;
  if (request.psi != CriterionRequest::AUTO)
    problems.push_back("psi = " + std::to_string(request.psi) + " must be DEFAULT = 0 or AUTO = 1");
  else if (criterion.set != Criterion::Set::DEXTROUS || request.psi_min != 0.0 || request.psi_max != 0.0)
    problems.push_back("psi = AUTO chooses the bounds of a DEXTROUS set: psi_min and psi_max must be 0 then");
  else
    try
    {
      chooseBounds(machine, criterion);
    }
    catch (const std::invalid_argument& reason)
    {
      problems.push_back(reason.what());
    }
}
}  // namespace

Criterion fromMessage(const CriterionRequest& request, const Machine& machine, const Criterion& defaults,
                      Problems& problems, JointUse use)
{
  Criterion criterion = defaults;
  const std::size_t before = problems.size();
  readSet(request, criterion, problems);
  criterion.aspect = aspectOf(request.aspect, defaults.aspect, problems);
  readBounds(request, criterion, problems);
  readSwitch("joint_limits", request.joint_limits, criterion.joint_limits, problems);
  readSwitch("hinge_limits", request.hinge_limits, criterion.hinge_limits, problems);
  readZonesOf(request, criterion, problems);
  readJointData(request, use, criterion, problems);
  checkBallAxes(request, use, criterion, problems);
  criterion = withJointData(machine, criterion);
  choosePsi(request, machine, criterion, problems);
  const Origin origin = [&request](const std::string& name) {
    bool is_given = false;
    for (std::size_t k = 0; k < CRITERION_BOUNDS.size(); ++k)
      is_given |= name == CRITERION_BOUNDS[k].name && request.*FIELDS[k].request != 0.0;
    return is_given ? "" : "the node's";
  };
  validateCriterion(criterion, origin, problems);
  if (problems.size() == before)
    requireProvable(machineOf(request, machine).value_or(machine), criterion, problems);
  if (problems.size() == before)
    return criterion;
  Criterion valid = defaults;
  valid.set = criterion.set;
  valid.aspect = criterion.aspect;
  return valid;
}

namespace
{
BallAxes ballAxesOf(const CriterionRequest& request)
{
  BallAxes axes;
  for (const geometry_msgs::Vector3& axis : request.ball_axes)
    axes.emplace_back(axis.x, axis.y, axis.z);
  return axes;
}

void readTolerance(const Tolerance& message, GivenTolerances& given)
{
  const ToleranceKind* const kind = toleranceKind(message.kind);
  if (kind == nullptr)
  {
    std::string known;
    for (const ToleranceKind& one : TOLERANCE_KINDS)
      known += (known.empty() ? "" : ", ") + std::string(one.name);
    throw std::invalid_argument("kind = '" + message.kind + "' must be one of " + known);
  }
  if (given.has(*kind))
    throw std::invalid_argument(message.kind + " is listed a second time");
  if (!message.unit.empty() && message.unit != kind->unit)
    throw std::invalid_argument(message.kind + " has the unit '" + message.unit + "', expected '" + kind->unit +
                                "' or none");
  given.set(*kind, message.values);
}

Tolerances tolerancesOf(const CriterionRequest& request, const Machine& own)
{
  Problems problems;
  GivenTolerances given;
  bool counts_own = true;
  readSwitch("own_tolerances", request.own_tolerances, counts_own, problems);
  for (std::size_t k = 0; k < request.tolerances.size(); ++k)
    try
    {
      readTolerance(request.tolerances[k], given);
    }
    catch (const std::invalid_argument& reason)
    {
      problems.push_back("tolerances[" + std::to_string(k) + "]: " + reason.what());
    }
  throwProblems(problems);
  return given.over(counts_own ? tolerancesOf(own) : Tolerances());
}

bool hasTolerances(const CriterionRequest& request)
{
  return !request.tolerances.empty() || request.own_tolerances != CriterionRequest::DEFAULT;
}
}  // namespace

std::optional<Machine> machineOf(const CriterionRequest& request, const Machine& own)
{
  std::optional<Machine> machine;
  if (!request.ball_axes.empty())
    machine = withBallAxes(own, ballAxesOf(request));
  if (hasTolerances(request))
    machine = withTolerances(machine ? *machine : own, tolerancesOf(request, own));
  return machine;
}

void requireNoTolerances(const CriterionRequest& request, const std::string& remedy)
{
  if (hasTolerances(request))
    throw std::invalid_argument("tolerances must be empty and own_tolerances 0: " + remedy);
}

void requireNoBallAxes(const CriterionRequest& request, const std::string& remedy)
{
  if (!request.ball_axes.empty())
    throw std::invalid_argument("ball_axes must be empty: " + remedy);
}

void leaveJointsToEach(const CriterionRequest& request, const Machine& machine, const Criterion& given,
                       Criterion& criterion)
{
  for (std::size_t k = 0; k < JOINT_DATA.size(); ++k)
    for (std::size_t leg = 0; JOINT_DATA[k].own != nullptr && (request.*JOINT_FIELDS[k].request).empty() && leg < 3;
         ++leg)
      if ((given.*JOINT_DATA[k].values)[leg] == 0.0 &&
          (criterion.*JOINT_DATA[k].values)[leg] == machine.leg(static_cast<int>(leg)).*JOINT_DATA[k].own)
        (criterion.*JOINT_DATA[k].values)[leg] = 0.0;
}

Criterion::Aspect aspectOf(std::uint8_t aspect, Criterion::Aspect fallback, Problems& problems)
{
  if (aspect <= Hypotheses::BOTH)
    return fromNumber(aspect, ASPECT_NAMES, fallback);
  problems.push_back("aspect = " + std::to_string(aspect) + " must be OWN = 1, OTHER = 2 or BOTH = 3, or 0 for " +
                     name(fallback));
  return fallback;
}
}  // namespace pkm_workspace
