// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>

#include "node_client.h"
#include "pkm_workspace/interval/rounding.h"

// Numbers: reference values of the Orthoglide with L = 1 m and psi in [0.5, 2].
namespace pkm_workspace
{
namespace test
{
namespace
{
const double SERVED_EDGE = 1.0 / std::sqrt(6.0) + 1.0 / (3.0 * std::sqrt(2.0));
const double SERVED_CENTER = 0.086273015;
const double STROKE = 1.0 + 1.0 / (3.0 * std::sqrt(2.0)) - 1.0 / std::sqrt(6.0);
const double ACROSS = 1.0 - std::sqrt(2.0 / 3.0);

void expectProven(const ComputeLargestRegion::Response& response, double accuracy)
{
  ASSERT_EQ(ErrorCode::SUCCESS, response.error_code) << response.message;
  const Region& region = response.region;
  EXPECT_EQ(Region::PROVEN, region.status) << region.message;
  EXPECT_GT(region.size, 0.0);
  EXPECT_LE(region.size_upper_bound - region.size, accuracy);
  EXPECT_EQ(accuracy, region.hypotheses.accuracy);
  EXPECT_EQ(response.message, region.message);
  EXPECT_EQ(3U, region.joint_ranges.size());
}

/// Two digits of the last size more than the accuracy: the search values are good to 1e-5.
void expectBracket(const Region& region, double size, double slack)
{
  EXPECT_LE(region.size, size + slack);
  EXPECT_GE(region.size_upper_bound, size - slack);
}
}  // namespace

TEST(ComputeLargestRegion, certifiesTheCubeWithTheNodesOwnValues)
{
  const auto response = compute(RegionRequest());
  expectProven(response, 1e-3);
  const Region& region = response.region;
  EXPECT_EQ(Region::CUBE, region.shape);
  EXPECT_GE(region.size, 0.64295);
  EXPECT_LE(region.size, SERVED_EDGE);
  EXPECT_GE(region.size_upper_bound, SERVED_EDGE);
  EXPECT_NEAR(SERVED_CENTER, region.center.x, 2e-3);
  EXPECT_NEAR(SERVED_CENTER, region.center.y, 2e-3);
  EXPECT_NEAR(SERVED_CENTER, region.center.z, 2e-3);
  EXPECT_EQ("base_link", region.header.frame_id);
  EXPECT_FALSE(region.header.stamp.isZero());
}

TEST(ComputeLargestRegion, roundsDimensionsAndVolumeInward)
{
  const Region region = compute(RegionRequest()).region;
  ASSERT_EQ(3U, region.solid.dimensions.size());
  EXPECT_EQ(shape_msgs::SolidPrimitive::BOX, region.solid.type);
  for (const double side : region.solid.dimensions)
    EXPECT_EQ(region.size, side);
  EXPECT_LE(region.volume, std::pow(static_cast<long double>(region.size), 3));
  EXPECT_GE(region.volume_upper_bound, std::pow(static_cast<long double>(region.size_upper_bound), 3));
  EXPECT_NEAR(std::pow(region.size, 3), region.volume, 1e-12);
}

TEST(ComputeLargestRegion, saysWhatItsAnswerHoldsFor)
{
  const Region region = compute(RegionRequest()).region;
  EXPECT_EQ("orthoglide", region.hypotheses.machine);
  EXPECT_EQ(36U, region.hypotheses.geometry_hash.size());
  EXPECT_FALSE(region.hypotheses.version.empty());
  EXPECT_EQ(0.5, region.hypotheses.psi_min);
  EXPECT_EQ(2.0, region.hypotheses.psi_max);
  EXPECT_TRUE(region.hypotheses.joint_limits) << "they hold unless they are left aside";
  EXPECT_FALSE(region.use_search_box);
  EXPECT_GT(region.boxes, 0);
  EXPECT_GT(region.verification_boxes, 0);
}

TEST(ComputeLargestRegion, enclosesJointRanges)
{
  RegionRequest query;
  query.accuracy = 1e-5;
  const auto response = compute(query);
  expectProven(response, 1e-5);
  const char* const joints[] = { "rail_x", "rail_y", "rail_z" };
  for (std::size_t i = 0; i < response.region.joint_ranges.size(); ++i)
  {
    const RailRange& range = response.region.joint_ranges[i];
    EXPECT_EQ(joints[i], range.joint);
    EXPECT_LE(range.stroke_lower_bound, range.stroke_upper_bound);
    EXPECT_LE(range.lower, range.inner_lower);
    EXPECT_LE(range.inner_upper, range.upper);
    EXPECT_LE(range.inner_lower - range.lower + range.upper - range.inner_upper, 1e-12);
    EXPECT_LE(range.stroke_upper_bound, range.upper - range.lower + 1e-12);
    // a region a little smaller than the largest needs a stroke a little smaller
    EXPECT_NEAR(STROKE, range.stroke_upper_bound, 1e-4);
    EXPECT_NEAR(ACROSS, range.across_upper_bound, 1e-4);
  }
}

TEST(ComputeLargestRegion, takesTheBoundsOfTheRequest)
{
  RegionRequest query;
  query.criterion.psi_min = 1.0 / 3.0;
  query.criterion.psi_max = 3.0;
  const auto response = compute(query);
  expectProven(response, 1e-3);
  expectBracket(response.region, 0.786583, 1e-5);
  EXPECT_EQ(3.0, response.region.hypotheses.psi_max);
}

TEST(ComputeLargestRegion, saysWhatItMeansForLimitsThatAreLeftAside)
{
  RegionRequest query;
  EXPECT_EQ(std::string::npos, compute(query).region.message.find("Joint limits are off"));
  query.criterion.joint_limits = CriterionRequest::OFF;
  const auto free = compute(query);
  EXPECT_FALSE(free.region.hypotheses.joint_limits);
  EXPECT_NE(std::string::npos, free.message.find(". Joint limits are off: all rails stay within their limits."))
      << free.message;
}

TEST(ComputeLargestRegion, saysEveryBoundInEffect)
{
  RegionRequest query;
  query.criterion.force_min = 0.6;
  query.criterion.force_max = 1.5;
  query.criterion.kappa_max = 2.0;
  query.criterion.joint_limits = CriterionRequest::ON;
  const auto bounded = compute(query);
  expectProven(bounded, 1e-3);
  EXPECT_EQ(Hypotheses::DEXTROUS, bounded.region.hypotheses.set);
  EXPECT_EQ(Hypotheses::OWN, bounded.region.hypotheses.aspect);
  EXPECT_EQ(0.6, bounded.region.hypotheses.force_min);
  EXPECT_EQ(1.5, bounded.region.hypotheses.force_max);
  EXPECT_EQ(2.0, bounded.region.hypotheses.kappa_max);
  EXPECT_TRUE(bounded.region.hypotheses.joint_limits);
  EXPECT_LT(bounded.region.size_upper_bound, compute(RegionRequest()).region.size) << "the bounds had no effect";
}

TEST(ComputeLargestRegion, takesForceFactorsInPlaceOfVelocityFactors)
{
  RegionRequest query;
  query.criterion.set = CriterionRequest::REACHABLE;
  query.criterion.force_min = 0.5;
  query.criterion.force_max = 2.0;
  query.criterion.kappa_max = INF;
  const auto response = compute(query);
  expectProven(response, 1e-3);
  expectBracket(response.region, SERVED_EDGE, 0.0);
  EXPECT_EQ(Hypotheses::REACHABLE, response.region.hypotheses.set);
  EXPECT_EQ(0.0, response.region.hypotheses.psi_max);
  EXPECT_EQ(2.0, response.region.hypotheses.force_max);
  EXPECT_EQ(0.0, response.region.hypotheses.kappa_max);
}

TEST(ComputeLargestRegion, findsSquaresAndBoxes)
{
  RegionRequest query;
  query.shape = RegionRequest::SQUARE;
  const auto square = compute(query);
  expectProven(square, 1e-3);
  EXPECT_EQ(0.0, square.region.solid.dimensions[2]);
  EXPECT_EQ(0.0, square.region.volume_upper_bound);

  query.shape = RegionRequest::BOX;
  query.proportions.x = query.proportions.y = query.proportions.z = 2.0;
  const auto box = compute(query);
  expectProven(box, 1e-3);
  expectBracket(box.region, 0.5 * SERVED_EDGE, 0.0);
  EXPECT_EQ(2.0 * box.region.size, box.region.solid.dimensions[0]);
  EXPECT_GT(square.region.size_upper_bound, 2.0 * box.region.size);
}

TEST(ComputeLargestRegion, bracketsAFreeRatioByItsVolume)
{
  RegionRequest query;
  query.shape = RegionRequest::CYLINDER;
  query.accuracy = 1e-2;
  query.ratio_min = query.ratio_max = 0.5;
  const Region fixed = compute(query).region;
  EXPECT_EQ(0.0, fixed.ratio_max);
  query.ratio_max = 0.8;
  const Region free = compute(query).region;
  EXPECT_EQ(Region::PROVEN, free.status) << free.message;
  EXPECT_EQ(0.5, free.ratio_min);
  EXPECT_EQ(0.8, free.ratio_max);
  EXPECT_GT(fixed.size, free.size + 0.05);
  EXPECT_LE(fixed.size, free.size_upper_bound);
  EXPECT_LE(fixed.volume, free.volume_upper_bound);
}

TEST(ComputeLargestRegion, findsRoundShapes)
{
  RegionRequest query;
  query.shape = RegionRequest::SPHERE;
  const auto sphere = compute(query);
  expectProven(sphere, 1e-3);
  EXPECT_EQ(shape_msgs::SolidPrimitive::SPHERE, sphere.region.solid.type);
  EXPECT_EQ(std::vector<double>{ sphere.region.size }, sphere.region.solid.dimensions);

  query.shape = RegionRequest::CYLINDER;
  query.ratio_min = query.ratio_max = 0.5;
  const auto cylinder = compute(query);
  expectProven(cylinder, 1e-3);
  EXPECT_EQ(shape_msgs::SolidPrimitive::CYLINDER, cylinder.region.solid.type);
  EXPECT_EQ((std::vector<double>{ cylinder.region.size, 0.5 * cylinder.region.size }),
            cylinder.region.solid.dimensions);
}

TEST(ComputeLargestRegion, keepsTheCenterInTheSearchBox)
{
  RegionRequest query;
  query.use_search_box = true;
  query.min_corner.x = query.max_corner.x = 0.2;
  query.min_corner.y = query.min_corner.z = -0.5;
  query.max_corner.y = query.max_corner.z = 0.5;
  const auto response = compute(query);
  expectProven(response, 1e-3);
  EXPECT_EQ(0.2, response.region.center.x);
  EXPECT_LT(response.region.size_upper_bound, SERVED_EDGE);
  EXPECT_TRUE(response.region.use_search_box);
  EXPECT_EQ(query.max_corner.y, response.region.max_corner.y);
}

TEST(ComputeLargestRegion, answersThatThereIsNone)
{
  RegionRequest query;
  query.criterion.psi_min = 1.0;
  query.criterion.psi_max = 1.0;
  const auto response = compute(query);
  EXPECT_EQ(ErrorCode::SUCCESS, response.error_code) << response.message;
  EXPECT_EQ(Region::NONE, response.region.status);
  EXPECT_EQ(0.0, response.region.size);
  EXPECT_TRUE(response.region.joint_ranges.empty());
  EXPECT_FALSE(response.message.empty());
}

TEST(GetRegion, givesTheLastAnswer)
{
  RegionRequest query;
  query.accuracy = 0.01;
  const auto computed = compute(query);
  const auto got = call<GetRegion>("get_region", GetRegion::Request());
  EXPECT_EQ(ErrorCode::SUCCESS, got.error_code) << got.message;
  EXPECT_EQ(computed.region, got.region);
  EXPECT_EQ(computed.message, got.message);
}

TEST(ComputeLargestRegion, findsTheCubeOfTheOtherAspectAndOfReachAlone)
{
  RegionRequest other;
  other.criterion.aspect = CriterionRequest::OTHER;
  other.accuracy = 1e-5;
  const auto response = compute(other);
  expectProven(response, 1e-5);
  expectBracket(response.region, 0.062854514, 1e-5);
  EXPECT_EQ(Hypotheses::OTHER, response.region.hypotheses.aspect);

  RegionRequest reach;
  reach.criterion.set = CriterionRequest::REACHABLE;
  reach.criterion.aspect = CriterionRequest::BOTH;
  expectBracket(compute(reach).region, std::sqrt(2.0), 1e-9);
}

TEST(ComputeLargestRegion, goesOnInMultiPrecisionWhereAsked)
{
  RegionRequest request;
  request.accuracy = 1e-13;
  EXPECT_EQ(Region::STOPPED, compute(request).region.status);
  request.multi_precision = true;
  const auto response = compute(request);
  expectProven(response, 1e-13);
  expectBracket(response.region, SERVED_EDGE, 1e-15);
}
}  // namespace test
}  // namespace pkm_workspace
