// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/report/placement_sentence.h"

#include <algorithm>

#include "pkm_workspace/common/text.h"
#include "pkm_workspace/dexterity/criterion_text.h"
#include "pkm_workspace/interval/decimal.h"

namespace pkm_workspace
{
namespace
{
std::string pieceOf(const PlacementQuery& query)
{
  return query.workpiece->solid ? "part" : "path";
}

/// ", and at 0.3 m/s the joints keep within their limits of speed and acceleration", of those that they have.
std::string rates(const PlacementQuery& query)
{
  const auto has = [](const std::array<double, 3>& limits) {
    return std::any_of(limits.begin(), limits.end(), [](double limit) { return limit < INF; });
  };
  const bool has_speed = has(query.limits.speed), has_acceleration = has(query.limits.acceleration);
  if (!has_speed && !has_acceleration)
    return "";
  const PathTree& moves = query.workpiece->moves;
  const Interval speed = moves.speed(moves.all());
  return ", and at " + (speed.isSingle() ? exact(speed.lower()) + " m/s" : "its feeds") +
         " the joints keep within their limits of " + (has_speed ? "speed" : "") +
         (has_speed && has_acceleration ? " and " : "") + (has_acceleration ? "acceleration" : "");
}

/// "every point of the path is dextrous, and at 0.3 m/s the joints keep within their limits of speed".
std::string goodness(const Machine& machine, const PlacementQuery& query)
{
  return "every point of the " + pieceOf(query) + " is " + quality(machine, query.criterion) + rates(query);
}

std::string marginSentence(const LargestRegion& found, const Machine& machine, const PlacementQuery& query)
{
  const int decimals = decimalsFor(found.size, found.size_upper_bound);
  const std::string above = roundedUp(found.size_upper_bound, decimals) + " m.";
  if (found.size > 0.0)
    return "Proved: with this translation, and moved from there by up to " + roundedDown(found.size, decimals) +
           " m along each axis, " + goodness(machine, query) +
           "; no translation that may be chosen has a margin above " + above;
  if (found.size_upper_bound == 0.0)
    return "Proved: there is no translation that may be chosen with which " + goodness(machine, query) + ".";
  return "Proved: no translation that may be chosen has a margin above " + above +
         " Whether one has any is not decided.";
}

std::string whatStopped(const LargestRegion& search)
{
  return search.status == LargestRegion::Status::STOPPED ? sentence(search.message) : "";
}

std::string placeOf(const Eigen::Vector3d& p)
{
  return "(" + exact(p.x()) + ", " + exact(p.y()) + ", " + exact(p.z()) + ") m";
}

std::string scaleSentence(const LargestScale& largest, const Machine& machine, const PlacementQuery& query)
{
  const int decimals = decimalsFor(largest.scale, largest.upper_bound);
  const std::string good = "every point of the " + pieceOf(query) + " is " + quality(machine, query.criterion);
  const std::string from = " at all scales from " + exact(largest.least) + " to ";
  const std::string bound = roundedUp(largest.upper_bound, decimals);
  if (largest.scale == 0.0)
    return " Proved: no translation is such that " + good + from + "one above " + bound + ".";
  return " Proved: scaled about " + placeOf(query.workpiece->reference) + " and then moved by " +
         placeOf(largest.translation) + ", " + good + from + roundedDown(largest.scale, decimals) +
         "; no translation that may be chosen allows one above " + bound + "." +
         (query.limits.any() ? " Speeds do not count for the scale." : "");
}
}  // namespace

std::string describe(const Placement& placement, const Machine& machine, const PlacementQuery& query)
{
  std::string text = withRemark(marginSentence(placement.found, machine, query), whatStopped(placement.found));
  if (placement.largest)
    text = withRemark(text + scaleSentence(*placement.largest, machine, query), whatStopped(placement.largest->search));
  return text;
}
}  // namespace pkm_workspace
