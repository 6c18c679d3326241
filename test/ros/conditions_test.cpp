// SPDX-License-Identifier: BSD-3-Clause
// Conditions of machines with motors and tolerances, in requests.
#include <cmath>
#include <functional>
#include <regex>

#include "node_client.h"

namespace pkm_workspace
{
namespace test
{
namespace
{
void expectProven(const ComputeLargestRegion::Response& response)
{
  ASSERT_EQ(ErrorCode::SUCCESS, response.error_code) << response.message;
  EXPECT_EQ(Region::PROVEN, response.region.status) << response.message;
}

void expectRefusal(const ComputeLargestRegion::Response& response, const std::string& message)
{
  EXPECT_EQ(ErrorCode::INVALID_REQUEST, response.error_code);
  EXPECT_TRUE(std::regex_search(response.message, std::regex(message))) << response.message;
}

Hypotheses hypothesesOf(const std::function<void(CriterionRequest&)>& ask)
{
  RegionRequest query;
  ask(query.criterion);
  const auto response = compute(query);
  expectProven(response);
  EXPECT_LT(response.region.size_upper_bound, 0.6439) << "it had no effect: " << response.message;
  return response.region.hypotheses;
}
}  // namespace

TEST(Conditions, countWithWhatTheMotorsCanDo)
{
  constexpr double MOST = 1.2;  // the URDF's velocity
  constexpr double SPEED = 1.02;
  RegionRequest query;
  query.criterion.set = CriterionRequest::REACHABLE;
  query.criterion.tool_speed_min = SPEED;
  const auto own = compute(query);
  expectProven(own);
  const double edge = std::sqrt(2.0 * (1.0 - std::pow(SPEED / MOST, 2)));  // struts off their rails by acos(0.85)
  EXPECT_LE(own.region.size, edge + 1e-12);
  EXPECT_GE(own.region.size_upper_bound, edge - 1e-12);
  EXPECT_EQ(SPEED, own.region.hypotheses.tool_speed_min);
  for (std::size_t leg = 0; leg < 3; ++leg)
    EXPECT_EQ(MOST, own.region.hypotheses.joint_speed_max[leg]);
  query.criterion.joint_speed_max = { 2.0 };
  EXPECT_GT(compute(query).region.size, own.region.size_upper_bound);
  query.criterion.joint_speed_max = { 2.0, 1.0 };
  expectRefusal(compute(query), "joint_speed_max has 2 numbers, it must have one for all legs, or three");
  query.criterion.joint_speed_max = { 2.0, -1.0, 1.0 };
  expectRefusal(compute(query), "joint_speed_max = \\(2, -1, 1\\) .*must be positive");
}

TEST(Conditions, eachMakesTheRegionSmaller)
{
  EXPECT_EQ(196.0, hypothesesOf([](CriterionRequest& asked) { asked.tool_force_min = 196.0; }).tool_force_min);
  EXPECT_EQ(0.4, hypothesesOf([](CriterionRequest& asked) { asked.strut_angle_max = 0.4; }).strut_angle_max);
  EXPECT_EQ(0.4, hypothesesOf([](CriterionRequest& asked) { asked.ball_tilt_max = 0.4; }).ball_tilt_max);
  const Hypotheses each = hypothesesOf([](CriterionRequest& asked) {
    asked.ball_tilt_max = 0.5;
    asked.strut_tilt_max = { 0.4, INFINITY, 0.45 };
  });
  EXPECT_EQ(0.4, each.strut_tilt_max[0]);
  EXPECT_EQ(0.0, each.strut_tilt_max[1]);
  EXPECT_EQ(0U, each.ball_axes.size());
  const Hypotheses stiff = hypothesesOf([](CriterionRequest& asked) {
    asked.stiffness_min = 4e5;
    asked.joint_stiffness = { 1e6 };
    asked.strut_stiffness = { 1e7, 2e7, 3e7 };
  });
  EXPECT_EQ(2e7, stiff.strut_stiffness[1]);
  EXPECT_EQ(1e6, stiff.joint_stiffness[2]);
  const Hypotheses exact = hypothesesOf([](CriterionRequest& asked) {
    asked.position_error_max = 2.5e-5;
    asked.joint_error_max = { 1e-5 };
  });
  EXPECT_EQ(1e-5, exact.joint_error_max[2]);
}

TEST(Conditions, countTiltsFromTheAxesOfTheRequest)
{
  RegionRequest query;
  query.criterion.set = CriterionRequest::REACHABLE;
  query.criterion.ball_tilt_max = 0.4;
  const auto straight = compute(query);
  query.criterion.ball_axes.resize(3);
  for (std::size_t leg = 0; leg < 3; ++leg)  // as at joint values 0
  {
    query.criterion.ball_axes[leg].x = leg == 0 ? 2.0 : 0.0;
    query.criterion.ball_axes[leg].y = leg == 1 ? 2.0 : 0.0;
    query.criterion.ball_axes[leg].z = leg == 2 ? 2.0 : 0.0;
  }
  const auto same = compute(query);
  expectProven(same);
  EXPECT_LE(same.region.size, straight.region.size_upper_bound);
  EXPECT_LE(straight.region.size, same.region.size_upper_bound);
  EXPECT_EQ(query.criterion.ball_axes, same.region.hypotheses.ball_axes);
  EXPECT_NE(straight.region.hypotheses.geometry_hash, same.region.hypotheses.geometry_hash);
  query.criterion.ball_axes[0].y = 1.0;
  EXPECT_LT(compute(query).region.size_upper_bound, straight.region.size);
  query.criterion.ball_axes.pop_back();
  expectRefusal(compute(query), "ball_axes: 2 axes, expected one for all legs or one for each");
  query.criterion.ball_axes.resize(1);
  query.criterion.ball_tilt_max = 0.0;
  expectRefusal(compute(query), "ball_axes must be empty unless ball_tilt_max is asked for");
}

TEST(Conditions, holdForAllMachinesWithinTheTolerancesOfTheRequest)
{
  RegionRequest query;
  query.accuracy = 1e-4;
  const auto exact = compute(query);
  query.criterion.tolerances.resize(2);
  query.criterion.tolerances[0].kind = "tolerance_slider";
  query.criterion.tolerances[0].values = { 1e-4 };
  query.criterion.tolerances[1].kind = "tolerance_length";
  query.criterion.tolerances[1].values = { 1e-4, 1e-4, 1e-4 };
  query.criterion.tolerances[1].unit = "m";
  const auto robust = compute(query);
  expectProven(robust);
  EXPECT_LT(robust.region.size_upper_bound, exact.region.size);
  EXPECT_LE(robust.region.size, 0.6436538);
  EXPECT_GE(robust.region.size_upper_bound, 0.6436518);
  ASSERT_EQ(2U, robust.region.hypotheses.tolerances.size());
  EXPECT_EQ("tolerance_length", robust.region.hypotheses.tolerances[0].kind);
  EXPECT_NE(exact.region.hypotheses.geometry_hash, robust.region.hypotheses.geometry_hash);
  EXPECT_EQ(0U, compute(RegionRequest()).region.hypotheses.tolerances.size()) << "a request changes the node";
  query.criterion.tolerances[0].values = { 0.0 };
  query.criterion.tolerances[1].values = { 0.0 };
  EXPECT_EQ(exact.region.size, compute(query).region.size);
}

TEST(Conditions, nameWhatIsWrongWithTolerances)
{
  RegionRequest query;
  query.criterion.tolerances.resize(2);
  query.criterion.tolerances[0].kind = "length";
  query.criterion.tolerances[1].kind = "tolerance_length";
  query.criterion.tolerances[1].values = { -1e-4 };
  query.criterion.own_tolerances = 3;
  const auto refused = compute(query);
  expectRefusal(refused, "own_tolerances = 3 must be DEFAULT = 0, ON = 1 or OFF = 2");
  expectRefusal(refused, "tolerances\\[0\\]: kind = 'length' must be one of tolerance_length, ");
  expectRefusal(refused, "tolerances\\[1\\]: tolerance_length = -0.0001 m must be from 0 to 1000 m");
  query.criterion.own_tolerances = 0;
  query.criterion.tolerances[0] = query.criterion.tolerances[1];
  query.criterion.tolerances[0].values = { 1e-4 };
  expectRefusal(compute(query), "tolerance_length is listed a second time");
  query.criterion.tolerances.resize(1);
  query.criterion.tolerances[0].unit = "mm";
  expectRefusal(compute(query), "tolerance_length has the unit 'mm', expected 'm' or none");
  query.criterion.tolerances[0] = Tolerance();
  expectRefusal(compute(query), "kind = '' must be one of");
  query.criterion.tolerances[0].kind = "tolerance_zero";
  expectRefusal(compute(query), "tolerance_zero has 0 numbers");
}

TEST(Conditions, areRefusedWhereSomethingIsMissing)
{
  RegionRequest query;
  query.criterion.stiffness_min = 1e5;
  expectRefusal(compute(query), "stiffness_min needs the stiffness of its drive .* of joint 'rail_x'");
  query.criterion = CriterionRequest();
  query.criterion.joint_stiffness = { 1e6 };
  expectRefusal(compute(query), "joint_stiffness must be empty unless stiffness_min is asked for, which it counts for");
  query.criterion = CriterionRequest();
  query.criterion.hinge_limits = 7;
  expectRefusal(compute(query), "hinge_limits = 7 must be DEFAULT = 0, ON = 1 or OFF = 2");
  query.criterion.hinge_limits = CriterionRequest::ON;  // none has a limit
  const auto response = compute(query);
  expectProven(response);
  EXPECT_FALSE(response.region.hypotheses.hinge_limits);
}
}  // namespace test
}  // namespace pkm_workspace
