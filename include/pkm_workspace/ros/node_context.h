// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/node_handle.h>

#include <list>
#include <mutex>
#include <string>

#include "pkm_workspace/dexterity/unbounded.h"
#include "pkm_workspace/ros/frames.h"
#include "pkm_workspace/ros/health.h"
#include "pkm_workspace/ros/hypotheses_panel.h"
#include "pkm_workspace/ros/parameters.h"
#include "pkm_workspace/ros/worker.h"

namespace pkm_workspace
{
/// What can be done about a region of the node's own without a bounded answer.
const Remedy NODE_REMEDY{ "joint_limits", "a ~search_box" };

/// What the node is about: its parameters and its machine, which can be answered for.
struct Loaded
{
  Parameters parameters;
  std::string urdf_text;  ///< as robot_description had it
  UrdfMachine urdf;
  RegionQuery query;  ///< of the node's own region
};

/// Reads and validates all of it.
/// @throws std::invalid_argument for bad parameters or a bad URDF, std::runtime_error where arithmetic cannot be
/// trusted
Loaded load(const ros::NodeHandle& private_node);

/// What all parts of the node share.
///
/// The thread of private_node answers what can be answered at once, the worker computes what services ask for, the
/// decider gives verdicts, the modeller makes surfaces of sets, the painter markers: no request waits for a picture.
/// Goals of each action, and what is dragged, have workers of their own.
class NodeContext
{
public:
  NodeContext(const ros::NodeHandle& node, const ros::NodeHandle& private_node, const Loaded& loaded);

private:
  std::list<Worker> workers_;

public:
  ros::NodeHandle node;
  ros::NodeHandle private_node;
  ros::NodeHandle computing;  ///< the private one for services of the worker
  ros::NodeHandle deciding;   ///< and for those of the decider
  const Parameters parameters;
  const std::string urdf_text;  ///< as robot_description had it
  const UrdfMachine urdf;
  const Frames frames;
  HypothesesPanel panel;
  Health health;
  Worker& worker = addWorker();
  Worker& decider = addWorker();
  Worker& modeller = addWorker();
  Worker& painter = addWorker();

  const Machine& machine() const { return urdf.machine; }

  /// What the node computes by itself, and what requests without values get. Thread-safe, as the next.
  RegionQuery query() const;
  void setCriterion(const Criterion& criterion, double accuracy);

  /// One more; it starts and stops with the others. For constructors of what the node consists of.
  Worker& addWorker() { return workers_.emplace_back(); }
  void start();
  void stop();

private:
  mutable std::mutex mutex_;
  RegionQuery query_;
};
}  // namespace pkm_workspace
