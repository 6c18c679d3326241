// SPDX-License-Identifier: BSD-3-Clause
#include <pkm_workspace/CheckPath.h>
#include <pkm_workspace/EvaluatePoint.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <regex>
#include <thread>

#include "node_client.h"
#include "pkm_workspace/machine/catalogue.h"

namespace pkm_workspace
{
namespace test
{
namespace
{
geometry_msgs::Point point(double x, double y, double z)
{
  geometry_msgs::Point message;
  message.x = x;
  message.y = y;
  message.z = z;
  return message;
}

ToolSegment line(const geometry_msgs::Point& start, const geometry_msgs::Point& end)
{
  ToolSegment segment;
  segment.kind = ToolSegment::LINE;
  segment.start = start;
  segment.end = end;
  return segment;
}

/// A whole circle about z.
ToolSegment circle(double radius)
{
  ToolSegment segment;
  segment.kind = ToolSegment::ARC;
  segment.start = point(radius, 0.0, 0.0);
  segment.axis.z = 1.0;
  segment.angle = 2.0 * M_PI;
  return segment;
}

CheckPath::Response check(const std::vector<ToolSegment>& segments)
{
  CheckPath::Request request;
  request.segments = segments;
  return call<CheckPath>("check_path", request);
}

EvaluatePoint::Response evaluate(double x, double y, double z)
{
  EvaluatePoint::Request request;
  request.point = point(x, y, z);
  return call<EvaluatePoint>("evaluate_point", request);
}
}  // namespace

TEST(CheckPath, provesWholeLinesAndTellsWhatTheMachineDoes)
{
  const auto response = check({ line(point(0, 0, 0), point(0.3, 0, 0)), line(point(0.3, 0, 0), point(0.3, 0.3, 0.2)) });
  ASSERT_EQ(CheckPath::Response::INSIDE, response.verdict) << response.message;
  EXPECT_EQ(2U, response.segment_verdicts.size());
  EXPECT_EQ(-1, response.offending_segment);
  const auto start = inverseKinematics(orthoglide(), Eigen::Vector3d::Zero());
  for (int i = 0; i < 3; ++i)
  {
    const Bounds& joint = response.motion.joints[static_cast<std::size_t>(i)];
    EXPECT_LE(joint.lower, (*start)[i] + 1e-12);
    EXPECT_GE(joint.upper, (*start)[i] - 1e-12);
    EXPECT_GT(response.motion.joint_speeds[static_cast<std::size_t>(i)], 0.0);
    EXPECT_GE(response.motion.psi[static_cast<std::size_t>(i)].lower, 0.5 - 1e-3);
  }
}

TEST(CheckPath, namesTheFirstOffence)
{
  const auto response = check({ line(point(0, 0, 0), point(0.1, 0, 0)), line(point(0.1, 0, 0), point(0.9, 0.9, 0.9)) });
  ASSERT_EQ(CheckPath::Response::OUTSIDE, response.verdict) << response.message;
  EXPECT_EQ(CheckPath::Response::INSIDE, response.segment_verdicts[0]);
  EXPECT_EQ(1, response.offending_segment);
  EXPECT_LE(response.good_until, response.bad_at);
  EXPECT_LE(response.bad_at - response.good_until, 1e-6);
  ASSERT_EQ(1U, response.open.size());
  EXPECT_EQ(response.good_until, response.open[0].lower);
  EXPECT_EQ(response.bad_at, response.open[0].upper);
  EXPECT_EQ(0U, response.message.find("Proved: the path leaves the set on segment 1, near t = ")) << response.message;
  const auto offence = evaluate(response.offence.x, response.offence.y, response.offence.z);
  EXPECT_NE(EvaluatePoint::Response::INSIDE, offence.verdict);
  EXPECT_EQ(response.limit.kind, offence.limit.kind);
}

// Along x the first rail goes with the tool.
TEST(CheckPath, holdsTheJointsWithinTheirLimitsAtAToolSpeed)
{
  CheckPath::Request request;
  request.segments = { line(point(0, 0, 0), point(0, 0, 0.05)), line(point(-0.1, 0, 0), point(0.1, 0, 0)) };
  request.largest_feed = true;
  const auto feed = call<CheckPath>("check_path", request);
  ASSERT_EQ(CheckPath::Response::INSIDE, feed.verdict) << feed.message;
  const double most = feed.rates.speed_max[0];
  ASSERT_TRUE(std::isfinite(most));
  EXPECT_TRUE(std::isinf(feed.rates.acceleration_max[0]));
  EXPECT_LE(feed.rates.feed.lower, most);
  EXPECT_GE(feed.rates.feed.upper, most * (1 - 1e-12));
  ASSERT_EQ(2U, feed.rates.segment_feeds.size());
  EXPECT_EQ(feed.rates.segment_feeds[static_cast<std::size_t>(feed.rates.slowest_segment)].lower,
            feed.rates.feed.lower);
  request.largest_feed = false;
  request.tool_speed = 0.9 * most;
  const auto slow = call<CheckPath>("check_path", request);
  EXPECT_EQ(CheckPath::Response::INSIDE, slow.verdict) << slow.message;
  EXPECT_GE(slow.rates.accelerations[1], std::pow(request.tool_speed, 2)) << "(1 - x^2)^-3/2, for 1 m/s";
  request.tool_speed = 1.5 * most;
  request.segments.erase(request.segments.begin());
  const auto fast = call<CheckPath>("check_path", request);
  ASSERT_EQ(CheckPath::Response::OUTSIDE, fast.verdict) << fast.message;
  EXPECT_EQ(BindingLimit::JOINT_SPEED, fast.limit.kind);
  EXPECT_EQ("rail_x", fast.limit.joint);
  EXPECT_EQ(most, fast.limit.bound);
  EXPECT_NEAR(1.5 * most, fast.limit.value.lower, 1e-9);
  EXPECT_EQ(0.0, fast.bad_at);
  EXPECT_NE(std::string::npos, fast.message.find("too fast for the joints on segment 0")) << fast.message;
  EXPECT_EQ("rail_x", fast.rates.slowest_joint);
  request.joint_speeds_off = true;
  const auto aside = call<CheckPath>("check_path", request);
  EXPECT_EQ(CheckPath::Response::INSIDE, aside.verdict) << aside.message;
  EXPECT_NE(std::string::npos, aside.message.find("Joint speeds are not held against a limit: they are left aside."));
  request.joint_acceleration_max = { 1e9, 1e9, 1e-3 * most * most };
  const auto bent = call<CheckPath>("check_path", request);
  ASSERT_EQ(CheckPath::Response::OUTSIDE, bent.verdict) << bent.message;
  EXPECT_EQ(BindingLimit::JOINT_ACCELERATION, bent.limit.kind);
  EXPECT_EQ("rail_z", bent.limit.joint);
}

TEST(CheckPath, takesArcsWhole)
{
  EXPECT_EQ(CheckPath::Response::INSIDE, check({ circle(0.2) }).verdict);
  // the start is good, and so is the end: the same point
  EXPECT_EQ(EvaluatePoint::Response::INSIDE, evaluate(0.38, 0.0, 0.0).verdict);
  ToolSegment through;
  through.kind = ToolSegment::ARC_THROUGH;
  through.start = point(0.38, 0, 0);
  through.via = point(-0.38, -0.38, 0);
  through.end = point(0, 0.38, 0);
  EXPECT_EQ(EvaluatePoint::Response::INSIDE, evaluate(0.0, 0.38, 0.0).verdict);
  EXPECT_EQ(CheckPath::Response::OUTSIDE, check({ through }).verdict) << "its ends are good, its middle is not";
}

TEST(CheckPath, takesPathsOfPoses)
{
  CheckPath::Request request;
  request.path.header.frame_id = "base_link";
  for (const double x : { 0.0, 0.1, 0.2 })
  {
    geometry_msgs::PoseStamped pose;
    pose.pose.position = point(x, 0.0, 0.1);
    request.path.poses.push_back(pose);
  }
  const auto response = call<CheckPath>("check_path", request);
  EXPECT_EQ(CheckPath::Response::INSIDE, response.verdict) << response.message;
  EXPECT_EQ(2U, response.segment_verdicts.size());
}

TEST(CheckPath, takesAFrameWithAndWithoutItsSlash)
{
  CheckPath::Request request;
  request.segments = { line(point(0, 0, 0), point(0.1, 0, 0)) };
  request.header.frame_id = "/base_link";
  request.path.header.frame_id = "base_link";
  const auto response = call<CheckPath>("check_path", request);
  EXPECT_EQ(CheckPath::Response::INSIDE, response.verdict) << response.message;
  EXPECT_EQ("base_link", response.header.frame_id);
}

// The stamps of the answers tell when each was begun.
TEST(CheckPath, leavesShortRequestsAloneWhenItIsLong)
{
  const ToolSegment segment = line(point(0, 0, 0), point(0.1, 0, 0));
  CheckPath::Request request;
  request.segments.assign(1000000, segment);
  std::atomic<bool> is_done(false);
  CheckPath::Response long_answer;
  std::thread planner([&] {
    long_answer = call<CheckPath>("check_path", request);
    is_done = true;
  });
  std::vector<ros::Time> begun;
  while (!is_done)
  {
    const auto there = evaluate(0.0, 0.0, 0.0);
    const auto path = check({ segment });
    EXPECT_EQ(EvaluatePoint::Response::INSIDE, there.verdict);
    EXPECT_EQ(CheckPath::Response::INSIDE, path.verdict);
    if (!is_done)
      begun.push_back(std::min(there.header.stamp, path.header.stamp));
  }
  planner.join();
  EXPECT_EQ(CheckPath::Response::INSIDE, long_answer.verdict) << long_answer.message;
  EXPECT_EQ(CheckPath::Response::COMPLETE, long_answer.end);
  EXPECT_EQ(1000000U, long_answer.segment_verdicts.size());
  const auto meanwhile =
      std::count_if(begun.begin(), begun.end(), [&](const ros::Time& time) { return time > long_answer.header.stamp; });
  EXPECT_GE(meanwhile, 5) << "answered while the long path was being checked";
}

TEST(CheckPath, refusesWhatIsOutOfRange)
{
  const auto expectRefused = [](const CheckPath::Request& request, const std::string& message) {
    const auto response = call<CheckPath>("check_path", request);
    EXPECT_EQ(ErrorCode::INVALID_REQUEST, response.error_code);
    EXPECT_TRUE(std::regex_search(response.message, std::regex(message))) << response.message;
  };
  const auto with = [](const ToolSegment& segment) {
    CheckPath::Request request;
    request.segments = { segment };
    return request;
  };
  expectRefused(CheckPath::Request(), "give either segments or a path");
  expectRefused(with(ToolSegment()), "segments\\[0\\]: kind = 0 must be LINE = 1");
  ToolSegment bent = line(point(0, 0, 0), point(0.1, 0, 0));
  bent.angle = 1.0;
  expectRefused(with(bent), "angle and lift must be 0 unless kind = ARC");
  expectRefused(with(line(point(0, 0, 0), point(std::nan(""), 0, 0))), "segments\\[0\\]: ");
  CheckPath::Request fast = with(line(point(0, 0, 0), point(0.1, 0, 0)));
  fast.tool_speed = -1.0;
  expectRefused(fast, "tool_speed = -1 m/s must be from 1e-9 to 1e9 m/s");
  fast.tool_speed = 1e300;
  expectRefused(fast, "tool_speed = 1e\\+300 m/s must be from 1e-9 to 1e9 m/s");
  CheckPath::Request two = fast;
  two.tool_speed = 0.0;
  two.header.frame_id = "base_link";
  two.path.header.frame_id = "elsewhere";
  expectRefused(two, "frame 'elsewhere' must be empty or that of the request");
  two = with(line(point(0, 0, 0), point(0.1, 0, 0)));
  two.joint_acceleration_max = { 1.0 };
  expectRefused(two, "joint_acceleration_max is without effect: give tool_speed too, or ask for largest_feed");
  two.tool_speed = 1.0;
  two.joint_acceleration_max = { 1.0, -1.0, 1.0 };
  expectRefused(two, "joint_acceleration_max = -1 m/s\\^2 must be > 0");
  two.joint_acceleration_max = { 1.0, 1.0 };
  expectRefused(two, "joint_acceleration_max has 2 numbers: give one for all joints, or one for each");
  ToolSegment flat = line(point(0, 0, 0), point(0.2, 0, 0));
  flat.kind = ToolSegment::ARC_THROUGH;
  flat.via = point(0.1, 1e-8, 0);
  expectRefused(with(flat), "must be farther off a line: the sine .* more than 1e-06");
}

// The second request differs in nothing that its criterion asks of a point.
TEST(CheckPath, holdsTheJointSpeedsOfEachRequest)
{
  CheckPath::Request request;
  request.segments = { line(point(0, 0, 0), point(0.2, 0, 0)) };
  request.tool_speed = 0.5;
  request.criterion.joint_speed_max = { 5.0 };
  EXPECT_EQ(CheckPath::Response::INSIDE, call<CheckPath>("check_path", request).verdict);
  request.criterion.joint_speed_max = { 0.1 };
  const auto slow = call<CheckPath>("check_path", request);
  EXPECT_EQ(CheckPath::Response::OUTSIDE, slow.verdict) << slow.message;
  EXPECT_EQ(BindingLimit::JOINT_SPEED, slow.limit.kind);
  EXPECT_EQ(0.1, slow.limit.bound);
}

TEST(EvaluatePoint, tellsHowTheMachineStands)
{
  const auto good = evaluate(0.0, 0.0, 0.0);
  ASSERT_EQ(ErrorCode::SUCCESS, good.error_code) << good.message;
  EXPECT_EQ(EvaluatePoint::Response::INSIDE, good.verdict);
  EXPECT_EQ(0U, good.message.find("Proved: the point is dextrous in the machine's own aspect; the nearest limit: the "))
      << good.message;
  ASSERT_TRUE(good.has_values);
  for (std::size_t i = 0; i < 3; ++i)
  {
    EXPECT_NEAR(1.0, good.psi[i].lower, 1e-6);  // isotropic
    EXPECT_NEAR(0.0, good.joints[i].upper, 1e-9);
  }
  const auto far = evaluate(3.0, 0.0, 0.0);
  EXPECT_EQ(EvaluatePoint::Response::OUTSIDE, far.within_reach);
  EXPECT_FALSE(far.has_values);
  EXPECT_EQ(BindingLimit::REACH, far.limit.kind);
  EXPECT_FALSE(far.limit.joint.empty());
  EXPECT_LT(far.limit.margin.upper, 0.0);
  EXPECT_EQ(0U, far.message.find("Proved: the point is not dextrous in the machine's own aspect: the strut of '"))
      << far.message;
  const auto stretched = evaluate(0.45, 0.45, 0.45);
  EXPECT_EQ(EvaluatePoint::Response::OUTSIDE, stretched.verdict);
  EXPECT_EQ(EvaluatePoint::Response::INSIDE, stretched.within_reach);
  EXPECT_EQ(ErrorCode::INVALID_REQUEST, evaluate(std::nan(""), 0.0, 0.0).error_code);
  const auto beyond = evaluate(1e160, 0.0, 0.0);
  EXPECT_EQ(ErrorCode::INVALID_REQUEST, beyond.error_code);
  EXPECT_NE(std::string::npos, beyond.message.find("point = (1e+160, 0, 0) m must be finite, within 1e9 m"));
}
}  // namespace test
}  // namespace pkm_workspace
