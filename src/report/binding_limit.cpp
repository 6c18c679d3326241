// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/report/binding_limit.h"

#include <algorithm>
#include <cmath>

#include "pkm_workspace/dexterity/criterion_bounds.h"
#include "pkm_workspace/interval/decimal.h"

namespace pkm_workspace
{
namespace
{
using Kind = Limit::Kind;

/// Digits of a value that is far enough from its bound, and what is not: a share of the longest strut, of the bound.
constexpr int DIGITS = 6;
constexpr int FEW_DIGITS = 3;
constexpr double NEAR = 1e-9;
const std::string LENGTH = " m";

bool isAtLeast(Kind kind)
{
  const CriterionBound* const bound = boundOf(kind);
  if (bound != nullptr)
    return bound->is_lower;
  return kind == Kind::JOINT_LOWER || kind == Kind::ASPECT || kind == Kind::HINGE_LOWER || kind == Kind::HINGE_UPPER ||
         kind == Kind::KEEP_IN || kind == Kind::KEEP_OUT;
}

/// How a value and its bound stand to each other, in words.
struct Relation
{
  bool is_violated = false;
  bool is_kept = false;
  std::string value;     ///< to six digits, on its side of the bound; empty where they do not tell or are not proved
  std::string distance;  ///< they are no farther apart than this; empty where there is no such number
  bool is_equal = false;
  std::string side;  ///< "above" or "below": where the value is, unless the enclosures leave that open
};

std::string unitOf(Kind kind)
{
  if (const CriterionBound* const bound = boundOf(kind))
    return *bound->unit == '\0' ? "" : std::string(" ") + bound->unit;
  if (isRate(kind))
    return kind == Kind::JOINT_SPEED ? " m/s" : " m/s^2";
  return kind == Kind::ASPECT ? "" : LENGTH;
}

/// Of a limit of an angle it has radians in place of metres.
std::string unitOf(const Limit& limit, const Machine& machine)
{
  const bool is_joint = limit.kind == Kind::JOINT_LOWER || limit.kind == Kind::JOINT_UPPER || isRate(limit.kind);
  const std::string unit = unitOf(limit.kind);
  return is_joint && hasAngle(machine.leg(limit.leg)) ? " rad" + unit.substr(LENGTH.size()) : unit;
}

Relation relationOf(const Limit& limit, const Machine& machine, int digits = DIGITS)
{
  Relation relation;
  relation.is_violated = limit.isViolated();
  relation.is_kept = limit.margin.certainlyPositive();
  const bool is_below = relation.is_violated == isAtLeast(limit.kind);
  relation.side = is_below ? "below" : "above";
  const double distance = limit.margin.magnitude();
  relation.is_equal = distance == 0.0;
  if (std::isfinite(distance))
    relation.distance = significantAbove(distance, 2) + unitOf(limit, machine);
  const double unit = unitOf(limit.kind) == LENGTH ? machine.scale() : std::max(1.0, limit.bound);
  if (!limit.value.isBounded() || !(relation.is_violated || relation.is_kept) || !(distance > NEAR * unit))
    return relation;
  const std::string value = nearly(limit.value.lower(), digits);
  const double number = parseNumber(value).value_or(0.0);
  const double bound = parseNumber(nearly(limit.bound, digits)).value_or(0.0);
  const bool tells = is_below ? number < std::min(bound, limit.bound) : number > std::max(bound, limit.bound);
  if (tells && value == nearly(limit.value.upper(), digits))
    relation.value = value + unitOf(limit, machine);
  return relation;
}

/// ", by at most 3e-12 m"
std::string byAtMost(const Relation& relation)
{
  return relation.distance.empty() ? "" : ", by at most " + relation.distance;
}

/// ", to within 3e-12 m" or " exactly"
std::string toWithin(const Relation& relation)
{
  return relation.is_equal ? " exactly" : relation.distance.empty() ? "" : ", to within " + relation.distance;
}

/// Of a crank: what its reach is measured by is no distance from the point.
std::string reachOfCrank(const Leg& leg, const Relation& relation)
{
  const std::string both = "crank and forearm of '" + leg.joint + "' ";
  if (relation.is_violated)
    return both + "do not reach it";
  return both + (relation.is_kept ? "reach it" : "are stretched or folded, and just reach it or just do not");
}

std::string reachPhrase(const Leg& leg, const Limit& limit, const Relation& relation)
{
  if (hasAngle(leg))
    return reachOfCrank(leg, relation);
  if (std::holds_alternative<TelescopicStrut>(leg.kind))
    return "the strut of '" + leg.joint + "' is " + nearly(limit.bound) + " m long there";
  const std::string strut = "the strut of '" + leg.joint + "' is " + nearly(limit.bound) + " m long";
  if (!relation.value.empty())
    return strut + " and " + (relation.is_violated ? "would have to reach " : "reaches ") + relation.value +
           " across its rail";
  if (relation.is_violated)
    return strut + ", too short to reach across its rail" + byAtMost(relation);
  return strut + " and reaches as far across its rail" + (relation.is_kept ? " or less" : "") + toWithin(relation);
}

/// @param name of what is limited @param is "is" or "would be" @param bound the limit in words
std::string phrase(const std::string& name, const std::string& is, const std::string& bound, const Relation& relation)
{
  if (!relation.is_violated && !relation.is_kept)
    return name + (relation.distance.empty() ? " is not known well enough to tell it from " + bound
                                             : " reaches " + bound + toWithin(relation));
  if (relation.value.empty())
    return name + " " + is + " " + relation.side + " " + bound + byAtMost(relation);
  return name + " " + is + " " + relation.value + ", " + relation.side + " " + bound;
}

/// ", of 'rail_x'," where a condition is about each leg by itself.
std::string ofLeg(const Limit& limit, const Machine& machine)
{
  return limit.leg < 0 ? "" : ", as '" + machine.leg(limit.leg).joint + "' has it,";
}

std::string jointPhrase(const Leg& leg, const Limit& limit, const Relation& relation)
{
  const std::string bound = std::string("its ") + (limit.kind == Kind::JOINT_LOWER ? "lower" : "upper") + " limit of " +
                            exact(limit.bound) + " " + unitOf(leg);
  const std::string is = relation.is_violated ? "would be" : "is";
  return phrase("joint '" + leg.joint + "'", relation.value.empty() ? is : is + " at", bound, relation);
}

std::string ratePhrase(const Machine& machine, const Limit& limit, const Relation& relation)
{
  const Leg& leg = machine.leg(limit.leg);
  const std::string rate = limit.kind == Kind::JOINT_SPEED ? "speed" : "acceleration";
  return phrase("the " + rate + " of joint '" + leg.joint + "'", "is",
                "its limit of " + exact(limit.bound) + unitOf(limit, machine), relation);
}

std::string hingePhrase(const StrutStop& stop, const Relation& relation)
{
  const std::string bound =
      std::string("its ") + (stop.is_upper ? "upper" : "lower") + " limit of " + exact(stop.limit) + " rad";
  if (relation.is_violated)
    return "passive joint '" + stop.joint + "' would be beyond " + bound + ", by " + relation.distance +
           " at most at the strut's end";
  return "passive joint '" + stop.joint + "' " + (relation.is_kept ? "is within " : "reaches ") + bound + ", by " +
         relation.distance + " at most at the strut's end";
}

/// "tool speed" of "tool_speed_min".
std::string quantityOf(Kind kind)
{
  std::string words = name(kind);
  std::replace(words.begin(), words.end(), '_', ' ');
  return boundOf(kind) == nullptr ? words : words.substr(0, words.rfind(' '));
}

/// "at least 0.4", "at most 0.6"
std::string boundPhrase(Kind kind, double bound)
{
  return (isAtLeast(kind) ? "at least " : "at most ") + exact(bound);
}

std::string zonePhrase(const Limit& limit, const Relation& relation)
{
  const bool is_in = limit.kind == Kind::KEEP_IN;
  const std::string zone =
      "the " + limit.zone + (is_in ? " that it has to keep within" : " that it has to keep out of");
  if (!relation.is_violated && !relation.is_kept)
    return "the tool reaches the border of " + zone + toWithin(relation);
  return "the tool is " + std::string(is_in == relation.is_violated ? "outside " : "within ") + zone +
         byAtMost(relation);
}

std::string aspectPhrase(const Relation& relation)
{
  if (relation.is_violated)
    return "det A has the wrong sign for this aspect, beyond a parallel singularity";
  return phrase("det A over the product of the struts' lengths, with the sign of the aspect,", "is", "0", relation);
}
}  // namespace

std::string describe(const Limit& limit, const Machine& machine)
{
  const Relation relation = relationOf(limit, machine);
  switch (limit.kind)
  {
    case Kind::REACH:
      return reachPhrase(machine.leg(limit.leg), limit, relation);
    case Kind::JOINT_LOWER:
    case Kind::JOINT_UPPER:
      return jointPhrase(machine.leg(limit.leg), limit, relation);
    case Kind::ASPECT:
      return aspectPhrase(relation);
    case Kind::JOINT_SPEED:
    case Kind::JOINT_ACCELERATION:
      return ratePhrase(machine, limit, relation);
    case Kind::HINGE_LOWER:
    case Kind::HINGE_UPPER:
      return hingePhrase(passiveJoints(machine.leg(limit.leg)).stops[static_cast<std::size_t>(limit.which)], relation);
    case Kind::KEEP_IN:
    case Kind::KEEP_OUT:
      return zonePhrase(limit, relation);
    default:
      return phrase(boundOf(limit.kind)->subject + ofLeg(limit, machine), "is", exact(limit.bound) + unitOf(limit.kind),
                    relation);
  }
}

std::string brief(const Limit& limit, const Machine& machine)
{
  const Relation relation = relationOf(limit, machine, FEW_DIGITS);
  if (boundOf(limit.kind) == nullptr || relation.value.empty())
    return describe(limit, machine);
  const std::string leg = limit.leg < 0 ? "" : " (" + machine.leg(limit.leg).joint + ")";
  return quantityOf(limit.kind) + ' ' + relation.value + ", " + boundPhrase(limit.kind, limit.bound) + " asked" + leg;
}

std::string briefly(Kind kind, const Criterion& criterion)
{
  const CriterionBound* const bound = boundOf(kind);
  if (bound != nullptr)
    return quantityOf(kind) + ' ' + boundPhrase(kind, criterion.*bound->value) + unitOf(kind);
  if (kind == Kind::KEEP_IN || kind == Kind::KEEP_OUT)
    return kind == Kind::KEEP_IN ? "keep-in zone" : "keep-out zone";
  const bool is_stop =
      kind == Kind::JOINT_LOWER || kind == Kind::JOINT_UPPER || kind == Kind::HINGE_LOWER || kind == Kind::HINGE_UPPER;
  return quantityOf(kind) + (is_stop ? " limit" : "");
}

std::vector<std::string> violations(const PointEvaluation& there, const Machine& machine)
{
  std::vector<std::string> found;
  for (const Limit& limit : there.limits)
    if (limit.isViolated())
      found.push_back(describe(limit, machine));
  if (found.empty() && !there.has_values && there.verdict == BoxVerdict::OUTSIDE)
    found.push_back(describe(there.binding(), machine) + " (serial singularity)");
  return found;
}
}  // namespace pkm_workspace
