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
