// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/ros/server.h"

#include <ros/callback_queue.h>
#include <ros/init.h>

namespace pkm_workspace
{
Server::Server(const ros::NodeHandle& node, const ros::NodeHandle& private_node)
  : context_(node, private_node)
  , tool_(context_.parameters.publish_joint_states ? std::make_unique<Tool>(context_) : nullptr)
  , interaction_(context_, tool_.get())
  , regions_(context_, tool_.get())
  , pavings_(context_)
  , singularities_(context_)
  , conditioning_(context_)
  , comparisons_(context_)
  , planning_(context_)
  , criterion_(context_,
               [this] {
                 interaction_.refresh();
                 regions_.computeOwn();
               })
  , diagnostics_(context_)
{}

Server::~Server()
{
  context_.stop();
}

bool Server::run()
{
  regions_.computeOwn();
  context_.start();
  // ros::ok() turns false only after the services have ended, which wait for the computation that is to be stopped here
  while (!ros::isShuttingDown())
    ros::getGlobalCallbackQueue()->callAvailable(ros::WallDuration(0.05));
  context_.stop();
  return !regions_.hasFailed();
}
}  // namespace pkm_workspace
