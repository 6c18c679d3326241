// SPDX-License-Identifier: BSD-3-Clause
#include "path_answer.h"

#include <algorithm>
#include <numeric>

#include "pkm_workspace/interval/decimal.h"

namespace pkm_workspace
{
namespace cli
{
namespace
{
/// Segments whose largest feeds are printed.
constexpr std::ptrdiff_t MOST_FEEDS = 10;

std::string jointOf(const Machine& machine, std::size_t leg)
{
  return "'" + machine.legs()[leg].joint + "'";
}

std::string feedText(const LargestFeed& feed)
{
  if (feed.lower == INF)
    return "any";
  if (feed.upper == INF)
    return feed.lower == 0.0 ? "unknown" : "at least " + nearly(feed.lower) + " m/s";
  return bracket(feed.lower, feed.upper) + " m/s";
}
}  // namespace

KeptCheck::KeptCheck(const SegmentCheck& check)
{
  if (check.motion)
    found_ = *check.motion;
  else
    found_ = Open{ check.verdict, check.good_until, check.bad_at };
}

SegmentCheck KeptCheck::check() const
{
  if (const auto* const motion = std::get_if<PathMotion>(&found_))
    return { Containment::INSIDE, 1.0, std::nullopt, *motion, std::nullopt };
  const Open& open = std::get<Open>(found_);
  return { open.verdict, open.good_until, open.bad_at, std::nullopt, std::nullopt };
}

Json motionJson(const PathMotion& motion)
{
  return { { "psi", toJson(motion.psi) },
           { "rho", toJson(motion.joint) },
           { "joint_speed", { motion.joint_speed[0], motion.joint_speed[1], motion.joint_speed[2] } } };
}

Json segmentJson(const SegmentCheck& check, const std::string& place)
{
  return { { "place", place },
           { "verdict", name(check.verdict) },
           { "good_until", check.good_until },
           { "bad_at", check.bad_at ? Json(*check.bad_at) : Json() },
           { "motion", check.motion ? motionJson(*check.motion) : Json() } };
}

Json limitsJson(const std::array<double, 3>& limits)
{
  return Json::array({ finite(limits[0]), finite(limits[1]), finite(limits[2]) });
}

Json ratesJson(const PathRates& rates, const Machine& machine)
{
  const LargestFeed& feed = rates.feed;
  const bool binds = feed.leg >= 0;
  return { { "joint_acceleration", limitsJson(rates.joint_acceleration) },
           { "feed",
             { { "lower", finite(feed.lower) },
               { "upper", finite(feed.upper) },
               { "joint", binds ? Json(machine.leg(feed.leg).joint) : Json() },
               { "limit", binds ? Json(name(feed.kind)) : Json() } } } };
}

std::string feedTable(const std::deque<PathRates>& rates, const std::function<std::string(std::size_t)>& place,
                      const Machine& machine)
{
  if (rates.size() < 2)
    return "";
  std::vector<std::size_t> segments(rates.size());
  std::iota(segments.begin(), segments.end(), std::size_t(0));
  const bool has_more = segments.size() > static_cast<std::size_t>(MOST_FEEDS);
  if (has_more)
  {
    std::partial_sort(segments.begin(), segments.begin() + MOST_FEEDS, segments.end(),
                      [&](std::size_t a, std::size_t b) {
                        return std::make_pair(rates[a].feed.lower, a) < std::make_pair(rates[b].feed.lower, b);
                      });
    segments.resize(MOST_FEEDS);
  }
  std::vector<Words> rows = { { "segment", "largest feed", "limited by" } };
  for (const std::size_t k : segments)
  {
    const LargestFeed& feed = rates[k].feed;
    const std::string limit = feed.kind == Limit::Kind::JOINT_SPEED ? "speed of " : "acceleration of ";
    rows.push_back(
        { place(k), feedText(feed), feed.leg < 0 ? "" : limit + jointOf(machine, static_cast<std::size_t>(feed.leg)) });
  }
  return (has_more ? "The " + std::to_string(MOST_FEEDS) + " slowest of " + std::to_string(rates.size()) +
                         " segments (--json has them all):\n\n"
                   : "") +
         aligned(rows, Align::LEFT) + "\n";
}

void addMotion(const PathMotion& motion, const Machine& machine, std::vector<Words>& rows)
{
  for (std::size_t i = 0; i < 3; ++i)
    rows.push_back({ "psi " + std::to_string(i + 1), bracket(motion.psi[i].lower(), motion.psi[i].upper()) });
  for (std::size_t i = 0; i < 3; ++i)
  {
    const std::string joint = jointOf(machine, i);
    const std::string unit = std::string(" ") + unitOf(machine.legs()[i]);
    rows.push_back({ "rho of " + joint, bracket(motion.joint[i].lower(), motion.joint[i].upper()) + unit });
    rows.push_back({ "speed of " + joint, "up to " + significantAbove(motion.joint_speed[i], 6) + unit + "/s" });
  }
}

void addRates(const PathRates& rates, const Machine& machine, std::vector<Words>& rows)
{
  for (std::size_t i = 0; i < 3; ++i)
  {
    const double most = rates.joint_acceleration[i];
    rows.push_back(
        { "acceleration of " + jointOf(machine, i),
          most < INF ? "up to " + significantAbove(most, 6) + " " + unitOf(machine.legs()[i]) + "/s^2" : "unknown" });
  }
  rows.push_back({ "largest feed", feedText(rates.feed) });
}
}  // namespace cli
}  // namespace pkm_workspace
