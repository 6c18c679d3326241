// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/dexterity/criterion.h"

#include <algorithm>
#include <tuple>

#include "pkm_workspace/dexterity/criterion_text.h"
#include "pkm_workspace/interval/text_stream.h"

namespace pkm_workspace
{
namespace
{
/// The squares of factors have to be ordinary numbers.
constexpr double LEAST = 1e-100;
constexpr double LARGEST = 1e100;

/// The values of a criterion by their names.
class FactorChecks
{
public:
  FactorChecks(Problems& problems, const Origin& origin) : problems_(problems), origin_(origin) {}

  /// Whether the value is 0 where that stands for none, or an ordinary number.
  bool isOrdinary(const std::string& name, double value, bool may_be_none)
  {
    if ((value >= LEAST && value <= LARGEST) || (may_be_none && value == 0.0))
      return true;
    complain(problems_, name, " = ", value, ' ', fromWhere(name),
             "(a transmission factor, without unit) must be positive and finite (1e-100 to 1e100)",
             may_be_none ? ", or 0 for none" : "");
    return false;
  }

  void order(const std::string& least, double lower, const std::string& largest, double upper)
  {
    if (lower <= upper)
      return;
    complain(problems_, largest, " = ", upper, ' ', fromWhere(largest), "must be at least ", least, " = ", lower, ' ',
             fromWhere(least), "(transmission factors, without unit)");
  }

private:
  std::string fromWhere(const std::string& name) const
  {
    const std::string origin = origin_ ? origin_(name) : "";
    return origin.empty() ? "" : "(" + origin + ") ";
  }

  Problems& problems_;
  const Origin& origin_;
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

void validateCriterion(const Criterion& criterion, const Origin& origin, Problems& problems)
{
  FactorChecks checks(problems, origin);
  const bool has_psi_min = checks.isOrdinary("psi_min", criterion.psi_min, false);
  if (checks.isOrdinary("psi_max", criterion.psi_max, false) && has_psi_min)
    checks.order("psi_min", criterion.psi_min, "psi_max", criterion.psi_max);
  const bool has_force_min = checks.isOrdinary("force_min", criterion.force_min, true);
  if (checks.isOrdinary("force_max", criterion.force_max, true) && has_force_min && criterion.force_max != 0.0)
    checks.order("force_min", criterion.force_min, "force_max", criterion.force_max);
  if (criterion.kappa_max != 0.0 && !(criterion.kappa_max >= 1.0 && criterion.kappa_max <= LARGEST))
    complain(problems, "kappa_max = ", criterion.kappa_max,
             " (a condition number, without unit) must be at least 1 and finite (to 1e100), or 0 for none");
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

bool operator==(const Criterion& a, const Criterion& b)
{
  const auto values = [](const Criterion& c) {
    return std::tie(c.set, c.aspect, c.psi_min, c.psi_max, c.force_min, c.force_max, c.kappa_max, c.joint_limits);
  };
  return values(a) == values(b);
}

std::string name(Criterion::Aspect aspect)
{
  constexpr const char* NAMES[] = { "own", "other", "both" };  // as Aspect
  return NAMES[static_cast<std::size_t>(aspect)];
}

std::string quality(const Criterion& criterion)
{
  const std::string set = criterion.set == Criterion::Set::DEXTROUS ? "dextrous" : "reachable";
  if (criterion.aspect == Criterion::Aspect::BOTH)
    return set + " in either aspect";
  return set + " in the machine's " + name(criterion.aspect) + " aspect";
}

std::string describe(const Criterion& criterion)
{
  TextStream text;
  if (criterion.set == Criterion::Set::DEXTROUS)
    text << "dextrous with psi in [" << criterion.psi_min << ", " << criterion.psi_max << "]";
  else
    text << "reachable";
  if (criterion.force_min > 0.0)
    text << ", force factors at least " << criterion.force_min;
  if (criterion.force_max > 0.0)
    text << ", force factors at most " << criterion.force_max;
  if (criterion.kappa_max > 0.0)
    text << ", condition number at most " << criterion.kappa_max;
  text << ", " << name(criterion.aspect) << (criterion.aspect == Criterion::Aspect::BOTH ? " aspects" : " aspect")
       << ", joint limits " << (criterion.joint_limits ? "on" : "off");
  return text.str();
}
}  // namespace pkm_workspace
