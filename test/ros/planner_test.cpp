// SPDX-License-Identifier: BSD-3-Clause
#include <pkm_workspace/CheckPath.h>
#include <pkm_workspace/CheckRegion.h>
#include <pkm_workspace/EvaluatePoint.h>

#include <cmath>
#include <limits>
#include <regex>

#include "node_client.h"
#include "pkm_workspace/dexterity/verdict.h"
#include "pkm_workspace/machine/catalogue.h"

namespace pkm_workspace
{
namespace test
{
namespace
{
const double EDGE = 1.0 / std::sqrt(6.0) + 1.0 / (3.0 * std::sqrt(2.0));  // of the largest cube [m]
const double CENTER = (1.0 / std::sqrt(6.0) - 1.0 / (3.0 * std::sqrt(2.0))) / 2.0;

CheckRegion::Request solid(std::uint8_t type, const std::vector<double>& dimensions)
{
  CheckRegion::Request request;
  request.solid.type = type;
  request.solid.dimensions = dimensions;
  request.center.x = request.center.y = request.center.z = CENTER;
  return request;
}

CheckRegion::Request cube(double edge)
{
  return solid(shape_msgs::SolidPrimitive::BOX, { edge, edge, edge });
}

CheckRegion::Response check(const CheckRegion::Request& request)
{
  return call<CheckRegion>("check_region", request);
}
}  // namespace

TEST(CheckRegion, hasNoTolerance)
{
  const auto inside = check(cube(EDGE - 1e-12));
  EXPECT_EQ(CheckRegion::Response::INSIDE, inside.verdict) << inside.message;
  EXPECT_EQ("base_link", inside.header.frame_id);
  EXPECT_EQ(2.0, inside.hypotheses.psi_max);
  const auto outside = check(cube(EDGE + 1e-12));
  ASSERT_EQ(CheckRegion::Response::OUTSIDE, outside.verdict) << outside.message;
  const Eigen::Vector3d bad(outside.bad_point.x, outside.bad_point.y, outside.bad_point.z);
  EXPECT_LE((bad.array() - CENTER).abs().maxCoeff(), 0.5 * (EDGE + 1e-12));
  EXPECT_EQ(BoxVerdict::OUTSIDE, BoxTest(orthoglide(), Criterion()).classify(bad));
}

TEST(CheckRegion, isAboutTheAspectThatIsAskedFor)
{
  CheckRegion::Request request = cube(0.06);
  request.center.x = request.center.y = request.center.z = -0.545923012;  // docs/values.md
  EXPECT_EQ(CheckRegion::Response::OUTSIDE, check(request).verdict);
  request.criterion.aspect = CriterionRequest::OTHER;
  const auto other = check(request);
  EXPECT_EQ(CheckRegion::Response::INSIDE, other.verdict) << other.message;
  EXPECT_EQ(Hypotheses::OTHER, other.hypotheses.aspect);
  request.criterion.aspect = CriterionRequest::BOTH;
  EXPECT_EQ(CheckRegion::Response::INSIDE, check(request).verdict);
}

TEST(CheckRegion, saysWhatItMeansForLimitsThatAreLeftAside)
{
  constexpr const char* REMARK = ". Joint limits are off: all rails stay within their limits.";
  CheckRegion::Request request = cube(0.5);
  EXPECT_EQ(std::string::npos, check(request).message.find("Joint limits"));
  request.criterion.joint_limits = CriterionRequest::OFF;
  EXPECT_NE(std::string::npos, check(request).message.find(REMARK));
  CheckPath::Request path;
  path.segments.resize(1);
  path.segments[0].kind = ToolSegment::LINE;
  path.segments[0].end.x = 0.1;
  path.criterion = request.criterion;
  EXPECT_NE(std::string::npos, call<CheckPath>("check_path", path).message.find(REMARK));
  EvaluatePoint::Request point;
  point.criterion = request.criterion;
  EXPECT_NE(std::string::npos, call<EvaluatePoint>("evaluate_point", point).message.find(REMARK));
}

/// At (0, 0, 1) two struts of 1 m are at right angles to their rails.
TEST(EvaluatePoint, saysOfAnEqualValueThatItIsEqual)
{
  EvaluatePoint::Request request;
  request.point.z = 1.0;
  const std::string message = call<EvaluatePoint>("evaluate_point", request).message;
  EXPECT_NE(std::string::npos, message.find("exactly")) << message;
  EXPECT_EQ(std::string::npos, message.find("within 0")) << message;
}

TEST(CheckRegion, takesSpheresAndCylinders)
{
  using Solid = shape_msgs::SolidPrimitive;
  EXPECT_EQ(CheckRegion::Response::INSIDE, check(solid(Solid::SPHERE, { 0.4 })).verdict);
  EXPECT_EQ(CheckRegion::Response::OUTSIDE, check(solid(Solid::SPHERE, { 0.8 })).verdict);
  EXPECT_EQ(CheckRegion::Response::INSIDE, check(solid(Solid::CYLINDER, { 0.4, 0.3 })).verdict);
  const auto outside = check(solid(Solid::CYLINDER, { 0.4, 0.9 }));
  EXPECT_EQ(CheckRegion::Response::OUTSIDE, outside.verdict);
  EXPECT_EQ(0U, outside.message.find("Proved: the bad point lies in the cylinder and is not ")) << outside.message;
  EXPECT_EQ(CheckRegion::Response::INSIDE, check(solid(Solid::CYLINDER, { 0.0, 0.3 })).verdict);
  EXPECT_EQ(CheckRegion::Response::INSIDE, check(solid(Solid::CYLINDER, { 0.3, 0.0 })).verdict);
}

TEST(CheckRegion, answersForTheCriterionOfTheRequest)
{
  CheckRegion::Request request = cube(0.7);
  EXPECT_EQ(CheckRegion::Response::OUTSIDE, check(request).verdict);
  request.criterion.psi_min = 1.0 / 3.0;
  request.criterion.psi_max = 3.0;
  const auto wider = check(request);
  EXPECT_EQ(CheckRegion::Response::INSIDE, wider.verdict);
  EXPECT_EQ(3.0, wider.hypotheses.psi_max);
}

TEST(CheckRegion, isUndecidedWhenItMayNotLook)
{
  CheckRegion::Request request = cube(0.6439);
  request.max_boxes = 10;
  const auto response = check(request);
  EXPECT_EQ(CheckRegion::Response::UNDECIDED, response.verdict);
  EXPECT_LE(response.boxes, 10);
}

TEST(CheckRegion, refusesWhatIsOutOfRange)
{
  struct Case
  {
    void (*spoil)(CheckRegion::Request&);
    const char* message;
    std::int32_t error_code = ErrorCode::INVALID_REQUEST;
  };
  const Case cases[] = {
    { [](CheckRegion::Request& r) { r.solid = shape_msgs::SolidPrimitive(); }, "solid.type = 0 must be BOX = 1" },
    { [](CheckRegion::Request& r) { r.solid.type = 2; }, "solid.dimensions = .* must be one radius" },
    { [](CheckRegion::Request& r) { r.solid.dimensions[2] = std::nan(""); },
      "solid.dimensions = .*nan.* must be three full sides" },
    { [](CheckRegion::Request& r) { r.solid.dimensions[0] = 1e200; },
      "solid.dimensions = .* three full sides, each 0 or from 1e-100 to 1e9" },
    { [](CheckRegion::Request& r) { r.solid.dimensions[0] = 1e-300; },
      "solid.dimensions = .* each 0 or from 1e-100 to 1e9" },
    { [](CheckRegion::Request& r) {
       r.solid.type = shape_msgs::SolidPrimitive::SPHERE;
       r.solid.dimensions = { 1e308 };
     },
      "solid.dimensions = .* one radius, from 1e-100 to 1e9" },
    { [](CheckRegion::Request& r) { r.center.x = 1e155; }, "center = \\(1e\\+155, .* must be finite, within 1e9 m" },
    { [](CheckRegion::Request& r) { r.center.y = std::nan(""); }, "center = .*nan.* must be finite" },
    { [](CheckRegion::Request& r) { r.criterion.psi_min = -1.0; }, "psi_min = -1" },
    { [](CheckRegion::Request& r) { r.max_boxes = -1; }, "max_boxes = -1" },
    { [](CheckRegion::Request& r) { r.header.frame_id = "nowhere"; }, "'nowhere' is not known",
      ErrorCode::UNKNOWN_FRAME },
  };
  for (const Case& bad : cases)
  {
    CheckRegion::Request request = cube(0.5);
    bad.spoil(request);
    const auto response = check(request);
    EXPECT_EQ(bad.error_code, response.error_code);
    EXPECT_EQ(0, response.verdict);
    EXPECT_TRUE(std::regex_search(response.message, std::regex(bad.message))) << response.message;
  }
}
}  // namespace test
}  // namespace pkm_workspace
