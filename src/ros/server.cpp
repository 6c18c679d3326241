// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/ros/server.h"

#include <ros/callback_queue.h>
#include <ros/init.h>

namespace pkm_workspace
{
Server::Server(const ros::NodeHandle& node, const ros::NodeHandle& private_node, const Loaded& loaded,
               const std::optional<LargestRegion>& region)
  : context_(node, private_node, loaded)
  , tool_(context_.parameters.publish_joint_states ? std::make_unique<Tool>(context_) : nullptr)
  , interaction_(context_, tool_.get())
  , below_(context_, interaction_)
  , regions_(context_, tool_.get(), interaction_)
  , pavings_(context_, below_)
  , singularities_(context_)
  , conditioning_(context_)
  , guarantee_(context_)
  , placement_(context_)
  , comparisons_(context_)
  , planning_(context_)
  , criterion_(context_,
               [this] {
                 interaction_.refresh();
                 regions_.computeOwn();
               })
  , diagnostics_(context_)
{
  if (region)
    regions_.adopt(*region);
  else
    regions_.computeOwn();
}

Server::~Server()
{
  context_.stop();
}

bool Server::run()
{
  context_.start();
  // ros::ok() turns false only after the services have ended, which wait for the computation that is to be stopped here
  while (!ros::isShuttingDown() && !ended_)
    ros::getGlobalCallbackQueue()->callAvailable(ros::WallDuration(0.05));
  context_.stop();
  return !regions_.hasFailed();
}
}  // namespace pkm_workspace
