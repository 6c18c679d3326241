// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/report/containment_sentence.h"

#include "pkm_workspace/common/text.h"
#include "pkm_workspace/dexterity/criterion_text.h"
#include "pkm_workspace/interval/decimal.h"
#include "pkm_workspace/region/beyond_limits.h"
#include "pkm_workspace/report/binding_limit.h"

namespace pkm_workspace
{
namespace
{
std::string whyUndecided(const ContainmentResult& result, const Machine& machine, const Budget& budget)
{
  if (result.is_within_rounding && machine.hasTolerances())
    return "the border of the set that all machines within the tolerances have is too close for bounds over all of "
           "them";
  return result.is_within_rounding ? "the border of the set is within rounding of the region"
                                   : budget.endedBy(result.seconds, result.boxes) + " ended the proof";
}

std::string whyOutside(const ContainmentResult& result, const PointEvaluator& evaluator, const std::string& body)
{
  if (result.bad_within > 0.0)
    return "no further than " + roundedUp(result.bad_within, 17) + " m from the bad point the " + body +
           " has a point where two struts are one vector, so that det A is 0: a parallel singularity, which belongs "
           "to no aspect.";
  const std::vector<std::string> reasons = violations(evaluator(*result.bad_point), evaluator.machine());
  return "the bad point lies in the " + body + " and is not " +
         quality(evaluator.machine(), evaluator.test().model().criterion()) + (reasons.empty() ? "" : ": ") +
         joined(reasons, "; ") + ".";
}
}  // namespace

std::string describe(const ContainmentResult& result, const PointEvaluator& evaluator, const Shape& shape,
                     const Eigen::Vector3d& center, double size, const Budget& budget)
{
  if (result.verdict == Containment::UNDECIDED)
    return "Neither is proved: " + whyUndecided(result, evaluator.machine(), budget) + ".";
  if (result.verdict == Containment::OUTSIDE)
    return "Proved: " + whyOutside(result, evaluator, shape.name());
  const Machine& machine = evaluator.machine();
  const Criterion& criterion = evaluator.test().model().criterion();
  const std::string proof = "Proved: every point of the " + shape.name() + " is " + quality(machine, criterion) + ".";
  return criterion.joint_limits
             ? proof
             : withRemark(proof, remarkOnLimits(machine, criterion, reachOver(machine, shape, center, size)));
}
}  // namespace pkm_workspace
