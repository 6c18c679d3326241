// SPDX-License-Identifier: BSD-3-Clause
#include <pkm_workspace/FindSingularities.h>
#include <visualization_msgs/MarkerArray.h>

#include <limits>
#include <regex>

#include "node_client.h"
#include "pkm_workspace/paving/range_workspace.h"
#include "pkm_workspace/urdf_io/urdf_reader.h"

namespace pkm_workspace
{
namespace test
{
namespace
{
FindSingularities::Request overCube(double edge)
{
  FindSingularities::Request request;
  request.over = FindSingularities::Request::REGION;
  request.aspect = FindSingularities::Request::BOTH;
  request.solid.type = shape_msgs::SolidPrimitive::BOX;
  request.solid.dimensions = { edge, edge, edge };
  request.center.x = request.center.y = request.center.z = 0.086;
  return request;
}

FindSingularities::Response find(const FindSingularities::Request& request)
{
  return call<FindSingularities>("find_singularities", request);
}
}  // namespace

TEST(FindSingularities, provesThatTheLargestCubeHasNone)
{
  const auto found = find(overCube(0.643));
  ASSERT_EQ(ErrorCode::SUCCESS, found.error_code) << found.message;
  ASSERT_EQ(3U, found.serial.size());
  for (const SingularityFinding& finding : { found.serial[0], found.serial[1], found.serial[2], found.parallel })
  {
    EXPECT_EQ(SingularityFinding::NONE, finding.status);
    EXPECT_GT(finding.least.lower, 0.0);
    EXPECT_LE(finding.least.lower, finding.least.upper);
  }
  EXPECT_EQ(Hypotheses::BOTH, found.hypotheses.aspect);
  EXPECT_EQ("base_link", found.header.frame_id);
}

// What is proved of every machine within tolerances is less, and its hypotheses say of which.
TEST(FindSingularities, ofEveryMachineWithinTolerances)
{
  FindSingularities::Request request = overCube(0.5);
  const auto meant = find(request);
  request.tolerances.resize(1);
  request.tolerances[0].kind = "tolerance_length";
  request.tolerances[0].values = { 0.01 };
  const auto built = find(request);
  ASSERT_EQ(ErrorCode::SUCCESS, built.error_code) << built.message;
  EXPECT_EQ(SingularityFinding::NONE, built.parallel.status);
  EXPECT_LT(built.parallel.least.lower, meant.parallel.least.lower);
  EXPECT_NE(meant.hypotheses.geometry_hash, built.hypotheses.geometry_hash);
  EXPECT_FALSE(built.hypotheses.tolerances.empty());
  request.own_tolerances = 7;
  EXPECT_EQ(ErrorCode::INVALID_REQUEST, find(request).error_code);
}

/// The stroke of the largest cube allows a parallel singularity elsewhere, against a sentence of the paper.
TEST(FindSingularities, provesOneWithinTheJointRangesOfTheCubeAndShowsIt)
{
  FindSingularities::Request request;
  request.over = FindSingularities::Request::JOINT_RANGES;
  request.aspect = FindSingularities::Request::BOTH;
  for (Bounds& range : request.ranges)
  {
    range.lower = -0.3;
    range.upper = 0.55;
  }
  const auto found = find(request);
  ASSERT_EQ(ErrorCode::SUCCESS, found.error_code) << found.message;
  ASSERT_EQ(SingularityFinding::PROVED, found.parallel.status) << found;
  const Machine machine = readUrdfFile(std::string(PKM_WORKSPACE_SOURCE_DIR) + "/urdf/orthoglide.urdf").machine;
  const Interval range(-0.3, 0.55);
  EXPECT_EQ(withJointLimits(machine, { range, range, range }).geometryHash(), found.hypotheses.geometry_hash);
  EXPECT_TRUE(found.hypotheses.joint_limits);
  EXPECT_TRUE(std::regex_search(found.message, std::regex("^Proved: there are .*parallel"))) << found.message;
  EXPECT_EQ(0.0, found.parallel.least.lower);
  EXPECT_LE(found.parallel.min_corner.x, found.parallel.max_corner.x);
  const auto markers = receive<visualization_msgs::MarkerArray>(NODE + "/singularity_markers")->markers;
  ASSERT_GE(markers.size(), 3U);
  EXPECT_EQ("singularity", markers[1].ns);
  EXPECT_NEAR(found.parallel.min_corner.x, markers[markers.size() - 2].pose.position.x, 0.01);
  EXPECT_EQ("parallel singularity", markers.back().text);
  EXPECT_EQ(std::string::npos, markers.front().text.find("accuracy")) << "it is relative, not in metres";
}

TEST(FindSingularities, countsPointsWhereDetAIsZeroInEachAspect)
{
  for (const std::uint8_t aspect :
       { FindSingularities::Request::OWN, FindSingularities::Request::OTHER, FindSingularities::Request::BOTH })
  {
    FindSingularities::Request request;
    request.over = FindSingularities::Request::REACHABLE;
    request.aspect = aspect;
    const auto found = find(request);
    EXPECT_EQ(SingularityFinding::PROVED, found.parallel.status) << found;
    EXPECT_EQ(
        "Proved: there are serial singularities of 'rail_x', 'rail_y', 'rail_z', parallel singularities, and no "
        "others. Joint limits are off: all rails stay within their limits.",
        found.message);
  }
}

TEST(FindSingularities, saysWhatItMeansForLimitsThatAreLeftAside)
{
  constexpr const char* REMARK = "Joint limits are off: all rails stay within their limits.";
  FindSingularities::Request request;
  EXPECT_EQ(std::string::npos, find(request).message.find("Joint limits")) << find(request).message;
  EXPECT_NE(std::string::npos, find(overCube(0.5)).message.find(REMARK)) << find(overCube(0.5)).message;
}

TEST(FindSingularities, saysWhatLeftSomethingUndecided)
{
  FindSingularities::Request request;
  request.over = FindSingularities::Request::REACHABLE;
  request.time_limit = 1e-9;
  const std::string message = find(request).message;
  EXPECT_NE(std::string::npos, message.find("parallel singularities, where the time limit of 1e-09 s ended the search"))
      << message;
}

TEST(FindSingularities, takesRoundSolids)
{
  FindSingularities::Request request = overCube(0.0);
  request.solid.type = shape_msgs::SolidPrimitive::CYLINDER;
  request.solid.dimensions = { 0.4, 0.2 };
  EXPECT_EQ(SingularityFinding::NONE, find(request).parallel.status);
  request.solid.type = shape_msgs::SolidPrimitive::SPHERE;
  request.solid.dimensions = { 0.3 };
  EXPECT_EQ(SingularityFinding::NONE, find(request).parallel.status);
}

TEST(FindSingularities, refusesWhatIsOutOfRange)
{
  struct Case
  {
    void (*spoil)(FindSingularities::Request&);
    const char* message;
  };
  const Case cases[] = {
    { [](FindSingularities::Request& r) { r.over = 4; }, "over = 4 must be JOINT_LIMITS = 0" },
    { [](FindSingularities::Request& r) { r.over = FindSingularities::Request::REACHABLE; },
      "solid and center must be empty and 0" },
    { [](FindSingularities::Request& r) { r.ranges[1].upper = 1.0; }, "ranges must be 0 .*unless over = JOINT_RANGES" },
    { [](FindSingularities::Request& r) { r.aspect = 4; },
      "aspect = 4 must be OWN = 1, OTHER = 2 or BOTH = 3, or 0 for both" },
    { [](FindSingularities::Request& r) { r.accuracy = -1.0; }, "accuracy = -1" },
    { [](FindSingularities::Request& r) { r.time_limit = 61.0; }, "time_limit = 61 s must be positive and at most" },
    { [](FindSingularities::Request& r) { r.solid.type = 4; }, "solid.type = 4 must be BOX = 1" },
    { [](FindSingularities::Request& r) { r.solid.dimensions.pop_back(); },
      "solid.dimensions = .* must be three full sides" },
    { [](FindSingularities::Request& r) {
       r.solid.dimensions = { 0.0, 0.0, 0.0 };
     },
      "solid.dimensions = \\(0, 0, 0\\) m must be" },
    { [](FindSingularities::Request& r) { r.solid.dimensions[0] = -1.0; },
      "solid.dimensions = \\(-1, .* each 0 or from 1e-100 to 1e9" },
    { [](FindSingularities::Request& r) { r.center.z = std::numeric_limits<double>::infinity(); },
      "center = .* m must be finite" },
  };
  for (const Case& bad : cases)
  {
    FindSingularities::Request request = overCube(0.5);
    bad.spoil(request);
    const auto response = find(request);
    EXPECT_EQ(ErrorCode::INVALID_REQUEST, response.error_code);
    EXPECT_TRUE(std::regex_search(response.message, std::regex(bad.message)))
        << "expected: " << bad.message << "\n     got: " << response.message;
    EXPECT_TRUE(response.serial.empty());
  }
}
}  // namespace test
}  // namespace pkm_workspace
