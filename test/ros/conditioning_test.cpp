// SPDX-License-Identifier: BSD-3-Clause
#include <pkm_workspace/ComputeConditioning.h>

#include "node_client.h"

namespace pkm_workspace
{
namespace test
{
namespace
{
ComputeConditioning::Request overCube()
{
  ComputeConditioning::Request request;
  request.over = ComputeConditioning::Request::REGION;
  request.solid.type = shape_msgs::SolidPrimitive::BOX;
  request.solid.dimensions = { 0.5, 0.5, 0.5 };
  request.center.x = request.center.y = request.center.z = 0.086;
  request.accuracy = 0.05;
  return request;
}
}  // namespace

TEST(ComputeConditioning, enclosesTheIndexOfARegionAndOfTheSet)
{
  const auto cube = call<ComputeConditioning>("compute_conditioning", overCube());
  ASSERT_EQ(ErrorCode::SUCCESS, cube.error_code) << cube.message;
  EXPECT_TRUE(cube.complete);
  EXPECT_GT(cube.index.lower, 0.6);
  EXPECT_LT(cube.index.upper, 0.75);
  EXPECT_LE(cube.measure.lower, 0.125);
  EXPECT_GE(cube.measure.upper, 0.125);
  EXPECT_EQ("base_link", cube.header.frame_id);
  EXPECT_EQ(Hypotheses::REACHABLE, cube.hypotheses.set) << "all points of a region count";
  EXPECT_EQ(Hypotheses::BOTH, cube.hypotheses.aspect);
  EXPECT_EQ(0.0, cube.hypotheses.psi_min);
  EXPECT_FALSE(cube.hypotheses.joint_limits);

  ComputeConditioning::Request request;
  request.accuracy = 0.1;
  const auto set = call<ComputeConditioning>("compute_conditioning", request);
  ASSERT_EQ(ErrorCode::SUCCESS, set.error_code) << set.message;
  EXPECT_GT(set.index.lower, 0.4);
  EXPECT_LT(set.index.upper, 0.55);
  EXPECT_EQ(Hypotheses::DEXTROUS, set.hypotheses.set);
}

TEST(ComputeConditioning, saysWhatItMeansForLimitsThatAreLeftAside)
{
  constexpr const char* REMARK = "Joint limits are off: all rails stay within their limits.";
  ComputeConditioning::Request request;
  request.accuracy = 0.3;
  EXPECT_EQ(std::string::npos, call<ComputeConditioning>("compute_conditioning", request).message.find("limits are"));
  request.criterion.joint_limits = CriterionRequest::OFF;
  const std::string message = call<ComputeConditioning>("compute_conditioning", request).message;
  EXPECT_NE(std::string::npos, message.find(REMARK)) << message;
}

TEST(ComputeConditioning, tellsThatNoPointIsReached)
{
  ComputeConditioning::Request request;
  request.over = ComputeConditioning::Request::REGION;
  request.solid.type = shape_msgs::SolidPrimitive::SPHERE;
  request.solid.dimensions = { 0.1 };
  request.center.x = request.center.y = request.center.z = 9.0;
  const auto beyond = call<ComputeConditioning>("compute_conditioning", request);
  ASSERT_EQ(ErrorCode::SUCCESS, beyond.error_code) << beyond.message;
  EXPECT_TRUE(beyond.complete);
  EXPECT_EQ(0.0, beyond.index.upper);
  EXPECT_LT(beyond.boxes, 20000);
  EXPECT_NE(std::string::npos, beyond.message.find("The struts reach no point of it")) << beyond.message;
}

TEST(ComputeConditioning, saysWhereNothingIsProved)
{
  ComputeConditioning::Request request;
  request.time_limit = 1e-9;
  const auto nothing = call<ComputeConditioning>("compute_conditioning", request);
  EXPECT_EQ(0.0, nothing.index.lower);
  EXPECT_EQ(1.0, nothing.index.upper);
  EXPECT_EQ("Nothing is proved of the global conditioning index: the time limit of 1e-09 s ended the computation.",
            nothing.message);
}

TEST(ComputeConditioning, takesACylinderWithoutARadiusForTheLineThatItIs)
{
  ComputeConditioning::Request request = overCube();
  request.solid.dimensions = { 0.0, 0.0, 0.3 };
  const auto line = call<ComputeConditioning>("compute_conditioning", request);
  request.solid.type = shape_msgs::SolidPrimitive::CYLINDER;
  request.solid.dimensions = { 0.3, 0.0 };
  const auto thin = call<ComputeConditioning>("compute_conditioning", request);
  EXPECT_EQ(line.index, thin.index);
  EXPECT_NEAR(0.3, thin.measure.lower, 1e-12);
}

TEST(ComputeConditioning, refusesWhatIsOutOfRangeOrWithoutEffect)
{
  ComputeConditioning::Request request = overCube();
  request.criterion.kappa_max = 2.0;
  request.accuracy = -1.0;
  const auto refused = call<ComputeConditioning>("compute_conditioning", request);
  EXPECT_EQ(ErrorCode::INVALID_REQUEST, refused.error_code);
  EXPECT_NE(std::string::npos, refused.message.find("criterion must be 0")) << refused.message;
  EXPECT_NE(std::string::npos, refused.message.find("accuracy = -1")) << refused.message;
}
}  // namespace test
}  // namespace pkm_workspace
