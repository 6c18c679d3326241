// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/dexterity/unbounded.h"

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
  return "'" + leg.joint + "' " +
         (has_lower && has_upper ? "from " + exact(leg.limits.lower()) + " to " + exact(leg.limits.upper()) + " m"
          : has_lower            ? "from " + exact(leg.limits.lower()) + " m upwards"
          : has_upper            ? "up to " + exact(leg.limits.upper()) + " m"
                                 : "without limits");
}

/// The limits that leave it unbounded.
std::string limitsText(const Machine& machine, const Criterion& criterion)
{
  if (!criterion.joint_limits || !machine.hasJointLimits())
    return "";
  return "; the rails go: " + limitsText(machine.leg(0)) + ", " + limitsText(machine.leg(1)) + ", " +
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
  throw Unbounded(Unbounded::What::SET,
                  "the rails are parallel or so nearly parallel that the set is longer than 1000 struts", machine,
                  criterion);
}
}  // namespace pkm_workspace
