// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/report/point_sentence.h"

#include "pkm_workspace/common/text.h"
#include "pkm_workspace/dexterity/criterion_text.h"
#include "pkm_workspace/region/beyond_limits.h"
#include "pkm_workspace/report/binding_limit.h"

namespace pkm_workspace
{
std::string describe(const PointEvaluation& there, const PointEvaluator& evaluator)
{
  const Machine& machine = evaluator.machine();
  const Criterion& criterion = evaluator.test().model().criterion();
  const std::string nearest = describe(there.binding(), machine);
  if (there.verdict == BoxVerdict::UNDECIDED)
    return "Neither is proved: the border of the set is within rounding of the point, where " + nearest + ".";
  if (there.verdict == BoxVerdict::INSIDE)
    return withRemark("Proved: the point is " + quality(machine, criterion) + "; the nearest limit: " + nearest + ".",
                      remarkOnLimits(machine, criterion, reachAt(there.rho)));
  const std::vector<std::string> violated = violations(there, machine);
  return "Proved: the point is not " + quality(machine, criterion) + ": " +
         (violated.empty() ? nearest : joined(violated, "; ")) + ".";
}
}  // namespace pkm_workspace
