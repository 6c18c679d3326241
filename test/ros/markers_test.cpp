// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/ros/markers.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <utility>

#include "pkm_workspace/machine/catalogue.h"

namespace pkm_workspace
{
namespace test
{
namespace
{
using visualization_msgs::Marker;
using Markers = std::vector<Marker>;

Region regionWithSides(double x, double y, double z)
{
  Region region;
  region.header.frame_id = "base_link";
  region.header.stamp = ros::Time(100.0);
  region.shape = Region::BOX;
  region.size = 1.0;
  region.solid.type = shape_msgs::SolidPrimitive::BOX;
  region.solid.dimensions = { x, y, z };
  RailRange range;
  range.joint = "rail_x";
  range.lower = -0.25;
  range.upper = 0.5;
  range.stroke_upper_bound = 0.75;
  region.joint_ranges = { range };
  return region;
}

/// Halves across x, then across y; of the half with the smaller x both, of the other one none.
Paving smallPaving()
{
  using State = CellState;
  Paving paving;
  paving.box = { { 0.0, 0.0, 0.0 }, { 2.0, 2.0, 1.0 } };
  paving.tree = BoxTree(Bisection(paving.box, 0.5));
  paving.tree.addLevel({ State::SPLIT });
  paving.tree.addLevel({ State::SPLIT, State::SPLIT });
  paving.tree.addLevel({ State::INSIDE, State::INSIDE, State::SPLIT, State::BOUNDARY });
  paving.tree.addLevel({ State::INSIDE, State::OUTSIDE });
  return paving;
}

Markers inNamespace(const visualization_msgs::MarkerArray& array, const std::string& ns)
{
  Markers found;
  for (const Marker& marker : array.markers)
    if (marker.ns == ns)
      found.push_back(marker);
  return found;
}

Markers ofType(const Markers& markers, int type)
{
  Markers found;
  for (const Marker& marker : markers)
    if (marker.type == type)
      found.push_back(marker);
  return found;
}

visualization_msgs::MarkerArray draw(const Region& region, const Paving* paving = nullptr, bool show_boundary = false)
{
  return markersOf(region, premisesOf(orthoglide(), Criterion()), orthoglide(), paving, show_boundary);
}
}  // namespace

TEST(Markers, replaceWhatWasShownBefore)
{
  const Paving paving = smallPaving();
  const auto array = draw(regionWithSides(1.0, 1.0, 1.0), &paving, true);
  EXPECT_EQ(Marker::DELETEALL, array.markers.front().action);
  std::set<std::pair<std::string, int>> names;
  for (std::size_t i = 1; i < array.markers.size(); ++i)
  {
    EXPECT_EQ(Marker::ADD, array.markers[i].action);
    EXPECT_TRUE(names.insert({ array.markers[i].ns, array.markers[i].id }).second) << "one name twice";
  }
}

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

TEST(Markers, showASquareAsTriangles)
{
  const auto markers = inNamespace(draw(regionWithSides(1.0, 1.0, 0.0)), "region");
  EXPECT_TRUE(ofType(markers, Marker::CUBE).empty());
  const auto faces = ofType(markers, Marker::TRIANGLE_LIST);
  ASSERT_EQ(1U, faces.size());
  for (const auto& point : faces[0].points)
    EXPECT_EQ(0.0, point.z);
  double area = 0.0;
  for (std::size_t i = 0; i + 2 < faces[0].points.size(); i += 3)
  {
    const auto* const p = &faces[0].points[i];
    area += 0.5 * std::abs((p[1].x - p[0].x) * (p[2].y - p[0].y) - (p[2].x - p[0].x) * (p[1].y - p[0].y));
  }
  EXPECT_EQ(1.0, area);
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

TEST(Markers, putBoxesOfOneSizeIntoOneList)
{
  const Paving paving = smallPaving();
  const auto lists = inNamespace(draw(regionWithSides(1.0, 1.0, 1.0), &paving), "paving_inside");
  ASSERT_EQ(2U, lists.size());
  EXPECT_EQ(2U, lists[0].points.size());
  EXPECT_EQ(1.0, lists[0].scale.x);
  EXPECT_EQ(0.5, lists[0].points[0].x);
  EXPECT_EQ(1.5, lists[0].points[1].y);
  EXPECT_EQ(1U, lists[1].points.size());
  EXPECT_EQ(0.5, lists[1].scale.x);
  EXPECT_EQ(1.0, lists[1].scale.z);
  EXPECT_EQ(1.25, lists[1].points[0].x);
}

TEST(Markers, showTheBoundaryOnlyWhenAsked)
{
  const Paving paving = smallPaving();
  EXPECT_TRUE(inNamespace(draw(regionWithSides(1.0, 1.0, 1.0), &paving, false), "paving_boundary").empty());
  EXPECT_EQ(1U, inNamespace(draw(regionWithSides(1.0, 1.0, 1.0), &paving, true), "paving_boundary").size());
}

TEST(Markers, drawAPavingByItselfByVerdict)
{
  const Paving paving = smallPaving();
  Workspace workspace;
  workspace.header.frame_id = "base_link";
  Criterion criterion;
  criterion.psi_max = 3.0;
  const auto array = markersOf(paving, premisesOf(orthoglide(), criterion), orthoglide(), workspace);
  EXPECT_EQ(Marker::DELETEALL, array.markers.front().action);
  EXPECT_EQ(2U, inNamespace(array, "inside").size());
  const auto boundary = inNamespace(array, "boundary");
  ASSERT_EQ(1U, boundary.size());
  EXPECT_EQ(1U, boundary[0].points.size());
  EXPECT_NE(inNamespace(array, "inside")[0].color, boundary[0].color);
  const auto captions = inNamespace(array, "hypotheses");
  ASSERT_EQ(1U, captions.size());
  EXPECT_EQ(0U, captions[0].text.find("orthoglide, geometry ")) << captions[0].text;
  EXPECT_NE(std::string::npos, captions[0].text.find("3]")) << captions[0].text;
  EXPECT_EQ(captions[0].text, array.markers.front().text);
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

TEST(Markers, drawAncestorsOfBoxesThatAreTooMany)
{
  PavingQuery query;
  query.resolution = 0.01;
  const Paving paving = pave(orthoglide(), query);
  ASSERT_GT(paving.tree.count(CellState::INSIDE) + paving.tree.count(CellState::BOUNDARY), 20000);
  std::size_t boxes = 0;
  double volume = 0.0;
  for (const Marker& marker : markersOf(paving, paving.premises, orthoglide(), Workspace()).markers)
  {
    boxes += marker.points.size();
    volume += static_cast<double>(marker.points.size()) * marker.scale.x * marker.scale.y * marker.scale.z;
  }
  EXPECT_LE(boxes, 20000U);
  EXPECT_GT(boxes, 2000U);
  EXPECT_GE(volume, paving.volumeUpper()) << "some boxes were cut";
}

TEST(Markers, giveFlatBoxesAThickness)
{
  Paving paving;
  paving.box = { { 0.0, 0.0, 0.0 }, { 1.0, 1.0, 0.0 } };
  paving.tree = BoxTree(Bisection(paving.box, 1.0));
  paving.tree.addLevel({ CellState::INSIDE });
  const auto lists = inNamespace(draw(regionWithSides(1.0, 1.0, 0.0), &paving), "paving_inside");
  ASSERT_EQ(1U, lists.size());
  EXPECT_GT(lists[0].scale.z, 0.0);
  EXPECT_LT(lists[0].points[0].z + 0.5 * lists[0].scale.z, 0.0) << "it hides the square";
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
  EXPECT_EQ("rail_x\nstroke <=\n0.75 m", labels[0].text);
}

TEST(Markers, roundWhatTheyPrintToTheSideOnWhichItHolds)
{
  Region region = regionWithSides(0.64395999, 0.64395999, 0.64395999);
  region.joint_ranges[0].stroke_upper_bound = 0.82745301;
  const auto array = draw(region);
  EXPECT_EQ("box 0.64395 x 0.64395 x 0.64395 m",
            ofType(inNamespace(array, "region"), Marker::TEXT_VIEW_FACING)[0].text);
  EXPECT_EQ("rail_x\nstroke <=\n0.82746 m",
            ofType(inNamespace(array, "joint_ranges"), Marker::TEXT_VIEW_FACING)[0].text);
}

/// Struts from above would cross what is written there.
TEST(Markers, nameTheRegionOnTheSideWhereNoStrutsAre)
{
  Region region = regionWithSides(0.5, 0.5, 0.5);
  region.joint_ranges.resize(3, region.joint_ranges[0]);
  const auto height = [&region](const Machine& machine) {
    const auto array = markersOf(region, premisesOf(machine, Criterion()), machine, nullptr, false);
    return ofType(inNamespace(array, "region"), Marker::TEXT_VIEW_FACING)[0].pose.position.z;
  };
  EXPECT_GT(height(orthoglide()), 0.25);
  region.center.z = -0.9;
  EXPECT_LT(height(uranesx()), -1.15);
}

TEST(Markers, showNoRegionWhereThereIsNone)
{
  Region none = regionWithSides(0.0, 0.0, 0.0);
  none.size = 0.0;
  none.joint_ranges.clear();
  const Paving paving = smallPaving();
  const auto array = draw(none, &paving);
  EXPECT_TRUE(inNamespace(array, "region").empty());
  EXPECT_TRUE(inNamespace(array, "joint_ranges").empty());
  EXPECT_FALSE(inNamespace(array, "paving_inside").empty());
}
}  // namespace test
}  // namespace pkm_workspace
