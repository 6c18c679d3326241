// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/dexterity/unbounded.h"

namespace pkm_workspace
{
Unbounded::Unbounded(What what, const std::string& reason, const Machine& machine, const Criterion& criterion)
  : std::invalid_argument(reason)
  , what_(what)
  , has_limits_(machine.hasJointLimits())
  , asks_for_limits_(criterion.joint_limits)
{}

std::string describe(const Unbounded& unbounded, const Remedy& remedy)
{
  const std::string limits = !unbounded.hasLimits()      ? ""
                             : unbounded.asksForLimits() ? "closer joint limits at both ends of each rail"
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
