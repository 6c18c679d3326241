// SPDX-License-Identifier: BSD-3-Clause
#include "node_client.h"
#include "pkm_workspace/ros/client.h"

namespace pkm_workspace
{
namespace test
{
TEST(Client, doesWhatItsExampleSays)
{
  Client machine;
  RegionRequest request;
  request.shape = RegionRequest::CUBE;
  const Region region = machine.largestRegion(request);
  EXPECT_LE(region.size, 0.643951);
  EXPECT_GE(region.size_upper_bound, 0.643950);
  EXPECT_EQ(region, machine.lastRegion());
  EXPECT_EQ(CheckRegion::Response::INSIDE, machine.checkBox({ 0.1, 0.1, 0.1 }, { 0.2, 0.2, 0.3 }).verdict);
  EXPECT_EQ(CheckPath::Response::INSIDE, machine.checkLine({ { 0, 0, 0 }, { 0.2, 0, 0 } }).verdict);
  EXPECT_EQ(CheckPath::Response::OUTSIDE, machine.checkLine({ { 0, 0, 0 }, { 0.9, 0.9, 0 } }).verdict);
  EXPECT_TRUE(machine.evaluate({ 0.1, 0.0, 0.0 }).has_values);
  EXPECT_GT(machine.workspace().volume_lower_bound, 0.0);
}

TEST(Client, takesFieldsByName)
{
  Client machine;
  const Region region = machine.largestRegion(with::shape("box"), with::proportions({ 2, 1, 1 }), with::psi_min(0.4),
                                              with::kappa_max(4.0), with::joint_limits(false), with::accuracy(0.01),
                                              with::frame("base_link"));
  EXPECT_EQ(RegionRequest::BOX, region.shape);
  EXPECT_EQ(0.4, region.hypotheses.psi_min);
  EXPECT_EQ(4.0, region.hypotheses.kappa_max);
  EXPECT_FALSE(region.hypotheses.joint_limits);
  const Region near = machine.largestRegion(with::search_box({ 0, 0, 0 }, { 0.05, 0.05, 0.05 }), with::accuracy(0.01));
  EXPECT_LE(near.center.x, 0.05);
  EXPECT_EQ(machine.OUTSIDE, machine.checkBox({ 0, 0, 0 }, { 0.1, 0.1, 0.1 }, with::psi_max(1.001)).verdict);
  const auto tolerated = machine.evaluate({ 0, 0, 0 }, with::tolerances({ { "tolerance_zero", { 1e-3 } } }));
  ASSERT_EQ(1U, tolerated.hypotheses.tolerances.size());
  EXPECT_EQ(1e-3, tolerated.hypotheses.tolerances[0].values.at(0));
  EXPECT_EQ(0U, machine.evaluate({ 0, 0, 0 }, with::own_tolerances(false)).hypotheses.tolerances.size());
  EXPECT_EQ(0.0, machine.evaluate({ 0, 0, 0 }, with::set(CriterionRequest::REACHABLE)).hypotheses.psi_min);
  EXPECT_GT(machine.workspace(with::box({ 0, 0, 0 }, { 0.1, 0.1, 0.1 }), with::resolution(0.05)).volume_lower_bound, 0);
}

TEST(Client, checksArcsAndHelices)
{
  Client machine;
  const Triple end = { -0.1, 0, 0 };
  const auto answer = machine.checkPath({ line({ 0, 0, 0 }, { 0.1, 0, 0 }), arc({ 0.1, 0, 0 }, { 0, 0.1, 0 }, end),
                                          turn(end, { 0, 0, 0 }, { 0, 0, 1 }, 3.0, 0.05) },
                                        with::tool_speed(0.1));
  EXPECT_EQ(machine.INSIDE, answer.verdict);
  EXPECT_EQ(3U, answer.segment_verdicts.size());
  const auto feed = machine.checkLine({ { 0, 0, 0 }, { 0.1, 0, 0 } }, with::largest_feed(), with::joint_speeds_off(),
                                      with::joint_acceleration_max({ 1.0 }));
  EXPECT_GT(feed.rates.feed.lower, 0.0);
  EXPECT_EQ(1.0, feed.rates.acceleration_max[2]);
}

TEST(Client, placesPaths)
{
  Client machine;
  const auto found = machine.placePath({ line({ 5, 0, 0 }, { 5.2, 0, 0 }) }, with::largest_scale(),
                                       with::tool_speed(0.1), with::accuracy(0.01));
  EXPECT_EQ(PlacePath::Response::PROVEN, found.status);
  EXPECT_LE(found.margin, found.margin_upper_bound);
  EXPECT_LE(found.margin_upper_bound, found.margin + 0.01);
  EXPECT_LE(1.0, found.scale);
  const double x = found.translation.x;
  const double y = found.translation.y;
  const double z = found.translation.z;
  EXPECT_EQ(machine.INSIDE, machine.checkLine({ { 5 + x, y, z }, { 5.2 + x, y, z } }, with::tool_speed(0.1)).verdict);
}

TEST(Client, followsGoals)
{
  Client machine;
  auto goal = machine.findRegion({}, with::shape("cube"), with::accuracy(0.01));
  ASSERT_TRUE(goal.waitForResult(PATIENCE.toSec()));
  EXPECT_EQ(ErrorCode::SUCCESS, goal.result().error_code);
  EXPECT_EQ(Region::PROVEN, goal.result().region.status);
  auto refused = machine.findRegion({}, with::accuracy(-1.0));
  ASSERT_TRUE(refused.waitForResult(PATIENCE.toSec()));
  EXPECT_EQ(ErrorCode::INVALID_REQUEST, refused.result().error_code);
  auto endless = machine.approximateWorkspace({}, with::set(CriterionRequest::REACHABLE), with::resolution(1e-4),
                                              with::time_limit(86400.0));
  EXPECT_FALSE(endless.waitForResult(0.0));
  EXPECT_THROW(endless.result(), std::runtime_error);
  endless.cancel();
  EXPECT_TRUE(endless.waitForResult(PATIENCE.toSec()));
  auto paving = machine.approximateWorkspace({}, with::resolution(0.1));
  EXPECT_TRUE(paving.waitForResult(PATIENCE.toSec()));
}

TEST(Client, throwsWhatTheNodeRefuses)
{
  Client machine;
  RegionRequest request;
  request.accuracy = -1.0;
  try
  {
    machine.largestRegion(request);
    FAIL() << "not refused";
  }
  catch (const Refused& refused)
  {
    EXPECT_EQ(ErrorCode::INVALID_REQUEST, refused.error_code);
    EXPECT_NE(std::string::npos, std::string(refused.what()).find("accuracy = -1"));
  }
  EXPECT_THROW(Client("/nobody", 0.1).lastRegion(), std::runtime_error);
}
}  // namespace test
}  // namespace pkm_workspace
