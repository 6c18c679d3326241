// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pkm_workspace/ApproximateWorkspaceAction.h>
#include <pkm_workspace/CheckGcode.h>
#include <pkm_workspace/CheckPath.h>
#include <pkm_workspace/CheckRegion.h>
#include <pkm_workspace/ComputeLargestRegion.h>
#include <pkm_workspace/ComputeWorkspace.h>
#include <pkm_workspace/ErrorCode.h>
#include <pkm_workspace/EvaluatePoint.h>
#include <pkm_workspace/ExportLimits.h>
#include <pkm_workspace/FindLargestRegionAction.h>
#include <pkm_workspace/GetRegion.h>
#include <pkm_workspace/PlacePath.h>
#include <pkm_workspace/SetCriterion.h>
#include <ros/node_handle.h>
#include <ros/service.h>

#include <functional>
#include <map>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "pkm_workspace/ros/client_criterion.h"
#include "pkm_workspace/ros/client_fields.h"
#include "pkm_workspace/ros/client_goal.h"

namespace pkm_workspace
{
/// The node has refused a request.
struct Refused : std::runtime_error
{
  Refused(std::int32_t code, const std::string& message) : std::runtime_error(message), error_code(code) {}
  std::int32_t error_code;  ///< a constant of ErrorCode.msg
};

/// A small client of pkm_workspace_node, for planners in C++17. Header only: needs messages, roscpp and actionlib, not
/// the library.
///
///     pkm_workspace::Client machine;  // of /pkm_workspace_node
///     const auto region = machine.largestRegion(with::shape("cube"), with::psi_min(0.4), with::accuracy(1e-4));
///     // region.size <= largest edge <= region.size_upper_bound
///     if (machine.checkBox({ 0.1, 0.1, 0.1 }, { 0.2, 0.2, 0.3 }, with::frame("table")).verdict != machine.INSIDE)
///       ...
///     const auto answer = machine.checkPath({ line({ 0, 0, 0 }, { 0.2, 0, 0 }),
///                                             arc({ 0.2, 0, 0 }, { 0.3, 0.1, 0 }, { 0.2, 0.2, 0 }) });
///     if (answer.verdict == machine.OUTSIDE)
///       ROS_WARN_STREAM(answer.message);  // where along the path, and which limit binds
///
/// Lengths are metres, angles radians; fields by name: client_fields.h. Persistent connections: make one client and
/// keep it; one for each thread. Every call @throws Refused where the node refuses, std::runtime_error where it does
/// not answer
class Client
{
public:
  static constexpr std::uint8_t INSIDE = CheckPath::Response::INSIDE;
  static constexpr std::uint8_t OUTSIDE = CheckPath::Response::OUTSIDE;
  static constexpr std::uint8_t UNDECIDED = CheckPath::Response::UNDECIDED;

  /// @param patience for each service and action when it is first called [s]
  explicit Client(std::string node = "/pkm_workspace_node", double patience = 10.0)
    : node_(std::move(node)), patience_(patience)
  {
    actions_.setCallbackQueue(&queue_);
  }

  /// The largest region; without fields, the node's own.
  template <class... Fields>
  Region largestRegion(const Fields&... fields)
  {
    ComputeLargestRegion service;
    fill(service.request.query, fields...);
    return call("compute_largest_region", service).region;
  }
  Region largestRegion(const RegionRequest& query)
  {
    return largestRegion([&query](RegionRequest& request) { request = query; });
  }

  /// The last region that was computed, at once.
  Region lastRegion()
  {
    GetRegion service;
    return call("get_region", service).region;
  }

  /// The set of all good points by boxes.
  template <class... Fields>
  Workspace workspace(const Fields&... fields)
  {
    ComputeWorkspace service;
    fill(service.request.query, fields...);
    return call("compute_workspace", service).workspace;
  }

  /// Begins to look for the largest region. @param feedback is called as the bracket closes; may be empty
  template <class... Fields>
  Goal<FindLargestRegionAction> findRegion(const std::function<void(const FindLargestRegionFeedback&)>& feedback,
                                           const Fields&... fields)
  {
    FindLargestRegionGoal goal;
    fill(goal.query, fields...);
    return { connect(finding_, "find_largest_region"), goal, feedback };
  }

  /// Begins to pave.
  template <class... Fields>
  Goal<ApproximateWorkspaceAction> approximateWorkspace(
      const std::function<void(const ApproximateWorkspaceFeedback&)>& feedback, const Fields&... fields)
  {
    ApproximateWorkspaceGoal goal;
    fill(goal.query, fields...);
    return { connect(paving_, "approximate_workspace"), goal, feedback };
  }

  /// Changes what the node asks for from now on. @return what is in effect
  template <class... Fields>
  Hypotheses setCriterion(const Fields&... fields)
  {
    SetCriterion service;
    fill(service.request, fields...);
    return call("set_criterion", service).hypotheses;
  }

  /// Whether all of a box is good. @param sides along the axes of the frame
  template <class... Fields>
  CheckRegion::Response checkBox(const Triple& center, const Triple& sides, const Fields&... fields)
  {
    shape_msgs::SolidPrimitive solid;
    solid.type = shape_msgs::SolidPrimitive::BOX;
    solid.dimensions.assign(sides.begin(), sides.end());
    return checkSolid(center, solid, fields...);
  }

  /// The same for any SolidPrimitive but a cone.
  template <class... Fields>
  CheckRegion::Response checkSolid(const Triple& center, const shape_msgs::SolidPrimitive& solid,
                                   const Fields&... fields)
  {
    CheckRegion service;
    service.request.solid = solid;
    service.request.center = messageOf(center);
    fill(service.request, fields...);
    return call("check_region", service);
  }

  /// The same for the convex hull of points, as seen from its center.
  template <class... Fields>
  CheckRegion::Response checkPolytope(const Triple& center, const std::vector<Triple>& vertices,
                                      const Fields&... fields)
  {
    return checkSolid(center, {}, with::vertices(vertices), fields...);
  }

  /// Whether all of the way through these points is good.
  template <class... Fields>
  CheckPath::Response checkLine(const std::vector<Triple>& points, const Fields&... fields)
  {
    std::vector<ToolSegment> segments;
    for (std::size_t k = 0; k + 1 < points.size(); ++k)
      segments.push_back(line(points[k], points[k + 1]));
    return checkPath(segments, fields...);
  }

  /// The same for lines, arcs and helices: line(), arc(), turn().
  template <class... Fields>
  CheckPath::Response checkPath(const std::vector<ToolSegment>& segments, const Fields&... fields)
  {
    CheckPath service;
    service.request.segments = segments;
    fill(service.request, fields...);
    return call("check_path", service);
  }

  /// Whether all of a job in G-code is good. @param gcode its text
  template <class... Fields>
  CheckGcode::Response checkGcode(const std::string& gcode, const Fields&... fields)
  {
    CheckGcode service;
    service.request.gcode = gcode;
    fill(service.request, fields...);
    return call("check_gcode", service);
  }

  /// The limits of a region that is proved, in the words of a firmware.
  template <class... Fields>
  ExportLimits::Response exportLimits(const std::string& format, const Triple& center,
                                      const shape_msgs::SolidPrimitive& solid, const Fields&... fields)
  {
    ExportLimits service;
    service.request.format = format;
    service.request.solid = solid;
    service.request.center = messageOf(center);
    fill(service.request, fields...);
    return call("export_limits", service);
  }

  /// Where to put a path, with the largest margin.
  template <class... Fields>
  PlacePath::Response placePath(const std::vector<ToolSegment>& segments, const Fields&... fields)
  {
    PlacePath service;
    service.request.segments = segments;
    fill(service.request, fields...);
    return call("place_path", service);
  }

  /// How the machine stands at a point.
  template <class... Fields>
  EvaluatePoint::Response evaluate(const Triple& place, const Fields&... fields)
  {
    EvaluatePoint service;
    service.request.point = messageOf(place);
    fill(service.request, fields...);
    return call("evaluate_point", service);
  }

  /// Calls a service of the node by name, with the request that it holds.
  template <class Service>
  typename Service::Response call(const std::string& name, Service& service)
  {
    ros::ServiceClient& client = clients_[name];
    if (!client.isValid())
    {
      if (!ros::service::waitForService(node_ + "/" + name, ros::Duration(patience_)))
        throw std::runtime_error(node_ + "/" + name + " is not offered");
      client = handle_.serviceClient<Service>(node_ + "/" + name, true);
    }
    if (!client.call(service))
    {
      client.shutdown();  // the next call connects again
      throw std::runtime_error(node_ + "/" + name + " did not answer");
    }
    if (service.response.error_code != ErrorCode::SUCCESS)
      throw Refused(service.response.error_code, service.response.message);
    return service.response;
  }

private:
  template <class Request, class... Fields>
  static void fill(Request& request, const Fields&... fields)
  {
    (fields(request), ...);
  }

  /// Connects to each action once, with a thread for what it tells.
  template <class Action>
  std::shared_ptr<actionlib::ActionClient<Action>> connect(std::shared_ptr<actionlib::ActionClient<Action>>& client,
                                                           const std::string& name)
  {
    if (!client)
    {
      client = std::make_shared<actionlib::ActionClient<Action>>(actions_, node_ + "/" + name, &queue_);
      spinner_.start();
    }
    if (!client->waitForActionServerToStart(ros::Duration(patience_)))
      throw std::runtime_error(node_ + "/" + name + " is not offered");
    return client;
  }

  ros::NodeHandle handle_;
  ros::NodeHandle actions_;
  std::string node_;
  double patience_;
  std::map<std::string, ros::ServiceClient> clients_;
  ros::CallbackQueue queue_;
  std::shared_ptr<actionlib::ActionClient<FindLargestRegionAction>> finding_;
  std::shared_ptr<actionlib::ActionClient<ApproximateWorkspaceAction>> paving_;
  ros::AsyncSpinner spinner_{ 1, &queue_ };
};
}  // namespace pkm_workspace
