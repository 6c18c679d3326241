// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/report/guarantee_sentence.h"

#include <cmath>

#include "pkm_workspace/interval/decimal.h"
#include "pkm_workspace/report/binding_limit.h"

namespace pkm_workspace
{
namespace
{
constexpr int GUARANTEE_DIGITS = 6;

std::string placeOf(const Guarantee& guarantee)
{
  const Eigen::Vector3d& p = guarantee.place;
  return "(" + nearly(p.x(), GUARANTEE_DIGITS) + ", " + nearly(p.y(), GUARANTEE_DIGITS) + ", " +
         nearly(p.z(), GUARANTEE_DIGITS) + ") m";
}

/// To six digits, towards what is surely so.
std::string rounded(double value, bool down)
{
  return down ? significantBelow(value, GUARANTEE_DIGITS) : significantAbove(value, GUARANTEE_DIGITS);
}
}  // namespace

std::string describe(const Guarantee& guarantee, const Machine& machine, const Budget& budget)
{
  const CriterionBound& bound = *guarantee.bound;
  const std::string subject = bound.subject + guarantee.counting,
                    unit = *bound.unit == '\0' ? "" : std::string(" ") + bound.unit;
  const std::string ended_by = budget.endedBy(guarantee.seconds, guarantee.boxes);
  const std::string ending =
      guarantee.complete ? ""
                         : ". The accuracy was not met: " +
                               (!ended_by.empty()         ? ended_by + " ended it"
                                : machine.hasTolerances() ? "bounds over all machines do not tell it more closely"
                                                          : "doubles do not tell it more closely");
  const double proved = guarantee.proved();
  if (!(proved > 0.0 && std::isfinite(proved)))
    return "Nothing is proved of " + subject + ": " +
           (guarantee.is_reached ? (ended_by.empty() ? "it was shown for none of the values that may be asked for"
                                                     : ended_by + " ended the proof")
            : guarantee.limit    ? "near " + placeOf(guarantee) + " " + describe(*guarantee.limit, machine)
                                 : "it is undecided whether the region is reached") +
           ".";
  const double at_place = bound.is_lower ? guarantee.value.upper() : guarantee.value.lower();
  const std::string leg =
      !guarantee.limit || guarantee.limit->leg < 0 ? "" : ", by '" + machine.leg(guarantee.limit->leg).joint + "'";
  return "Proved for every point: " + subject + " is at " + (bound.is_lower ? "least " : "most ") +
         rounded(proved, bound.is_lower) + unit + "; near " + placeOf(guarantee) + " it is no " +
         (bound.is_lower ? "more than " : "less than ") + rounded(at_place, !bound.is_lower) + unit + leg + ending +
         ".";
}
}  // namespace pkm_workspace
