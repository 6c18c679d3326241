// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/ros/markers.h"

#include <gtest/gtest.h>

#include <cmath>

#include "drawing.h"

namespace pkm_workspace
{
namespace test
{
TEST(Markers, areLatchedForAnyTime)
{
  for (const Marker& marker : draw(regionWithSides(1.0, 1.0, 1.0)).markers)
  {
    EXPECT_EQ("base_link", marker.header.frame_id);
    EXPECT_TRUE(marker.header.stamp.isZero());
    EXPECT_EQ(1.0, marker.pose.orientation.w);
  }
}

TEST(Markers, showAllFacesOfABox)
{
  const auto faces = ofType(inNamespace(draw(regionWithSides(1.0, 2.0, 3.0)), "region"), Marker::TRIANGLE_LIST);
  ASSERT_EQ(1U, faces.size());
  EXPECT_EQ(12U * 3U, faces[0].points.size());
  for (const auto& point : faces[0].points)
    EXPECT_EQ(Eigen::Vector3d(0.5, 1.0, 1.5), Eigen::Vector3d(point.x, point.y, point.z).cwiseAbs());
}

TEST(Markers, showATurnedBox)
{
  Region region = regionWithSides(2.0, 1.0, 0.5);
  region.turned = true;
  region.angle = 0.5 * M_PI;
  region.center.x = 3.0;
  const Markers markers = inNamespace(draw(region), "region");
  for (const auto type : { Marker::TRIANGLE_LIST, Marker::LINE_LIST })
  {
    const Markers drawn = ofType(markers, type);
    ASSERT_EQ(1U, drawn.size());
    for (const auto& point : drawn[0].points)
    {
      EXPECT_NEAR(0.5, std::abs(point.x - 3.0), 1e-12);
      EXPECT_NEAR(1.0, std::abs(point.y), 1e-12);
      EXPECT_EQ(0.25, std::abs(point.z));
    }
  }
  const std::string label = ofType(markers, Marker::TEXT_VIEW_FACING)[0].text;
  EXPECT_NE(std::string::npos, label.find("\nturned by 90 degrees")) << label;
  region.angle = 0.25 * M_PI;
  const Markers edges = ofType(inNamespace(draw(region), "region"), Marker::LINE_LIST);
  for (const auto& point : edges[0].points)
  {
    EXPECT_NEAR(1.0, std::abs(point.x - 3.0 + point.y) / M_SQRT2, 1e-12) << "along its longer side";
    EXPECT_NEAR(0.5, std::abs(point.x - 3.0 - point.y) / M_SQRT2, 1e-12);
  }
}

TEST(Markers, showASquareAsTriangles)
{
  const auto markers = inNamespace(draw(regionWithSides(1.0, 1.0, 0.0)), "region");
  EXPECT_TRUE(ofType(markers, Marker::CUBE).empty());
  const auto faces = ofType(markers, Marker::TRIANGLE_LIST);
  ASSERT_EQ(1U, faces.size());
  for (const auto& point : faces[0].points)
    EXPECT_EQ(0.0, point.z);
  EXPECT_EQ(1.0, areaOf(faces[0]));
}

TEST(Markers, showRoundRegionsByTheirDimensions)
{
  Region region = regionWithSides(0.0, 0.0, 0.0);
  const auto drawn = [&region](std::uint8_t type, std::vector<double> dimensions) {
    region.solid.type = type;
    region.solid.dimensions = std::move(dimensions);
    return inNamespace(draw(region), "region");
  };
  const Markers sphere = drawn(shape_msgs::SolidPrimitive::SPHERE, { 0.5 });
  ASSERT_EQ(1U, ofType(sphere, Marker::SPHERE).size());
  EXPECT_EQ(1.0, ofType(sphere, Marker::SPHERE)[0].scale.z);
  const Markers cylinder = drawn(shape_msgs::SolidPrimitive::CYLINDER, { 2.0, 0.5 });
  ASSERT_EQ(1U, ofType(cylinder, Marker::CYLINDER).size());
  EXPECT_EQ(1.0, ofType(cylinder, Marker::CYLINDER)[0].scale.x);
  EXPECT_EQ(2.0, ofType(cylinder, Marker::CYLINDER)[0].scale.z);
  const Markers disc = drawn(shape_msgs::SolidPrimitive::CYLINDER, { 0.0, 0.5 });
  EXPECT_TRUE(ofType(disc, Marker::CYLINDER).empty()) << "no thickness: triangles";
  ASSERT_EQ(1U, ofType(disc, Marker::TRIANGLE_LIST).size());
  for (const auto& point : ofType(disc, Marker::TRIANGLE_LIST)[0].points)
    EXPECT_LE(std::hypot(point.x, point.y), 0.5 + 1e-12);
  for (const Markers& markers : { sphere, cylinder, disc })
    EXPECT_EQ(1U, ofType(markers, Marker::TEXT_VIEW_FACING).size());
}

TEST(Markers, showPolytopesByTheirHull)
{
  Region region = regionWithSides(0.0, 0.0, 0.0);
  region.shape = Region::POLYTOPE;
  region.solid.dimensions.clear();
  region.size = 0.5;
  for (int corner = 0; corner < 8; ++corner)
  {
    region.vertices.emplace_back();
    region.vertices.back().x = corner % 2;
    region.vertices.back().y = corner / 2 % 2;
    region.vertices.back().z = corner / 4;
  }
  const Markers markers = inNamespace(draw(region), "region");
  const auto faces = ofType(markers, Marker::TRIANGLE_LIST);
  ASSERT_EQ(1U, faces.size());
  EXPECT_EQ(12U * 3U, faces[0].points.size());
  EXPECT_NEAR(6.0 * 0.25, areaOf(faces[0]), 1e-12);
  const auto edges = ofType(markers, Marker::LINE_LIST);
  ASSERT_EQ(1U, edges.size());
  EXPECT_EQ(12U * 2U, edges[0].points.size()) << "not those between triangles of one face";
  ASSERT_EQ(1U, ofType(markers, Marker::TEXT_VIEW_FACING).size());
  EXPECT_NE(std::string::npos, ofType(markers, Marker::TEXT_VIEW_FACING)[0].text.find("polytope times 0.5"));
}

TEST(Markers, stayWhereTheMachineStoodWhenTheFrameMoves)
{
  const Pose root{ { 0.0, 0.0, std::sqrt(0.5), std::sqrt(0.5) }, { 1.0, 0.0, 0.0 } };  // a quarter about z
  const FramedMachine in{ "table", nullptr, "", root };
  Markers there(1);
  there[0].header.frame_id = "table";
  there[0].pose.position.x = 1.0;
  there[0].pose.position.y = 2.0;
  there[0].pose.orientation.w = 1.0;
  visualization_msgs::MarkerArray array;
  array.markers = there;
  const Marker moved = inRoot(array, in, "base_link").markers[0];
  EXPECT_EQ("base_link", moved.header.frame_id);
  EXPECT_NEAR(2.0, moved.pose.position.x, 1e-12);
  EXPECT_NEAR(0.0, moved.pose.position.y, 1e-12);
  EXPECT_NEAR(-std::sqrt(0.5), moved.pose.orientation.z, 1e-12);
}

TEST(Markers, drawJointRangesAlongTheRails)
{
  const auto markers = inNamespace(draw(regionWithSides(1.0, 1.0, 1.0)), "joint_ranges");
  const auto bars = ofType(markers, Marker::LINE_LIST);
  ASSERT_EQ(1U, bars.size());
  ASSERT_EQ(2U, bars[0].points.size());
  // the slider of the unit Orthoglide is at x = -1 for joint value 0
  EXPECT_EQ(-1.25, bars[0].points[0].x);
  EXPECT_EQ(-0.5, bars[0].points[1].x);
  const auto labels = ofType(markers, Marker::TEXT_VIEW_FACING);
  ASSERT_EQ(1U, labels.size());
  EXPECT_EQ("rail_x\n0.75 m", labels[0].text);
}

TEST(Markers, roundWhatTheyPrintToTheSideOnWhichItHolds)
{
  Region region = regionWithSides(0.64395999, 0.64395999, 0.64395999);
  region.joint_ranges[0].stroke_upper_bound = 0.82745301;
  const auto array = draw(region);
  EXPECT_EQ("box 0.6439 x 0.6439 x 0.6439 m", ofType(inNamespace(array, "region"), Marker::TEXT_VIEW_FACING)[0].text);
  EXPECT_EQ("rail_x\n0.8275 m", ofType(inNamespace(array, "joint_ranges"), Marker::TEXT_VIEW_FACING)[0].text);
}

TEST(Markers, writeNumbersAsPeopleDo)
{
  Region region = regionWithSides(0.3, 0.3, 0.3);
  region.joint_ranges[0].stroke_upper_bound = 0.7;
  const auto array = draw(region);
  EXPECT_EQ("box 0.3 x 0.3 x 0.3 m", ofType(inNamespace(array, "region"), Marker::TEXT_VIEW_FACING)[0].text);
  EXPECT_EQ("rail_x\n0.7 m", ofType(inNamespace(array, "joint_ranges"), Marker::TEXT_VIEW_FACING)[0].text);
  region.shape = Region::CUBE;
  EXPECT_EQ("cube 0.3 m", ofType(inNamespace(draw(region), "region"), Marker::TEXT_VIEW_FACING)[0].text);
}

/// Struts from above would cross what is written there.
TEST(Markers, nameTheRegionOnTheSideWhereNoStrutsAre)
{
  Region region = regionWithSides(0.5, 0.5, 0.5);
  region.joint_ranges.resize(3, region.joint_ranges[0]);
  const auto height = [&region](const Machine& machine) {
    const auto array = markersOf(region, premisesOf(machine, Criterion()), machine, NOT_DRAWN, nullptr);
    return ofType(inNamespace(array, "region"), Marker::TEXT_VIEW_FACING)[0].pose.position.z;
  };
  EXPECT_GT(height(orthoglide()), 0.25);
  region.center.z = -0.9;
  EXPECT_LT(height(uranesx()), -1.15);
}
}  // namespace test
}  // namespace pkm_workspace
