// SPDX-License-Identifier: BSD-3-Clause
// Regions of given measures, and those that stand on a plane, by requests.
#include "node_client.h"
#include "pkm_workspace/ros/client.h"

namespace pkm_workspace
{
namespace test
{
namespace
{
/// Planners take the answer's solid as it is.
void expectInside(Client& machine, const Region& region)
{
  EXPECT_EQ(Region::PROVEN, region.status) << region.message;
  const Triple center = { region.center.x, region.center.y, region.center.z };
  EXPECT_EQ(machine.INSIDE, machine.checkSolid(center, region.solid).verdict) << region.shape;
}
}  // namespace

TEST(PlacedRegion, standsOnItsBase)
{
  Client machine;
  const Region cylinder = machine.largestRegion(with::shape("cylinder"), with::radius(0.2), with::base_z(-0.25));
  expectInside(machine, cylinder);
  EXPECT_EQ(Region::CYLINDER, cylinder.shape);
  EXPECT_TRUE(cylinder.use_base);
  EXPECT_FALSE(cylinder.use_search_box);
  EXPECT_EQ(-0.25, cylinder.base_z);
  ASSERT_EQ(2U, cylinder.solid.dimensions.size());
  EXPECT_EQ(0.2, cylinder.solid.dimensions[1]);
  EXPECT_NEAR(cylinder.size, cylinder.solid.dimensions[0], 1e-15);
  EXPECT_NEAR(-0.25, cylinder.center.z - 0.5 * cylinder.solid.dimensions[0], 1e-15);

  const Region cube = machine.largestRegion(with::base_z(-0.5), with::search_box({ 0, 0, -1 }, { 0.1, 0, 1 }));
  expectInside(machine, cube);
  EXPECT_TRUE(cube.use_search_box);
  EXPECT_EQ(-0.5, cube.min_corner.z);
  EXPECT_EQ(-0.5, cube.max_corner.z);
  EXPECT_EQ(0.0, cube.center.y);
  EXPECT_NEAR(-0.5, cube.center.z - 0.5 * cube.solid.dimensions[2], 1e-15);
}

TEST(PlacedRegion, hasGivenMeasures)
{
  Client machine;
  const Region wide = machine.largestRegion(with::shape("cylinder"), with::height(0.5));
  expectInside(machine, wide);
  EXPECT_EQ(0.5, wide.solid.dimensions[0]);
  EXPECT_EQ(wide.size, wide.solid.dimensions[1]);
  EXPECT_EQ(0.0, wide.proportions.z);
  const Region high = machine.largestRegion(with::shape("box"), with::footprint(0.25, 0.5));
  expectInside(machine, high);
  EXPECT_EQ((std::vector<double>{ 0.25, 0.5, high.size }), high.solid.dimensions);
}

TEST(PlacedRegion, isAPolytope)
{
  Client machine;
  const std::vector<Triple> vertices = {
    { 0.5, 0, -0.25 }, { -0.25, 0.5, -0.25 }, { -0.25, -0.5, -0.25 }, { 0, 0, 0.75 }
  };
  const Region region = machine.largestRegion(with::shape("polytope"), with::vertices(vertices));
  EXPECT_EQ(Region::PROVEN, region.status) << region.message;
  EXPECT_EQ(Region::POLYTOPE, region.shape);
  EXPECT_TRUE(region.solid.dimensions.empty());
  ASSERT_EQ(4U, region.vertices.size());
  const auto scaled = [&](double size) {
    std::vector<Triple> points;
    for (const geometry_msgs::Point& vertex : region.vertices)
      points.push_back({ size * vertex.x, size * vertex.y, size * vertex.z });
    return points;
  };
  const Triple center = { region.center.x, region.center.y, region.center.z };
  EXPECT_EQ(machine.INSIDE, machine.checkPolytope(center, scaled(region.size * (1.0 - 1e-12))).verdict);
  const auto outside = machine.checkPolytope(center, scaled(region.size_upper_bound * (1.0 + 1e-6)));
  EXPECT_EQ(machine.OUTSIDE, outside.verdict);
  EXPECT_FALSE(machine.evaluate({ outside.bad_point.x, outside.bad_point.y, outside.bad_point.z }).verdict ==
               machine.INSIDE);
  const Region standing = machine.largestRegion(with::shape("polytope"), with::vertices(vertices), with::base_z(-0.25));
  EXPECT_EQ(-0.25, standing.center.z);
  EXPECT_LE(standing.size, region.size_upper_bound);
  for (const geometry_msgs::Point& vertex : standing.vertices)
    EXPECT_GE(vertex.z, 0.0);
}

// Its corners are turned by the answer's orientation here, and checked as those of a polytope.
TEST(PlacedRegion, isTurned)
{
  Client machine;
  const auto box = [&](bool turned) {
    return machine.largestRegion(with::shape("box"), with::proportions({ 2, 1, 0.5 }), with::turned(turned));
  };
  const Region straight = box(false);
  EXPECT_FALSE(straight.turned);
  EXPECT_EQ(1.0, straight.orientation.w);
  const Region region = box(true);
  EXPECT_EQ(Region::PROVEN, region.status) << region.message;
  EXPECT_TRUE(region.turned);
  EXPECT_GT(region.size, straight.size_upper_bound + 0.1);
  const Eigen::Quaterniond turn(region.orientation.w, region.orientation.x, region.orientation.y, region.orientation.z);
  EXPECT_LT(turn.angularDistance(Eigen::Quaterniond(Eigen::AngleAxisd(region.angle, Eigen::Vector3d::UnitZ()))), 1e-7);
  std::vector<Triple> corners;
  for (int bits = 0; bits < 8; ++bits)
  {
    Eigen::Vector3d corner;
    for (int axis = 0; axis < 3; ++axis)
      corner[axis] =
          (bits >> axis & 1 ? 0.5 : -0.5) * (1.0 - 1e-9) * region.solid.dimensions[static_cast<std::size_t>(axis)];
    corner = turn * corner;
    corners.push_back({ corner.x(), corner.y(), corner.z() });
  }
  const Triple center = { region.center.x, region.center.y, region.center.z };
  EXPECT_EQ(machine.INSIDE, machine.checkPolytope(center, corners).verdict);
}

TEST(PlacedRegion, isNoPolytope)
{
  Client machine;
  const auto refused = [&](const std::vector<Triple>& vertices, const shape_msgs::SolidPrimitive& solid) {
    try
    {
      machine.checkSolid({ 0, 0, 0 }, solid, with::vertices(vertices));
    }
    catch (const Refused& refusal)
    {
      EXPECT_EQ(ErrorCode::INVALID_REQUEST, refusal.error_code);
      return std::string(refusal.what());
    }
    return std::string("answered");
  };
  EXPECT_NE(std::string::npos, refused({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 1, 1, 0 } }, {}).find("one plane"));
  EXPECT_NE(std::string::npos,
            refused({ { 0, 0, 0 }, { 1, 0, 0 } }, {}).find("vertices are 2: a polytope has at least"));
  shape_msgs::SolidPrimitive sphere;
  sphere.type = shape_msgs::SolidPrimitive::SPHERE;
  sphere.dimensions = { 0.1 };
  EXPECT_NE(std::string::npos,
            refused({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } }, sphere).find("only one of the two"));
}

TEST(PlacedRegion, isAboutAGivenCenter)
{
  Client machine;
  const Region region = machine.largestRegion(with::center({ 0.125, 0, 0 }));
  expectInside(machine, region);
  EXPECT_EQ(0.125, region.center.x);
  EXPECT_TRUE(region.use_search_box);
  EXPECT_EQ(region.min_corner, region.max_corner);
  EXPECT_LT(region.size_upper_bound, machine.largestRegion().size);
}
}  // namespace test
}  // namespace pkm_workspace
