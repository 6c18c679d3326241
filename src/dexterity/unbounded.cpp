// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/dexterity/unbounded.h"

#include <algorithm>
#include <cmath>

#include "pkm_workspace/interval/decimal.h"

namespace pkm_workspace
{
namespace
{
std::string limitsText(const Leg& leg)
{
  const bool has_lower = std::isfinite(leg.limits.lower());
  const bool has_upper = std::isfinite(leg.limits.upper());
  const std::string unit = std::string(" ") + unitOf(leg);
  return "'" + leg.joint + "' " +
         (has_lower && has_upper ? "from " + exact(leg.limits.lower()) + " to " + exact(leg.limits.upper()) + unit
          : has_lower            ? "from " + exact(leg.limits.lower()) + unit + " upwards"
          : has_upper            ? "up to " + exact(leg.limits.upper()) + unit
                                 : "without limits");
}

/// The limits that leave it unbounded.
std::string limitsText(const Machine& machine, const Criterion& criterion)
{
  if (!criterion.joint_limits || !machine.hasJointLimits())
    return "";
  return "; the joints go: " + limitsText(machine.leg(0)) + ", " + limitsText(machine.leg(1)) + ", " +
         limitsText(machine.leg(2));
}
}  // namespace

Unbounded::Unbounded(What what, const std::string& reason, const Machine& machine, const Criterion& criterion)
  : std::invalid_argument(reason + limitsText(machine, criterion))
  , what_(what)
  , has_limits_(machine.hasJointLimits())
  , asks_for_limits_(criterion.joint_limits)
{}

std::string describe(const Unbounded& unbounded, const Remedy& remedy)
{
  const std::string limits = !unbounded.hasLimits()      ? ""
                             : unbounded.asksForLimits() ? "closer joint limits at both ends of a rail"
                                                         : remedy.limits;
  const std::string other = unbounded.kind() == Unbounded::What::SHAPE ? "another shape" : remedy.part;
  const std::string either = limits.empty() || other.empty() ? limits + other : limits + ", or for " + other;
  return unbounded.what() + (either.empty() ? "" : ": ask for " + either);
}

void throwUnbounded(const Machine& machine, const Criterion& criterion)
{
  const auto& legs = machine.legs();
  const bool has_telescopes = std::any_of(
      legs.begin(), legs.end(), [](const Leg& leg) { return std::holds_alternative<TelescopicStrut>(leg.kind); });
  throw Unbounded(Unbounded::What::SET,
                  has_telescopes
                      ? "struts of variable length have no longest length but for joint limits that hold, "
                        "so that the set has no bound"
                      : "the rails are parallel or so nearly parallel that the set is longer than 1000 struts",
                  machine, criterion);
}
}  // namespace pkm_workspace
