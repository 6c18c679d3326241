// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <set>
#include <utility>

#include "drawing.h"

namespace pkm_workspace
{
namespace test
{
namespace
{
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

/// What a closed surface of triangles encloses that show their front outside.
double volumeIn(const Marker& surface)
{
  double volume = 0.0;
  for (std::size_t i = 0; i + 2 < surface.points.size(); i += 3)
    volume +=
        vectorOf(surface.points[i]).dot(vectorOf(surface.points[i + 1]).cross(vectorOf(surface.points[i + 2]))) / 6.0;
  return volume;
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

TEST(Markers, drawTheSurfaceOfBoxesThatTouch)
{
  const Paving paving = smallPaving();
  const auto array = draw(regionWithSides(1.0, 1.0, 1.0), &paving, true);
  const auto inside = inNamespace(array, "paving_inside");
  ASSERT_EQ(1U, inside.size());
  ASSERT_EQ(Marker::TRIANGLE_LIST, inside[0].type);
  EXPECT_EQ(inside[0].points.size(), inside[0].colors.size()) << "rviz would light it from one side";
  EXPECT_EQ(12.0, areaOf(inside[0])) << "1 x 2 x 1 and 0.5 x 1 x 1, which share a face";
  EXPECT_NEAR(2.5, volumeIn(inside[0]), 1e-12);
  const auto boundary = inNamespace(array, "paving_boundary");
  ASSERT_EQ(1U, boundary.size());
  EXPECT_EQ(4.5, areaOf(boundary[0])) << "without what touches the boxes inside";
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
  const auto array = markersOf(SetSurface(paving, orthoglide(), SetColors::VERDICT, true),
                               premisesOf(orthoglide(), criterion), orthoglide(), workspace);
  EXPECT_EQ(Marker::DELETEALL, array.markers.front().action);
  EXPECT_EQ(1U, inNamespace(array, "inside").size());
  const auto boundary = inNamespace(array, "boundary");
  ASSERT_EQ(1U, boundary.size());
  EXPECT_NE(inNamespace(array, "inside")[0].color, boundary[0].color);
  EXPECT_TRUE(ofType(array.markers, Marker::TEXT_VIEW_FACING).empty()) << "hypotheses have one panel of their own";
  const std::string& caption = array.markers.front().text;
  EXPECT_EQ(0U, caption.find("orthoglide, geometry ")) << caption;
  EXPECT_NE(std::string::npos, caption.find("3]")) << caption;
}

TEST(Markers, drawAncestorsOfBoxesThatAreTooMany)
{
  PavingQuery query;
  query.resolution = 0.01;
  const Paving paving = pave(orthoglide(), query);
  ASSERT_GT(paving.tree.count(CellState::INSIDE) + paving.tree.count(CellState::BOUNDARY), 20000);
  std::size_t triangles = 0;
  const auto array = markersOf(SetSurface(paving, orthoglide(), SetColors::CONDITION, true), paving.premises,
                               orthoglide(), Workspace());
  for (const Marker& marker : array.markers)
    triangles += marker.points.size() / 3;
  EXPECT_LE(triangles, 20000U) << "rviz would draw fewer than ten pictures a second";
  EXPECT_GT(triangles, 2000U);
  const double volume = volumeIn(inNamespace(array, "inside")[0]);
  EXPECT_LE(volume, paving.volume_inside.upper());
  EXPECT_GE(volume, 0.8 * paving.volume_inside.lower());
}

TEST(Markers, giveFlatBoxesAThickness)
{
  Paving paving;
  paving.box = { { 0.0, 0.0, 0.0 }, { 1.0, 1.0, 0.0 } };
  paving.tree = BoxTree(Bisection(paving.box, 1.0));
  paving.tree.addLevel({ CellState::INSIDE });
  const auto lists = inNamespace(draw(regionWithSides(1.0, 1.0, 0.0), &paving), "paving_inside");
  ASSERT_EQ(1U, lists.size());
  EXPECT_GT(volumeIn(lists[0]), 0.0);
  for (const auto& point : lists[0].points)
    EXPECT_LT(point.z, 0.0) << "it hides the square";
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
