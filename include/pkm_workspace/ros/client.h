// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <geometry_msgs/Point.h>
#include <pkm_workspace/CheckPath.h>
#include <pkm_workspace/CheckRegion.h>
#include <pkm_workspace/ComputeLargestRegion.h>
#include <pkm_workspace/ComputeWorkspace.h>
#include <pkm_workspace/ErrorCode.h>
#include <pkm_workspace/EvaluatePoint.h>
#include <pkm_workspace/GetRegion.h>
#include <ros/node_handle.h>
#include <ros/service.h>

#include <map>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace pkm_workspace
{
/// The node has refused a request.
struct Refused : std::runtime_error
{
  Refused(std::int32_t code, const std::string& message) : std::runtime_error(message), error_code(code) {}
  std::int32_t error_code;  ///< a constant of ErrorCode.msg
};

/// A small client of pkm_workspace_node, for planners in C++. Header only: needs messages and roscpp, not the library.
///
///     pkm_workspace::Client machine;  // of /pkm_workspace_node
///     pkm_workspace::RegionRequest request;
///     request.shape = request.CUBE;
///     const auto region = machine.largestRegion(request);  // region.size <= largest edge <= region.size_upper_bound
///     if (machine.checkBox({ 0.1, 0.1, 0.1 }, { 0.2, 0.2, 0.3 }).verdict !=
///     pkm_workspace::CheckRegion::Response::INSIDE)
///       ...
///     const auto answer = machine.checkLine({ { 0.0, 0.0, 0.0 }, { 0.2, 0.0, 0.0 } });
///     if (answer.verdict == pkm_workspace::CheckPath::Response::OUTSIDE)
///       ROS_WARN_STREAM(answer.message);  // where along the path, and which limit binds
///
/// Lengths are metres. Persistent connections: make one client and keep it; one for each thread. Every call
/// @throws Refused where the node refuses, std::runtime_error where it does not answer
class Client
{
public:
  using Triple = std::vector<double>;  ///< x, y, z

  /// @param patience for each service when it is first called [s]
  explicit Client(std::string node = "/pkm_workspace_node", double patience = 10.0)
    : node_(std::move(node)), patience_(patience)
  {}

  /// The largest region. @param query left at its defaults: the node's own
  Region largestRegion(const RegionRequest& query = {})
  {
    ComputeLargestRegion service;
    service.request.query = query;
    return call("compute_largest_region", service).region;
  }

  /// The last region that was computed, at once.
  Region lastRegion()
  {
    GetRegion service;
    return call("get_region", service).region;
  }

  /// The set of all good points by boxes.
  Workspace workspace(const PavingRequest& query = {})
  {
    ComputeWorkspace service;
    service.request.query = query;
    return call("compute_workspace", service).workspace;
  }

  /// Whether all of a box is good. @param sides along the axes of the frame @param frame empty: the root link's
  CheckRegion::Response checkBox(const Triple& center, const Triple& sides, const std::string& frame = "")
  {
    CheckRegion service;
    service.request.header.frame_id = frame;
    service.request.solid.type = shape_msgs::SolidPrimitive::BOX;
    service.request.solid.dimensions = sides;
    service.request.center = point(center);
    return call("check_region", service);
  }

  /// Whether all of the way through these points is good.
  CheckPath::Response checkLine(const std::vector<Triple>& points, const std::string& frame = "")
  {
    CheckPath service;
    service.request.header.frame_id = frame;
    for (std::size_t k = 0; k + 1 < points.size(); ++k)
    {
      ToolSegment segment;
      segment.kind = ToolSegment::LINE;
      segment.start = point(points[k]);
      segment.end = point(points[k + 1]);
      service.request.segments.push_back(segment);
    }
    return call("check_path", service);
  }

  /// How the machine stands at a point.
  EvaluatePoint::Response evaluate(const Triple& place, const std::string& frame = "")
  {
    EvaluatePoint service;
    service.request.header.frame_id = frame;
    service.request.point = point(place);
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
  static geometry_msgs::Point point(const Triple& triple)
  {
    geometry_msgs::Point message;
    message.x = triple.at(0);
    message.y = triple.at(1);
    message.z = triple.at(2);
    return message;
  }

  ros::NodeHandle handle_;
  std::string node_;
  double patience_;
  std::map<std::string, ros::ServiceClient> clients_;
};
}  // namespace pkm_workspace
