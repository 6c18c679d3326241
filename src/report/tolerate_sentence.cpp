// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/report/tolerate_sentence.h"

#include <cmath>

#include "pkm_workspace/interval/decimal.h"
#include "pkm_workspace/report/binding_limit.h"

namespace pkm_workspace
{
namespace
{
std::string vectorText(const Eigen::Vector3d& v)
{
  return "(" + nearly(v.x(), 4) + ", " + nearly(v.y(), 4) + ", " + nearly(v.z(), 4) + ")";
}

std::string whyItFails(const TolerableFactor& found, const Machine& machine)
{
  const Eigen::Vector3d& p = *found.bad_point;
  std::string text = " at (" + exact(p.x()) + ", " + exact(p.y()) + ", " + exact(p.z()) + ") m";
  if (found.bad_machine)
    text += ", where " + describe(*found.bad_limit, *found.bad_machine) + " (it is listed below)";
  if (!found.shares.empty())
  {
    const ToleranceShare& first = found.shares.front();
    text += "; most of what is lost there, " + nearly(100.0 * first.share, 2) + " %, is due to the " +
            first.kind->name + " of joint '" + machine.leg(first.leg).joint + "'";
  }
  return text;
}
}  // namespace

std::string describe(const TolerableFactor& found, const Machine& machine, const FactorQuery& query)
{
  const std::string region = "the " + query.solid.shape->name();
  if (found.fails == 0.0)
    return "The nominal machine is bad at a point of " + region + " already: no tolerances are small enough.";
  if (!(found.holds > 0.0))
    return "No factor was found with which " + region + " is good on every machine.";
  std::string text = "Every point of " + region + " is good on every machine within " +
                     significantBelow(found.holds, 6) + " times these tolerances";
  if (found.fails < INF)
    text += "; within " + significantAbove(found.fails, 6) + " times, one machine is bad" + whyItFails(found, machine);
  else
    text += "; up to the largest that are allowed no machine was found on which it is bad";
  return text + ".";
}

std::vector<LegDifference> differences(const Machine& built, const Machine& meant)
{
  std::vector<LegDifference> all;
  for (std::size_t i = 0; i < 3; ++i)
  {
    const SlidingStrut& is = slidingStrut(built.legs()[i]);
    const SlidingStrut& was = slidingStrut(meant.legs()[i]);
    const double angle = std::asin(std::min(1.0, mid(is.axis).cross(mid(was.axis)).norm()));
    const Interval &now = built.legs()[i].limits, &then = meant.legs()[i].limits;
    const double zero = std::isfinite(then.upper()) ? then.upper() - now.upper() : then.lower() - now.lower();
    all.push_back({ meant.legs()[i].joint, mid(is.origin) - mid(was.origin), mid(is.platform) - mid(was.platform),
                    is.length.mid() - was.length.mid(), angle, mid(is.axis), std::isfinite(zero) ? zero : 0.0 });
  }
  return all;
}

std::vector<std::string> differencesInWords(const Machine& built, const Machine& meant)
{
  std::vector<std::string> all;
  for (const LegDifference& leg : differences(built, meant))
    all.push_back(leg.joint + ": slider off by " + vectorText(leg.slider) + " m, platform by " +
                  vectorText(leg.platform) + " m, strut by " + nearly(leg.length, 4) + " m, rail by " +
                  nearly(leg.angle, 4) + " rad" +
                  (leg.zero != 0.0 ? ", joint zero by " + nearly(leg.zero, 4) + " m" : ""));
  return all;
}
}  // namespace pkm_workspace
