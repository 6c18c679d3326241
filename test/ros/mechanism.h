// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <geometry_msgs/PoseStamped.h>
#include <pkm_workspace/SetCriterion.h>
#include <sensor_msgs/JointState.h>
#include <tf2_ros/transform_listener.h>
#include <visualization_msgs/InteractiveMarkerFeedback.h>
#include <visualization_msgs/InteractiveMarkerInit.h>
#include <visualization_msgs/MarkerArray.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <functional>

#include "node_client.h"
#include "pkm_workspace/machine/machine.h"

namespace pkm_workspace
{
namespace test
{
using visualization_msgs::InteractiveMarkerFeedback;
using visualization_msgs::Marker;
using visualization_msgs::MarkerArray;

/// Moves the model in every way that there is, and sees where it goes.
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

  void publishRails(const Machine& machine, const Eigen::Vector3d& rho)
  {
    sensor_msgs::JointState rails;
    for (const int leg : { 2, 0, 1 })
    {
      rails.name.push_back(machine.leg(leg).joint);
      rails.position.push_back(rho[leg]);
    }
    rails_.publish(rails);
  }

  static void setAspect(std::uint8_t aspect)
  {
    SetCriterion::Request request;
    request.criterion.aspect = aspect;
    const auto response = call<SetCriterion>("set_criterion", request);
    EXPECT_EQ(ErrorCode::SUCCESS, response.error_code) << response.message;
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

inline std::string textOf(const std::vector<Marker>& markers, const std::string& ns)
{
  for (const Marker& marker : markers)
    if (marker.ns == ns)
      return marker.text;
  return "";
}

inline bool hasText(const std::vector<Marker>& markers, const std::string& text)
{
  return std::any_of(markers.begin(), markers.end(),
                     [&text](const Marker& marker) { return marker.text.find(text) != std::string::npos; });
}

/// What rviz draws of a handle, as its interactive markers stand now.
inline visualization_msgs::InteractiveMarker handle(const std::string& name)
{
  const auto state = receive<visualization_msgs::InteractiveMarkerInit>(NODE + "/interactive_markers/update_full");
  const auto found = std::find_if(state->markers.begin(), state->markers.end(),
                                  [&name](const auto& marker) { return marker.name == name; });
  EXPECT_NE(state->markers.end(), found) << "there is no handle " << name;
  return found == state->markers.end() ? visualization_msgs::InteractiveMarker() : *found;
}

inline Eigen::Vector3d placeOf(const visualization_msgs::InteractiveMarker& marker)
{
  return { marker.pose.position.x, marker.pose.position.y, marker.pose.position.z };
}

inline Marker named(const std::vector<Marker>& markers, const std::string& ns)
{
  for (const Marker& marker : markers)
    if (marker.ns == ns)
      return marker;
  return Marker();
}

const Eigen::Vector3d NEAR_ZERO(0.02, -0.015, 0.01);
}  // namespace test
}  // namespace pkm_workspace
