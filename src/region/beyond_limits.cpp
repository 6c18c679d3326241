// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/region/beyond_limits.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <tuple>

#include "pkm_workspace/interval/decimal.h"

namespace pkm_workspace
{
namespace
{
/// No rail goes so far [m]: what does is without end.
constexpr double LONGEST = 1e300;
/// Of a longer path some are left out: what is said of the limits is no verdict.
constexpr std::size_t MOST_SEGMENTS = 10000;

bool staysWithinLimits(const Machine& machine, const JointReaches& reaches)
{
  for (std::size_t i = 0; i < 3; ++i)
  {
    const Interval& limits = machine.legs()[i].limits;
    if (!(reaches[i].least.lower() >= limits.lower() && reaches[i].largest.upper() <= limits.upper()))
      return false;
  }
  return true;
}

/// Rounded down to four digits, or to fewer where it is not known as well.
std::string atLeast(const Interval& by)
{
  const int digits = 3 - static_cast<int>(std::floor(std::log10(by.lower())));
  return roundedDown(by.lower(), std::min(std::max(0, digits), decimalsFor(by.lower(), by.upper())));
}

std::string phrase(const Leg& leg, const BeyondLimit& beyond)
{
  const std::string unit = std::string(" ") + unitOf(leg);
  const double limit = beyond.is_upper ? leg.limits.upper() : leg.limits.lower();
  return "'" + leg.joint + "' would leave its " + (beyond.is_upper ? "upper" : "lower") + " limit, " + exact(limit) +
         unit + ", by " + (beyond.by.lower() > LONGEST ? "any length" : "at least " + atLeast(beyond.by) + unit);
}
}  // namespace

JointReaches reachOver(const std::array<JointRange, 3>& ranges)
{
  JointReaches reaches;
  for (std::size_t i = 0; i < 3; ++i)
    reaches[i] = { ranges[i].lower, ranges[i].upper };
  return reaches;
}

JointReaches reachOver(const Machine& machine, const Shape& shape, const Eigen::Vector3d& center, double size)
{
  try
  {
    return reachOver(jointRanges(machine, shape, center, size));
  }
  catch (const std::domain_error&)
  {
    return reachAt({ Interval::entire(), Interval::entire(), Interval::entire() });
  }
}

JointReaches reachAt(const std::array<Interval, 3>& rho)
{
  JointReaches reaches;
  for (std::size_t i = 0; i < 3; ++i)
    reaches[i] = { rho[i], rho[i] };
  return reaches;
}

JointReaches united(const JointReaches& a, const JointReaches& b)
{
  JointReaches all;
  for (std::size_t i = 0; i < 3; ++i)
  {
    const auto& [p, q] = std::tie(a[i], b[i]);
    all[i].least = { std::min(p.least.lower(), q.least.lower()), std::min(p.least.upper(), q.least.upper()) };
    all[i].largest = { std::max(p.largest.lower(), q.largest.lower()), std::max(p.largest.upper(), q.largest.upper()) };
  }
  return all;
}

PathReach::PathReach(const Machine& machine) : machine_(machine)
{
  least_.fill(INF);
  largest_.fill(-INF);
}

void PathReach::add(const PathSegment& segment)
{
  if (segments_++ % stride_ != 0)
    return;
  if (++taken_ % MOST_SEGMENTS == 0)
    stride_ *= 2;
  for (const double t : { 0.0, 0.5, 1.0 })
    if (const auto there = configurationAt(machine_, segment.curve().point(t)))
      for (std::size_t i = 0; i < 3; ++i)
      {
        least_[i] = std::min(least_[i], there->rho[i].upper());
        largest_[i] = std::max(largest_[i], there->rho[i].lower());
      }
}

JointReaches PathReach::over(const PathMotion& motion) const
{
  JointReaches reaches;
  for (std::size_t i = 0; i < 3; ++i)
  {
    const Interval& joint = motion.joint[i];
    reaches[i].least = { joint.lower(), std::max(joint.lower(), std::min(joint.upper(), least_[i])) };
    reaches[i].largest = { std::min(joint.upper(), std::max(joint.lower(), largest_[i])), joint.upper() };
  }
  return reaches;
}

std::vector<BeyondLimit> beyondLimits(const Machine& machine, const std::optional<JointReaches>& reaches)
{
  std::vector<BeyondLimit> found;
  for (int i = 0; reaches && i < 3; ++i)
  {
    const Interval& limits = machine.leg(i).limits;
    const JointReach& reach = (*reaches)[static_cast<std::size_t>(i)];
    if (reach.least.upper() < limits.lower())
      found.push_back({ i, false, Interval(limits.lower()) - reach.least });
    if (reach.largest.lower() > limits.upper())
      found.push_back({ i, true, reach.largest - Interval(limits.upper()) });
  }
  return found;
}

std::string remarkOnLimits(const Machine& machine, const Criterion& criterion,
                           const std::optional<JointReaches>& reaches)
{
  if (criterion.joint_limits || !machine.hasJointLimits() || !reaches)
    return "";
  const auto isSliding = [](const Leg& leg) { return std::holds_alternative<SlidingStrut>(leg.kind); };
  const bool slide = std::all_of(machine.legs().begin(), machine.legs().end(), isSliding);
  const std::string joints = slide ? "rails" : "joints";
  std::string text;
  for (const BeyondLimit& beyond : beyondLimits(machine, reaches))
    text += (text.empty() ? "" : "; ") + phrase(machine.leg(beyond.leg), beyond);
  if (text.empty())
    text = staysWithinLimits(machine, *reaches) ? "all " + joints + " stay within their limits"
                                                : "whether all " + joints + " stay within their limits is not proved";
  return "Joint limits are off: " + text + ".";
}

std::string withRemark(const std::string& message, const std::string& remark)
{
  const bool is_sentence = !message.empty() && message.back() == '.';
  return remark.empty() ? message : message + (is_sentence ? " " : ". ") + remark;
}
}  // namespace pkm_workspace
