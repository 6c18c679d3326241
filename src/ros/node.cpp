// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/ros/node.h"

#include <ros/console.h>

#include "pkm_workspace/ros/criterion_message.h"
#include "pkm_workspace/ros/reply.h"

namespace pkm_workspace
{
namespace
{
ros::NodeHandle onQueue(ros::NodeHandle node, ros::CallbackQueue& queue)
{
  node.setCallbackQueue(&queue);
  return node;
}
}  // namespace

Node::Node(const ros::NodeHandle& node, const ros::NodeHandle& private_node)
  : node_(node)
  , private_node_(private_node)
  , server_(std::make_unique<Server>(node, private_node, load(private_node)))
  , service_(offer<Reload>(onQueue(private_node, queue_), health_, "reload",
                           [this](const Reload::Request&, Reload::Response& response) { reload(response); }))
  , thread_([this] {
    while (!stopped_)
      queue_.callOne(ros::WallDuration(0.05));
  })
{}

Node::~Node()
{
  stop();
}

void Node::stop()
{
  {
    const std::lock_guard<std::mutex> lock(mutex_);  // no wait begins between the two
    stopped_ = true;
  }
  changed_.notify_all();
  if (thread_.joinable())
    thread_.join();
}

bool Node::run()
{
  for (;;)
  {
    const bool worked = server_->run();
    std::unique_lock<std::mutex> lock(mutex_);
    if (ros::isShuttingDown() || !next_)
    {
      lock.unlock();
      stop();
      return worked;
    }
    server_.reset();  // the names of its services are free then
    server_ = std::make_unique<Server>(node_, private_node_, next_->loaded, next_->region);
    next_.reset();
    changed_.notify_all();
  }
}

void Node::reload(Reload::Response& response)
{
  const Loaded loaded = load(private_node_);
  RegionQuery query = loaded.query;
  query.budget.stop = &stopped_;
  const LargestRegion region = withRemedy(NODE_REMEDY, [&] { return findLargestRegion(loaded.urdf.machine, query); });
  replace({ loaded, region });
  const Machine& machine = loaded.urdf.machine;
  const Premises premises = premisesOf(machine, query.criterion);
  ROS_INFO_STREAM_NAMED("urdf", "robot_description was read again: machine '" << machine.name() << "', geometry "
                                                                              << machine.geometryHash());
  response.hypotheses = toMessage(premises, query.accuracy);
  response.message = "machine '" + machine.name() + "': " + region.message;
}

void Node::replace(Next next)
{
  std::unique_lock<std::mutex> lock(mutex_);
  next_.emplace(std::move(next));
  server_->end();
  changed_.wait(lock, [this] { return stopped_ || !next_; });
  if (next_)
    throw std::runtime_error("the node ends");
}
}  // namespace pkm_workspace
