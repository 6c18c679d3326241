// SPDX-License-Identifier: BSD-3-Clause
// The box that is dragged in rviz: its handles, its verdict, its menu.
#include <pkm_workspace/SetCriterion.h>

#include <cmath>
#include <limits>

#include "mechanism.h"

namespace pkm_workspace
{
namespace test
{
using BoxMarkerTest = Mechanism;

TEST_F(BoxMarkerTest, hasABoxWhoseVerdictColorsIt)
{
  const auto boxOf = [](const std::vector<Marker>& found) { return named(found, "box"); };
  drag("box", Eigen::Vector3d(0.02, 0.02, 0.02));
  const auto small =
      markers("box_markers", [&](const auto& found) { return std::abs(boxOf(found).pose.position.x - 0.02) < 1e-9; });
  EXPECT_GT(boxOf(small).color.g, boxOf(small).color.r) << textOf(small, "verdict");
  EXPECT_NE(std::string::npos, textOf(small, "verdict").find("box inside"));
  drag("box_x1", Eigen::Vector3d(0.3, 0.0, 0.0));
  const auto large = markers("box_markers", [&](const auto& found) { return boxOf(found).scale.x > 0.2; });
  EXPECT_GT(boxOf(large).color.r, boxOf(large).color.g) << textOf(large, "verdict");
  EXPECT_NE(std::string::npos, textOf(large, "verdict").find("box outside"));
  EXPECT_GT(named(large, "bad_point").scale.x, 0.0);
}

TEST_F(BoxMarkerTest, hasHandlesThatNothingElseHides)
{
  drag("box", NEAR_ZERO);
  const auto shown = markers("box_markers", [](const std::vector<Marker>& found) {
    return std::abs(named(found, "box").pose.position.x - NEAR_ZERO.x()) < 1e-9;
  });
  const Marker box = named(shown, "box");
  const auto grip = handle("box");
  ASSERT_EQ(1U, grip.controls.size());
  EXPECT_EQ(visualization_msgs::InteractiveMarkerControl::MOVE_3D, grip.controls[0].interaction_mode);
  ASSERT_EQ(1U, grip.controls[0].markers.size());
  EXPECT_GT(grip.controls[0].markers[0].scale.x, box.scale.x) << "the mouse finds what is shown, and not the handle";
  EXPECT_LT(grip.controls[0].markers[0].color.a, 0.1F) << "it hides the verdict's color";
  EXPECT_EQ(2U, grip.menu_entries.size());
  const auto face = handle("box_x0");
  ASSERT_EQ(1U, face.controls.size());
  const double radius = 0.5 * face.controls[0].markers.at(0).scale.x;
  EXPECT_LT(placeOf(face).x() + radius, NEAR_ZERO.x() - 0.5 * box.scale.x) << "the ball is not in front of its face";
  EXPECT_NEAR(NEAR_ZERO.y(), placeOf(face).y(), 1e-9);
}

TEST_F(BoxMarkerTest, ignoresWhatMakesNoSense)
{
  drag("box", Eigen::Vector3d::Constant(std::nan("")));
  drag("box_x1", Eigen::Vector3d::Constant(std::numeric_limits<double>::infinity()));
  drag("box", 2.0 * NEAR_ZERO);
  const auto shown = markers("box_markers", [](const std::vector<Marker>& found) {
    return std::abs(named(found, "box").pose.position.x - 2.0 * NEAR_ZERO.x()) < 1e-9;
  });
  EXPECT_TRUE(placeOf(handle("box_x1")).allFinite());
  EXPECT_GT(named(shown, "box").color.g, named(shown, "box").color.r) << textOf(shown, "verdict");
}

TEST_F(BoxMarkerTest, isJudgedByTheCriterionOfNow)
{
  const auto isGreen = [](const std::vector<Marker>& found) {
    return named(found, "box").color.g > named(found, "box").color.r;
  };
  drag("box", NEAR_ZERO);
  markers("box_markers", isGreen);
  SetCriterion::Request request;
  request.criterion.psi_min = 0.99;
  request.criterion.psi_max = 1.01;
  ASSERT_EQ(ErrorCode::SUCCESS, call<SetCriterion>("set_criterion", request).error_code);
  const auto red = markers("box_markers", [&](const auto& found) { return !isGreen(found); });
  EXPECT_NE(std::string::npos, red.front().text.find("1.01")) << "the picture does not say what it holds for";
  request.criterion.psi_min = 0.5;
  request.criterion.psi_max = 2.0;
  ASSERT_EQ(ErrorCode::SUCCESS, call<SetCriterion>("set_criterion", request).error_code);
  markers("box_markers", isGreen);
}

TEST_F(BoxMarkerTest, growsTheBoxToTheLargestAtItsCenter)
{
  const Eigen::Vector3d center = Eigen::Vector3d::Constant(0.086273015 * 0.31058);
  drag("box", center);
  InteractiveMarkerFeedback menu;
  menu.client_id = "test";
  menu.marker_name = "box";
  menu.header.frame_id = "base_link";
  menu.pose.orientation.w = 1.0;
  menu.event_type = InteractiveMarkerFeedback::MENU_SELECT;
  menu.menu_entry_id = 2;  // "Make it a cube"
  feedback_.publish(menu);
  menu.menu_entry_id = 1;  // "Grow to the largest here"
  feedback_.publish(menu);
  const double edge = 0.643950551 * 0.31058;
  const auto grown = markers("box_markers", [&](const std::vector<Marker>& found) {
    return std::abs(named(found, "box").scale.y - edge) < 2e-3 && std::abs(named(found, "box").scale.x - edge) < 2e-3;
  });
  EXPECT_LE(named(grown, "box").scale.x, edge + 1e-9);
  EXPECT_EQ(std::string::npos, textOf(grown, "verdict").find("outside"));
}

}  // namespace test
}  // namespace pkm_workspace
