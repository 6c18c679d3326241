// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/report/path_sentence.h"

#include <gtest/gtest.h>

#include <regex>

#include "pkm_workspace/report/rates_sentence.h"
#include "region/paths.h"

namespace pkm_workspace
{
namespace test
{
namespace
{
const Eigen::Vector3d START(-0.079970593403865281, -0.22351999604761633, 0.18342168780574239);
const Eigen::Vector3d END(0.8108995385756147, -0.37194738107784847, -0.8025565924264686);

std::string sentenceOf(const PathResult& result)
{
  return describe(result, orthoglide(), [](std::size_t segment) { return "segment " + std::to_string(segment); });
}

std::string sentenceOf(const std::vector<PathSegment>& segments, const Criterion& criterion = {},
                       const PathQuery& query = {})
{
  return sentenceOf(checkPath(orthoglide(), criterion, segments, query));
}

PathSegment line(double end)
{
  return PathSegment::line({ 0.0, 0.0, 0.0 }, { end, end, end });
}

void expectSays(const std::string& sentence, const std::string& pattern)
{
  EXPECT_TRUE(std::regex_match(sentence, std::regex(pattern))) << sentence;
}
}  // namespace

TEST(PathSentence, tellsWhereThePathLeavesAndWhatBindsThere)
{
  EXPECT_EQ(sentenceOf({ line(0.1) }), "Proved: every point of the path is in the set.");
  expectSays(sentenceOf({ line(0.1), line(0.6) }),
             "Proved: the path leaves the set on segment 1, near t = 0\\.680413817 of its way: the least velocity "
             "transmission factor (is below 0\\.5, by at most|reaches 0\\.5, to within) .*e-1[0-9]\\.");
  expectSays(sentenceOf({ PathSegment::line({ 0.6, 0.6, 0.6 }, { 0.0, 0.0, 0.0 }) }),
             "Proved: the path is outside the set on segment 0, near t = 0 of its way: the least velocity "
             "transmission factor is 0\\.[0-9]+, below 0\\.5\\.");
}

// The path touches the border near 0.584, where it stays good, and leaves the set later.
TEST(PathSentence, doesNotTakeATouchForTheOffence)
{
  Criterion criterion;
  criterion.psi_min = 0.7974806294181559;
  expectSays(
      sentenceOf({ PathSegment::line(START, END) }, criterion),
      "Proved: the path leaves the set on segment 0, near t = 0\\.7[0-9]* of its way: the .* Before that it comes "
      "within rounding of the border near t = 0\\.58[0-9]*, where nothing is decided\\.");
}

TEST(PathSentence, tellsWhichJointIsTooFast)
{
  PathQuery query;
  query.tool_speed = 0.3;
  query.holds_limits = true;
  query.limits.speed = { 0.2, 0.2, 0.2 };
  const PathSegment along = PathSegment::line({ 0.0, 0.0, 0.0 }, { 0.1, 0.0, 0.0 });
  expectSays(
      sentenceOf(checkPath(orthoglide(), {}, { along }, query)),
      "Proved: at 0\\.3 m/s the path is too fast for the joints on segment 0, near t = 0 of its way: the speed of "
      "joint 'rail_x' is 0\\.3 m/s, above its limit of 0\\.2 m/s\\.");
  query.limits.speed = { INF, 0.02, INF };
  expectSays(
      sentenceOf(checkPath(orthoglide(), {}, { along }, query)),
      "Proved: at 0\\.3 m/s the path becomes too fast for the joints on segment 0, near t = 0\\.66\\d* of its way: "
      "the speed of joint 'rail_y' (is above|reaches) its limit of 0\\.02 m/s, .*\\.");
  query.limits.acceleration = { INF, INF, 0.05 };
  expectSays(sentenceOf(checkPath(orthoglide(), {}, { along }, query)),
             "Proved: at 0\\.3 m/s the path is too fast for the joints on segment 0, near t = 0 of its way: the "
             "acceleration of joint 'rail_z' is 0\\.09 m/s\\^2, above its limit of 0\\.05 m/s\\^2\\.");
}

TEST(RatesSentence, tellsTheFeedAndWhatHasNoLimit)
{
  const auto told = [](const JointRateLimits& limits, double tool_speed) {
    PathQuery query;
    query.tool_speed = tool_speed;
    query.holds_limits = query.wants_rates = true;
    query.limits = limits;
    const std::vector<PathSegment> path = { PathSegment::line({ 0.0, 0.0, 0.0 }, { 0.0, 0.0, 0.1 }),
                                            PathSegment::line({ 0.0, 0.0, 0.0 }, { 0.1, 0.0, 0.0 }) };
    return describeRates(checkPath(orthoglide(), Criterion(), path, query), query, orthoglide(),
                         [](std::size_t segment) { return "segment " + std::to_string(segment); });
  };
  JointRateLimits limits;
  EXPECT_EQ(told(limits, 0.1), "Joint speeds are not held against a limit: 'rail_x', 'rail_y' and 'rail_z' have none.");
  limits.speed = { 0.2, 0.2, 0.25 };
  expectSays(told(limits, 0.1),
             "At 0\\.1 m/s the joints are proved to keep within their limits\\. The largest feed is "
             "proved to be (0\\.2|0\\.19999\\d* to 0\\.20000\\d*) m/s; at that 'rail_x' reaches its "
             "limit of speed on segment 1\\.");
  limits.speed[1] = INF;
  limits.acceleration[2] = 0.01;
  expectSays(told(limits, 0.4),
             "The largest feed is proved to be 0\\.0992\\d* to 0\\.099[23]\\d* m/s; at that 'rail_z' reaches "
             "its limit of acceleration on segment 1\\. The speed of 'rail_y' is not held against a "
             "limit: it has none\\.");
  limits.speed = { INF, INF, 0.3 };
  limits.acceleration[2] = INF;
  expectSays(told(limits, 0.1),
             ".* The speeds of 'rail_x' and 'rail_y' are not held against a limit: they have none\\.");
}

TEST(PathSentence, saysWhyNothingIsDecided)
{
  const PathSegment touching = PathSegment::circle({ 0.0, 0.0, 0.0 }, { 0.5, 0.0, 0.0 }, { 0.0, 0.0, 1.0 });
  expectSays(
      sentenceOf({ touching }, reachable()),
      "Not decided on segment 0, .*t = 0\\.[0-9]+ of its way, where the path comes within rounding of the border: "
      "the strut of 'rail_[xyz]' is 1 m long and reaches as far across its rail.*\\.");
  PathQuery query;
  query.max_looks = 50;
  query.looks_per_piece = 0;
  const std::vector<PathSegment> path(300, line(0.001));
  expectSays(sentenceOf(path, {}, query),
             "Not decided on segment [0-9]+, between t = 0\\.0+ and t = 1\\.0+ of its way, because [0-9]+ looks were "
             "not enough\\. Nothing that was looked at is proved to be outside\\.");
  const std::atomic<bool> stop(true);
  query.stop = &stop;
  expectSays(sentenceOf(path, {}, query),
             "Not decided on segment 0, .* because a request to stop ended the proof\\. .*");
  expectSays(
      sentenceOf({ touching, PathSegment::line({ 0.0, 0.0, 0.0 }, { 2.0, 0.0, 0.0 }) }, reachable()),
      "Proved: the path is outside the set on segment 1, near t = 0\\.625 of its way: the strut of 'rail_[xyz]' is 1 m "
      "long and would have to reach 1\\.25 m across its rail\\. Before that it is not decided on segment 0, "
      ".* where the path comes within rounding of the border\\.");
}
}  // namespace test
}  // namespace pkm_workspace
