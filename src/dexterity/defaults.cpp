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

Criterion anyReachable()
{
  Criterion criterion;
  criterion.set = Criterion::Set::REACHABLE;
  criterion.aspect = Criterion::Aspect::BOTH;
  return criterion;
}

namespace
{
/// To so many significant digits: the nearest double to a short decimal.
double rounded(double value, int digits)
{
  const double exponent = std::floor(std::log10(value)) - (digits - 1);
  const double power = std::pow(10.0, std::abs(exponent));  // digits over a power of ten are the nearest double
  return exponent < 0.0 ? std::round(value * power) / power : std::round(value / power) * power;
}
}  // namespace

double defaultAccuracy(const Machine& machine)
{
  return rounded(1e-3 * machine.scale(), 1);
}

double defaultResolution(const Machine& machine, const Box& box)
{
  const bool is_flat = ((box.upper - box.lower).array() > 0.0).count() == 2;
  return rounded(machine.scale() / (is_flat ? 40.0 : 20.0), 3);
}
}  // namespace pkm_workspace
