// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/dexterity/criterion.h"

#include <algorithm>

#include "pkm_workspace/dexterity/criterion_bounds.h"
#include "pkm_workspace/dexterity/criterion_text.h"
#include "pkm_workspace/dexterity/joint_data.h"
#include "pkm_workspace/interval/decimal.h"

namespace pkm_workspace
{
namespace
{
/// Tells what is wrong with the bounds of a criterion, one after the other.
class BoundChecks
{
public:
  BoundChecks(const Criterion& criterion, const Origin& origin, Problems& problems)
    : criterion_(criterion), origin_(origin), problems_(problems)
  {}

  void check(const CriterionBound& bound)
  {
    const CriterionBound* const least = lowerBoundOf(bound);
    if (!isOrdinary(bound))
      complain(problems_, assigned(bound), "(a ", bound.quantity, ", ", unitOf(bound), ") must be ", rangeOf(bound),
               bound.is_optional ? ", or 0 for none" : "");
    else if (least != nullptr && isOrdinary(*least) && valueOf(bound) != 0.0 && valueOf(bound) < valueOf(*least))
      complain(problems_, assigned(bound), "must be at least ", assigned(*least), "(", bound.quantity, "s, ",
               unitOf(bound), ")");
  }

private:
  double valueOf(const CriterionBound& bound) const { return criterion_.*bound.value; }

  /// Whether the value is 0 where that stands for none, or an ordinary number.
  bool isOrdinary(const CriterionBound& bound) const
  {
    const double value = valueOf(bound);
    return (value >= bound.least && value <= bound.most) || (bound.is_optional && value == 0.0);
  }

  /// "psi_min = 3 (the default) ".
  std::string assigned(const CriterionBound& bound) const
  {
    const std::string origin = origin_ ? origin_(bound.name) : "";
    return std::string(bound.name) + " = " + exact(valueOf(bound)) + (origin.empty() ? " " : " (" + origin + ") ");
  }

  const Criterion& criterion_;
  const Origin& origin_;
  Problems& problems_;
};

/// Velocity and force factors bound the same psi.
void validateTogether(const Criterion& criterion, Problems& problems)
{
  const bool bounds_both = criterion.boundsBelow() && criterion.boundsAbove();
  if (!bounds_both || criterion.leastFactor().lower() <= criterion.largestFactor().upper())
    return;
  const bool is_least = criterion.leastFactor().lower() > criterion.psi_min;
  const char* const name = is_least ? "force_max" : "force_min";
  const double force = is_least ? criterion.force_max : criterion.force_min;
  complain(problems, name, " = ", force, " asks for psi ", is_least ? "of at least " : "of at most ", 1.0 / force,
           is_least ? ", and psi_max = " : ", and psi_min = ", is_least ? criterion.psi_max : criterion.psi_min,
           ": no point satisfies both");
}
}  // namespace

Criterion::Criterion() = default;
Criterion::Criterion(const Criterion& other) = default;
Criterion::Criterion(Criterion&& other) noexcept = default;
Criterion& Criterion::operator=(const Criterion& other) = default;
Criterion& Criterion::operator=(Criterion&& other) noexcept = default;
Criterion::~Criterion() = default;

void validateCriterion(const Criterion& criterion, const Origin& origin, Problems& problems)
{
  BoundChecks checks(criterion, origin, problems);
  for (const CriterionBound& bound : CRITERION_BOUNDS)
    checks.check(bound);
  validateJointData(criterion, problems);
  validateZones(criterion.zones, criterion.tool_radius, problems);
  if (problems.empty())
    validateTogether(criterion, problems);
}

void Criterion::validate(Problems& problems) const
{
  validateCriterion(*this, nullptr, problems);
}

Interval Criterion::leastFactor() const
{
  if (!(force_max > 0.0))
    return psi_min;
  const Interval force = Interval(1.0) / Interval(force_max);
  if (set == Set::REACHABLE)
    return force;
  return { std::max(psi_min, force.lower()), std::max(psi_min, force.upper()) };
}

Interval Criterion::largestFactor() const
{
  if (!(force_min > 0.0))
    return psi_max;
  const Interval force = Interval(1.0) / Interval(force_min);
  if (set == Set::REACHABLE)
    return force;
  return { std::min(psi_max, force.lower()), std::min(psi_max, force.upper()) };
}

std::string name(Criterion::Set set)
{
  return SET_NAMES[static_cast<std::size_t>(set)];
}

std::string name(Criterion::Aspect aspect)
{
  return ASPECT_NAMES[static_cast<std::size_t>(aspect)];
}

std::string quality(const Criterion& criterion)
{
  if (criterion.aspect == Criterion::Aspect::BOTH)
    return name(criterion.set) + " in either aspect";
  return name(criterion.set) + " in the machine's " + name(criterion.aspect) + " aspect";
}

std::string quality(const Machine& machine, const Criterion& criterion)
{
  return quality(criterion) + (machine.hasTolerances() ? " on every machine within its tolerances" : "");
}

std::string describe(const Criterion& criterion)
{
  return name(criterion.set) + boundsInWords(criterion, &CriterionBound::brief) + ", " + name(criterion.aspect) +
         (criterion.aspect == Criterion::Aspect::BOTH ? " aspects" : " aspect") + ", joint limits " +
         (criterion.joint_limits ? "on" : "off") + (criterion.hinge_limits ? ", hinge limits on" : "") +
         zonesInWords(criterion.zones, criterion.tool_radius);
}
}  // namespace pkm_workspace
