// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/report/definition.h"

#include "pkm_workspace/dexterity/criterion_bounds.h"
#include "pkm_workspace/dexterity/criterion_text.h"
#include "pkm_workspace/interval/decimal.h"
#include "pkm_workspace/machine/ball_axes.h"
#include "pkm_workspace/report/tolerances_sentence.h"

namespace pkm_workspace
{
namespace
{
/// Where the tilt of ball joints is counted from.
std::string ballAxesInWords(const Machine& machine)
{
  std::string text;
  for (const Eigen::Vector3d& axis : givenBallAxes(machine))
    text += (text.empty() ? " from the axes (" : ", (") + exact(axis.x()) + ", " + exact(axis.y()) + ", " +
            exact(axis.z()) + ")";
  return text.empty() ? " from how the struts stand at joint values 0" : text;
}
}  // namespace

std::string definition(const Machine& machine, const Criterion& criterion)
{
  using Aspect = Criterion::Aspect;
  std::string text =
      criterion.set == Criterion::Set::DEXTROUS ? "Dextrous: reachable" : "Reachable: within reach of all three struts";
  text += " in the machine's own working mode, ";
  text += criterion.aspect == Aspect::BOTH
              ? "in either aspect (any sign of det A)"
              : "in its " + name(criterion.aspect) + " aspect (the sign of det A " +
                    (criterion.aspect == Aspect::OWN ? "" : "opposite to that ") + "at the zero configuration)";
  text += boundsInWords(criterion, &CriterionBound::full);
  if (criterion.ball_tilt_max > 0.0)
    text += ballAxesInWords(machine);
  if (criterion.hinge_limits)
    text += ", with all passive joints within their limits";
  text += zonesInWords(criterion.zones, criterion.tool_radius);
  if (!machine.hasJointLimits())
    text += "; the machine has no joint limits.";
  else
    text += criterion.joint_limits ? ", and within the joint limits." : "; joint limits are not asked for.";
  return text + tolerancesSentence(machine);
}
}  // namespace pkm_workspace
