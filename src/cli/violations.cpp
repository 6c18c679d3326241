// SPDX-License-Identifier: BSD-3-Clause
#include "violations.h"

#include "pkm_workspace/interval/decimal.h"

namespace pkm_workspace
{
namespace cli
{
namespace
{
using Kind = Limit::Kind;

std::string jointPhrase(const Leg& leg, const Limit& limit)
{
  return "joint '" + leg.joint + "' would be at " + nearly(limit.value.mid()) + " m, its limits are " +
         exact(leg.limits.lower()) + " m and " + exact(leg.limits.upper()) + " m";
}

std::string factorPhrase(const Limit& limit)
{
  const char* const name = limit.kind == Kind::PSI_MIN     ? "the least velocity transmission factor"
                           : limit.kind == Kind::PSI_MAX   ? "the largest velocity transmission factor"
                           : limit.kind == Kind::FORCE_MIN ? "the least force transmission factor"
                           : limit.kind == Kind::FORCE_MAX ? "the largest force transmission factor"
                                                           : "the condition number of J";
  const bool is_least = limit.kind == Kind::PSI_MIN || limit.kind == Kind::FORCE_MIN;
  const std::string value = limit.value.isBounded() ? nearly(limit.value.mid()) : "without bound";
  return std::string(name) + " is " + value + (is_least ? ", below " : ", above ") + exact(limit.bound);
}
}  // namespace

std::string describe(const Machine& machine, const Limit& limit)
{
  switch (limit.kind)
  {
    case Kind::REACH:
      return "the strut of '" + machine.leg(limit.leg).joint + "' is " + exact(limit.bound) +
             " m long and would have to reach " + nearly(limit.value.mid()) + " m across its rail";
    case Kind::JOINT_LOWER:
    case Kind::JOINT_UPPER:
      return jointPhrase(machine.leg(limit.leg), limit);
    case Kind::ASPECT:
      return "det A has the other sign than at the zero configuration: another aspect of the machine";
    default:
      return factorPhrase(limit);
  }
}

Words violations(const Machine& machine, const PointEvaluation& there)
{
  Words found;
  for (const Limit& limit : there.limits)
    if (limit.isViolated())
      found.push_back(describe(machine, limit));
  if (found.empty() && !there.has_values && there.verdict == BoxVerdict::OUTSIDE)
    found.push_back("a strut is across its rail (serial singularity)");
  return found;
}

Words violations(const Machine& machine, const Criterion& criterion, const Eigen::Vector3d& p)
{
  return violations(machine, evaluatePoint(machine, criterion, p));
}
}  // namespace cli
}  // namespace pkm_workspace
