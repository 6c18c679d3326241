// SPDX-License-Identifier: BSD-3-Clause
#include "violations.h"

#include <Eigen/LU>

#include "pkm_workspace/interval/decimal.h"

namespace pkm_workspace
{
namespace cli
{
namespace
{
/// Struts that do not reach from their rail to the point.
Words shortStruts(const Machine& machine, const Eigen::Vector3d& p)
{
  Words found;
  for (int i = 0; i < 3; ++i)
  {
    const Interval across = norm(machine.projector(i) * (enclose(p) - machine.center(i)));
    const Interval& length = machine.leg(i).length;
    if (across.upper() > length.lower())
      found.push_back("the strut of '" + machine.leg(i).joint + "' is " + exact(length.mid()) +
                      " m long and would have to reach " + exact(across.mid()) + " m across its rail");
  }
  return found;
}

Words passedLimits(const Machine& machine, const Eigen::Vector3d& rho)
{
  Words found;
  for (int i = 0; i < 3; ++i)
  {
    const Interval& limits = machine.leg(i).limits;
    if (!limits.contains(rho[i]))
      found.push_back("joint '" + machine.leg(i).joint + "' would be at " + exact(rho[i]) + " m, its limits are " +
                      exact(limits.lower()) + " m and " + exact(limits.upper()) + " m");
  }
  return found;
}

Words wrongFactors(const Criterion& criterion, const Eigen::Vector3d& psi)
{
  Words found;
  if (psi[0] < criterion.psi_min)
    found.push_back("the least velocity transmission factor is " + exact(psi[0]) + ", below " +
                    exact(criterion.psi_min));
  if (psi[2] > criterion.psi_max)
    found.push_back("the largest velocity transmission factor is " + exact(psi[2]) + ", above " +
                    exact(criterion.psi_max));
  return found;
}
}  // namespace

Words violations(const Machine& machine, const Criterion& criterion, const Eigen::Vector3d& p)
{
  const auto rho = inverseKinematics(machine, p);
  if (!rho)
    return shortStruts(machine, p);
  Words found = criterion.joint_limits ? passedLimits(machine, *rho) : Words();
  const auto append = [&found](const Words& more) { found.insert(found.end(), more.begin(), more.end()); };
  const auto jacobian = jacobians(machine, p);
  if (!jacobian)
    append({ "a strut is across its rail (serial singularity)" });
  else if (criterion.aspect == Criterion::Aspect::OWN && machine.aspect() * jacobian->a.determinant() <= 0.0)
    append({ "det A has the other sign than at the zero configuration: another aspect of the machine" });
  if (jacobian && criterion.set == Criterion::Set::DEXTROUS)
    append(wrongFactors(criterion, transmissionFactors(*jacobian)));
  return found;
}
}  // namespace cli
}  // namespace pkm_workspace
