// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/report/rates_sentence.h"

#include "pkm_workspace/interval/decimal.h"

namespace pkm_workspace
{
namespace
{
/// "Joint speeds are not held against a limit: 'a', 'b' and 'c' have none."
std::string withoutLimit(const std::array<double, 3>& limits, const Machine& machine)
{
  std::string names;
  std::size_t count = 0;
  for (std::size_t i = 3; i-- > 0;)
    if (limits[i] == INF)
    {
      names = "'" + machine.legs()[i].joint + "'" + (count == 0 ? "" : count == 1 ? " and " : ", ") + names;
      ++count;
    }
  constexpr const char* IS[] = { "", " is", " are" };
  constexpr const char* HAS[] = { "", "it has none.", "they have none." };
  if (count == 0)
    return "";
  if (count == 3)
    return "Joint speeds are not held against a limit: " + names + " have none.";
  return (count == 1 ? "The speed of " : "The speeds of ") + names + IS[count] +
         " not held against a limit: " + HAS[count];
}

std::string feedSentence(const PathResult& result, const Machine& machine,
                         const std::function<std::string(std::size_t)>& place)
{
  const LargestFeed& feed = result.rates->feed;
  if (feed.lower == INF)
    return "No joint that has a limit moves, at any feed.";
  if (feed.lower == 0.0 && feed.upper == INF)
    return "Nothing is known of the largest feed.";
  const std::string proof = "The largest feed is proved to be ";
  if (feed.lower == 0.0)
    return proof + "at most " + significantAbove(feed.upper, 6) + " m/s.";
  const std::string size = feed.upper == INF
                               ? "at least " + roundedDown(feed.lower, decimalsFor(feed.lower, feed.lower))
                               : bracket(feed.lower, feed.upper);
  return proof + size + " m/s; at that '" + machine.leg(feed.leg).joint + "' reaches its limit of " +
         (feed.kind == Limit::Kind::JOINT_SPEED ? "speed" : "acceleration") + " on " + place(result.slowest) + ".";
}
}  // namespace

std::string describeRates(const PathResult& result, const PathQuery& query, const Machine& machine,
                          const std::function<std::string(std::size_t)>& place, bool speeds_off)
{
  std::string text;
  const auto say = [&text](const std::string& sentence) {
    text += (text.empty() || sentence.empty() ? "" : " ") + sentence;
  };
  if (query.holds_limits && query.limits.any() && result.verdict == Containment::INSIDE)
    say((query.steps_have_speeds ? "At its feeds" : "At " + exact(query.tool_speed) + " m/s") +
        " the joints are proved to keep within their limits.");
  if (result.rates && query.limits.any())
    say(feedSentence(result, machine, place));
  if (query.holds_limits || query.wants_rates)
    say(speedsNotHeld(query.limits, machine, speeds_off));
  return text;
}

std::string speedsNotHeld(const JointRateLimits& limits, const Machine& machine, bool speeds_off)
{
  return speeds_off ? "Joint speeds are not held against a limit: they are left aside."
                    : withoutLimit(limits.speed, machine);
}
}  // namespace pkm_workspace
