// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>
#include <pkm_workspace/ComputeLargestRegion.h>
#include <pkm_workspace/ErrorCode.h>
#include <pkm_workspace/GetRegion.h>
#include <ros/ros.h>
#include <ros/topic.h>

#include <functional>
#include <string>

namespace pkm_workspace
{
namespace test
{
/// How long a test waits for the node before it fails; nothing is expected to take anywhere near as long.
const ros::Duration PATIENCE(60.0);
const std::string NODE = "/pkm_workspace_node";

/// Calls a service of the node, once it is there. Over a persistent connection: without one, roscpp drops an answer now
/// and then (ros_comm issue 1976, README.md).
template <class Service>
typename Service::Response call(const std::string& name, const typename Service::Request& request)
{
  typename Service::Response response;
  EXPECT_TRUE(ros::service::waitForService(NODE + "/" + name, PATIENCE)) << name << " is not offered";
  ros::NodeHandle node;
  auto client = node.serviceClient<Service>(NODE + "/" + name, true);
  EXPECT_TRUE(client.call(const_cast<typename Service::Request&>(request), response)) << name << " did not answer";
  return response;
}

inline ComputeLargestRegion::Response compute(const RegionRequest& query)
{
  ComputeLargestRegion::Request request;
  request.query = query;
  return call<ComputeLargestRegion>("compute_largest_region", request);
}

/// The next message on a topic of the node; on a latched one, the last that there was.
template <class Message>
boost::shared_ptr<const Message> receive(const std::string& name)
{
  const auto message = ros::topic::waitForMessage<Message>(name, PATIENCE);
  EXPECT_TRUE(message) << "nothing came on " << name;
  return message ? message : boost::make_shared<const Message>();
}

/// Waits for a message that fits. @return the last one that came
template <class Message>
boost::shared_ptr<const Message> await(const std::string& topic, const std::function<bool(const Message&)>& fits)
{
  const ros::Time deadline = ros::Time::now() + PATIENCE;
  auto message = receive<Message>(topic);
  while (!fits(*message) && ros::Time::now() < deadline)
    message = receive<Message>(topic);
  EXPECT_TRUE(fits(*message)) << *message;
  return message;
}
}  // namespace test
}  // namespace pkm_workspace
