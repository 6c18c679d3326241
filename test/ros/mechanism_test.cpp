// SPDX-License-Identifier: BSD-3-Clause
// The closed mechanism in tf: it follows poses, rails and the handles of rviz, and stays closed.
#include <geometry_msgs/PoseStamped.h>
#include <sensor_msgs/JointState.h>
#include <tf2_ros/transform_listener.h>
#include <visualization_msgs/InteractiveMarkerFeedback.h>
#include <visualization_msgs/InteractiveMarkerInit.h>
#include <visualization_msgs/MarkerArray.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <functional>

#include "node_client.h"
#include "pkm_workspace/machine/catalogue.h"

namespace pkm_workspace
{
namespace test
{
namespace
{
using visualization_msgs::InteractiveMarkerFeedback;
using visualization_msgs::Marker;
using visualization_msgs::MarkerArray;

class Mechanism : public testing::Test
{
protected:
  Mechanism() : listener_(buffer_)
  {
    pose_ = node_.advertise<geometry_msgs::PoseStamped>(NODE + "/tool_pose", 1);
    rails_ = node_.advertise<sensor_msgs::JointState>(NODE + "/rail_states", 1);
    feedback_ = node_.advertise<InteractiveMarkerFeedback>(NODE + "/interactive_markers/feedback", 10);
    // the node's own region moves the model too: it comes first
    receive<Region>(NODE + "/region");
    waitFor([this] {
      return pose_.getNumSubscribers() > 0 && rails_.getNumSubscribers() > 0 && feedback_.getNumSubscribers() > 0;
    });
  }

  /// @return whether the condition came true in time
  static bool waitFor(const std::function<bool()>& condition)
  {
    const ros::WallTime end = ros::WallTime::now() + ros::WallDuration(PATIENCE.toSec());
    while (!condition())
    {
      if (ros::WallTime::now() > end)
        return false;
      ros::getGlobalCallbackQueue()->callAvailable(ros::WallDuration(0.01));
    }
    return true;
  }

  /// Where a tcp is by what tf knows at one time; somewhere else while it does not.
  Eigen::Vector3d tcp(int leg, const ros::Time& time) const
  {
    const std::string link = "tcp_" + std::to_string(leg);
    if (!buffer_.canTransform("base_link", link, time))
      return Eigen::Vector3d::Constant(1e9);
    const auto place = buffer_.lookupTransform("base_link", link, time).transform.translation;
    return { place.x, place.y, place.z };
  }

  bool hasTcps(const ros::Time& time) const
  {
    return buffer_.canTransform("base_link", "tcp_1", time) && buffer_.canTransform("base_link", "tcp_2", time) &&
           buffer_.canTransform("base_link", "tcp_3", time);
  }

  /// Waits until tf has the tool at a point. @return how far the three tcp frames are apart then [m]
  double gapOnceAt(const Eigen::Vector3d& p)
  {
    ros::Time time;
    const auto has = [this, &time] { return hasTcps(time); };
    const auto came = [&] {
      time = receive<sensor_msgs::JointState>("/joint_states")->header.stamp;
      return waitFor(has) && (tcp(1, time) - p).norm() < 1e-6;
    };
    EXPECT_TRUE(waitFor(came)) << "the model did not go to " << p.transpose();
    return std::max((tcp(1, time) - tcp(2, time)).norm(), (tcp(1, time) - tcp(3, time)).norm());
  }

  void publishPose(const Eigen::Vector3d& p)
  {
    geometry_msgs::PoseStamped message;
    message.pose.position.x = p.x();
    message.pose.position.y = p.y();
    message.pose.position.z = p.z();
    pose_.publish(message);
  }

  void drag(const std::string& name, const Eigen::Vector3d& p)
  {
    InteractiveMarkerFeedback message;
    message.client_id = "test";
    message.marker_name = name;
    message.event_type = InteractiveMarkerFeedback::POSE_UPDATE;
    message.header.frame_id = "base_link";
    message.pose.position.x = p.x();
    message.pose.position.y = p.y();
    message.pose.position.z = p.z();
    message.pose.orientation.w = 1.0;
    feedback_.publish(message);
  }

  /// Waits for markers that fit. @return the last ones
  std::vector<Marker> markers(const std::string& topic, const std::function<bool(const std::vector<Marker>&)>& fits)
  {
    std::vector<Marker> found;
    EXPECT_TRUE(waitFor([&] {
      found = receive<MarkerArray>(NODE + "/" + topic)->markers;
      return fits(found);
    }));
    return found;
  }

  ros::NodeHandle node_;
  tf2_ros::Buffer buffer_;
  tf2_ros::TransformListener listener_;
  ros::Publisher pose_;
  ros::Publisher rails_;
  ros::Publisher feedback_;
};

std::string textOf(const std::vector<Marker>& markers, const std::string& ns)
{
  for (const Marker& marker : markers)
    if (marker.ns == ns)
      return marker.text;
  return "";
}

Marker named(const std::vector<Marker>& markers, const std::string& ns)
{
  for (const Marker& marker : markers)
    if (marker.ns == ns)
      return marker;
  return Marker();
}

const Eigen::Vector3d NEAR_ZERO(0.02, -0.015, 0.01);
}  // namespace

TEST_F(Mechanism, followsPosesAndStaysClosed)
{
  for (const Eigen::Vector3d& p : { NEAR_ZERO, Eigen::Vector3d(-0.03, 0.05, 0.06), Eigen::Vector3d(0.1, 0.0, -0.04) })
  {
    publishPose(p);
    EXPECT_LE(gapOnceAt(p), 1e-9);
  }
}

TEST_F(Mechanism, followsItsRailsByForwardKinematics)
{
  const Machine machine = orthoglidePrototype();
  const auto rho = inverseKinematics(machine, NEAR_ZERO);
  ASSERT_TRUE(rho);
  sensor_msgs::JointState rails;
  for (const int leg : { 2, 0, 1 })
  {
    rails.name.push_back(machine.leg(leg).joint);
    rails.position.push_back((*rho)[leg]);
  }
  rails_.publish(rails);
  EXPECT_LE(gapOnceAt(NEAR_ZERO), 1e-9);
}

TEST_F(Mechanism, followsTheHandleAndShowsItsMargin)
{
  drag("tool", NEAR_ZERO);
  EXPECT_LE(gapOnceAt(NEAR_ZERO), 1e-9);
  const auto shown = markers("tool_markers", [](const std::vector<Marker>& found) {
    return std::abs(named(found, "ellipsoid").pose.position.x - NEAR_ZERO.x()) < 1e-9;
  });
  EXPECT_GT(named(shown, "ellipsoid").color.g, named(shown, "ellipsoid").color.r) << "not green near the middle";
  EXPECT_GT(named(shown, "ellipsoid").scale.x, 0.0);
  EXPECT_EQ("", textOf(shown, "reason"));
  const auto rho = inverseKinematics(orthoglidePrototype(), NEAR_ZERO);
  const auto slider = std::find_if(shown.begin(), shown.end(), [](const Marker& marker) {
    return marker.ns == "travel" && marker.type == Marker::SPHERE;
  });
  ASSERT_NE(shown.end(), slider);
  EXPECT_NEAR((*rho)[0] - 0.31058, slider->pose.position.x, 1e-9);
  EXPECT_NEAR(0.0, slider->pose.position.y, 1e-9);
  EXPECT_EQ(6, std::count_if(shown.begin(), shown.end(), [](const Marker& marker) { return marker.ns == "travel"; }));
}

TEST_F(Mechanism, stopsAtTheBorderTurnsRedAndSaysWhy)
{
  publishPose(NEAR_ZERO);
  gapOnceAt(NEAR_ZERO);
  drag("tool", Eigen::Vector3d(2.0, NEAR_ZERO.y(), NEAR_ZERO.z()));
  const auto shown =
      markers("tool_markers", [](const std::vector<Marker>& found) { return !textOf(found, "reason").empty(); });
  EXPECT_GT(named(shown, "ellipsoid").color.r, 2.0F * named(shown, "ellipsoid").color.g);
  EXPECT_NE(std::string::npos, textOf(shown, "reason").find("parallel singularity")) << textOf(shown, "reason");
  const auto state = receive<visualization_msgs::InteractiveMarkerInit>(NODE + "/interactive_markers/update_full");
  const auto tool = std::find_if(state->markers.begin(), state->markers.end(),
                                 [](const auto& marker) { return marker.name == "tool"; });
  ASSERT_NE(state->markers.end(), tool);
  const Eigen::Vector3d border(tool->pose.position.x, tool->pose.position.y, tool->pose.position.z);
  EXPECT_GT(border.x(), NEAR_ZERO.x());
  EXPECT_LT(border.x(), 0.32);
  EXPECT_LE((border - NEAR_ZERO).tail<2>().norm(), 1e-9) << "not on the way";
  const Machine machine = orthoglidePrototype();
  const auto before = configurationAt(machine, Eigen::Vector3d(border - 1e-9 * Eigen::Vector3d::UnitX()));
  const auto beyond = configurationAt(machine, Eigen::Vector3d(border + 1e-9 * Eigen::Vector3d::UnitX()));
  ASSERT_TRUE(before && beyond);
  EXPECT_TRUE(before->det_a.certainlyPositive()) << "it stops too late";
  EXPECT_TRUE(beyond->det_a.certainlyNegative()) << "it stops too early";
}

TEST_F(Mechanism, saysWhichBoundDoesNotHold)
{
  const Eigen::Vector3d stretched(0.14, 0.14, 0.14);
  ASSERT_TRUE(inverseKinematics(orthoglidePrototype(), stretched));
  drag("tool", stretched);
  const auto shown = markers("tool_markers", [&](const std::vector<Marker>& found) {
    return std::abs(named(found, "ellipsoid").pose.position.x - stretched.x()) < 1e-9;
  });
  EXPECT_NE(std::string::npos, textOf(shown, "reason").find("psi")) << textOf(shown, "reason");
}

TEST_F(Mechanism, hasABoxWhoseVerdictColorsIt)
{
  const auto boxOf = [](const std::vector<Marker>& found) { return named(found, "box"); };
  drag("box", Eigen::Vector3d(0.02, 0.02, 0.02));
  const auto small =
      markers("box_markers", [&](const auto& found) { return std::abs(boxOf(found).pose.position.x - 0.02) < 1e-9; });
  EXPECT_GT(boxOf(small).color.g, boxOf(small).color.r) << textOf(small, "verdict");
  EXPECT_NE(std::string::npos, textOf(small, "verdict").find("inside"));
  drag("box_x1", Eigen::Vector3d(0.3, 0.0, 0.0));
  const auto large = markers("box_markers", [&](const auto& found) { return boxOf(found).scale.x > 0.2; });
  EXPECT_GT(boxOf(large).color.r, boxOf(large).color.g) << textOf(large, "verdict");
  EXPECT_NE(std::string::npos, textOf(large, "verdict").find("outside"));
  EXPECT_GT(named(large, "bad_point").scale.x, 0.0);
}

TEST_F(Mechanism, growsTheBoxToTheLargestAtItsCenter)
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

TEST_F(Mechanism, ignoresWhatMakesNoSense)
{
  publishPose(NEAR_ZERO);
  gapOnceAt(NEAR_ZERO);
  publishPose(Eigen::Vector3d::Constant(std::nan("")));
  sensor_msgs::JointState rails;
  rails.name = { "elbow" };
  rails.position = { 1.0 };
  rails_.publish(rails);
  publishPose(2.0 * NEAR_ZERO);
  EXPECT_LE(gapOnceAt(2.0 * NEAR_ZERO), 1e-9) << "the node does not follow any more";
}
}  // namespace test
}  // namespace pkm_workspace
