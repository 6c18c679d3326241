// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/dexterity/defaults.h"

#include <cmath>

namespace pkm_workspace
{
Criterion defaultCriterion()
{
  Criterion criterion;
  criterion.joint_limits = true;
  return criterion;
}

double defaultAccuracy(const Machine& machine)
{
  const double share = 1e-3 * machine.scale();
  const double exponent = std::floor(std::log10(share));
  const double power = std::pow(10.0, std::abs(exponent));  // a digit over a power of ten is the nearest double
  return exponent < 0.0 ? std::round(share * power) / power : std::round(share / power) * power;
}

double defaultResolution(const Machine& machine, const Box& box)
{
  const bool is_flat = ((box.upper - box.lower).array() > 0.0).count() == 2;
  return machine.scale() / (is_flat ? 40.0 : 20.0);
}
}  // namespace pkm_workspace
