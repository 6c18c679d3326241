// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/dexterity/criterion_bounds.h"

#include <algorithm>

#include "pkm_workspace/dexterity/joint_data.h"
#include "pkm_workspace/interval/decimal.h"

namespace pkm_workspace
{
namespace
{
template <class Condition>
const CriterionBound* firstBound(const Condition& condition)
{
  const auto found = std::find_if(CRITERION_BOUNDS.begin(), CRITERION_BOUNDS.end(), condition);
  return found == CRITERION_BOUNDS.end() ? nullptr : &*found;
}
}  // namespace

Interval inverse(const Interval& x)
{
  const double lower = x.upper() < INF ? (Interval(1.0) / Interval(x.upper())).lower() : 0.0;
  return { std::max(0.0, lower), x.lower() > 0.0 ? (Interval(1.0) / Interval(x.lower())).upper() : INF };
}

const CriterionBound* boundOf(Limit::Kind kind)
{
  return firstBound([kind](const CriterionBound& bound) { return bound.kind == kind; });
}

const CriterionBound* lowerBoundOf(const CriterionBound& bound)
{
  return firstBound([&bound](const CriterionBound& other) { return other.value == bound.lower_value; });
}

std::string unitOf(const CriterionBound& bound)
{
  return *bound.unit == '\0' ? "without unit" : bound.unit;
}

std::string rangeOf(const CriterionBound& bound)
{
  if (bound.most < LARGEST_BOUND)
    return "positive and at most " + exact(bound.most);
  return bound.least == LEAST_POSITIVE ? "positive and finite (1e-100 to 1e100)"
                                       : "at least " + exact(bound.least) + " and finite (to 1e100)";
}

std::string allowedInWords(const CriterionBound& bound)
{
  const CriterionBound* const lower = lowerBoundOf(bound);
  const std::string range = lower != nullptr                ? std::string(">= ") + lower->name
                            : bound.least == LEAST_POSITIVE ? "> 0"
                                                            : ">= " + exact(bound.least);
  return "a number " + range + (bound.is_optional ? ", or 0 for none, " : ", ") + unitOf(bound);
}

std::string boundsInWords(const Criterion& criterion, const char* CriterionBound::*part)
{
  std::string text;
  for (const CriterionBound& bound : CRITERION_BOUNDS)
    if (bound.isAskedBy(criterion))
    {
      const std::string words = bound.*part;
      const std::size_t place = words.find("{}");
      text += words.substr(0, place) + exact(criterion.*bound.value) + words.substr(place + 2) +
              jointDataInWords(criterion, bound.value);
    }
  return text;
}
}  // namespace pkm_workspace
