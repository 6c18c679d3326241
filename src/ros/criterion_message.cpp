// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/ros/criterion_message.h"

#include <algorithm>
#include <iterator>
#include <limits>

#include "pkm_workspace/dexterity/criterion_bounds.h"
#include "pkm_workspace/dexterity/criterion_bytes.h"
#include "pkm_workspace/dexterity/fitting_bounds.h"
#include "pkm_workspace/dexterity/joint_data.h"
#include "pkm_workspace/interval/text_stream.h"
#include "pkm_workspace/ros/conversions.h"
#include "pkm_workspace/ros/solid_message.h"
#include "pkm_workspace/ros/zone_message.h"

namespace pkm_workspace
{
namespace
{
/// Where the messages have the bounds.
struct MessageFields
{
  double Criterion::*value;
  double CriterionRequest::*request;
  double Hypotheses::*hypotheses;
};
constexpr MessageFields FIELDS[] = {
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
constexpr JointFields JOINT_FIELDS[] = {
  { &Criterion::joint_speed_max, &CriterionRequest::joint_speed_max, &Hypotheses::joint_speed_max },
  { &Criterion::joint_effort_max, &CriterionRequest::joint_effort_max, &Hypotheses::joint_effort_max },
  { &Criterion::joint_stiffness, &CriterionRequest::joint_stiffness, &Hypotheses::joint_stiffness },
  { &Criterion::strut_stiffness, &CriterionRequest::strut_stiffness, &Hypotheses::strut_stiffness },
  { &Criterion::joint_error_max, &CriterionRequest::joint_error_max, &Hypotheses::joint_error_max },
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
    requireProvable(machine, criterion, problems);
  if (problems.size() == before)
    return criterion;
  Criterion valid = defaults;
  valid.set = criterion.set;
  valid.aspect = criterion.aspect;
  return valid;
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

Hypotheses toMessage(const Premises& premises, double accuracy)
{
  const Criterion& criterion = premises.criterion;
  Hypotheses message;
  message.machine = premises.machine;
  message.geometry_hash = premises.geometry_hash;
  message.root = toMessage(premises.root);
  message.version = premises.version;
  message.set = toNumber(criterion.set);
  message.aspect = toNumber(criterion.aspect);
  for (std::size_t k = 0; k < CRITERION_BOUNDS.size(); ++k)
    message.*FIELDS[k].hypotheses = CRITERION_BOUNDS[k].isAskedBy(criterion) ? criterion.*FIELDS[k].value : 0.0;
  for (std::size_t k = 0; k < JOINT_DATA.size(); ++k)
    if (JOINT_DATA[k].isAskedBy(criterion))
      std::copy_n((criterion.*JOINT_FIELDS[k].values).begin(), 3, (message.*JOINT_FIELDS[k].hypotheses).begin());
  message.joint_limits = criterion.joint_limits;
  message.hinge_limits = criterion.hinge_limits;
  for (const Zone& zone : criterion.zones)
    message.zones.push_back(toMessage(zone));
  message.tool_radius = criterion.tool_radius;
  message.accuracy = accuracy;
  return message;
}

Premises fromMessage(const Hypotheses& hypotheses)
{
  Criterion criterion;
  criterion.set = fromNumber(hypotheses.set, SET_NAMES, Criterion::Set::REACHABLE);
  criterion.aspect = fromNumber(hypotheses.aspect, ASPECT_NAMES, Criterion::Aspect::OWN);
  for (const MessageFields& fields : FIELDS)
    criterion.*fields.value = hypotheses.*fields.hypotheses;
  for (const JointFields& fields : JOINT_FIELDS)
    std::copy_n((hypotheses.*fields.hypotheses).begin(), 3, (criterion.*fields.values).begin());
  criterion.joint_limits = hypotheses.joint_limits;
  criterion.hinge_limits = hypotheses.hinge_limits;
  for (const ToolZone& zone : hypotheses.zones)
    criterion.zones.push_back(fromMessage(zone));
  criterion.zones = seenFrom(fromMessage(hypotheses.root), criterion.zones);
  criterion.tool_radius = hypotheses.tool_radius;
  return { hypotheses.machine, hypotheses.geometry_hash, canonical(criterion), fromMessage(hypotheses.root),
           hypotheses.version };
}

std::string captionOf(const Premises& premises, const std::string& precision, double accuracy)
{
  TextStream text;
  text << describe(premises);
  if (!precision.empty())
    text << ", " << precision << ' ' << accuracy << " m";
  return text.str();
}
}  // namespace pkm_workspace
