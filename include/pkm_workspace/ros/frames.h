// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pkm_workspace/CriterionRequest.h>
#include <tf2_ros/buffer.h>
#include <tf2_ros/transform_listener.h>

#include <Eigen/Geometry>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "pkm_workspace/dexterity/premises.h"

namespace pkm_workspace
{
/// A machine as it stands in a frame: what is asked for in that frame is computed for this machine.
struct FramedMachine
{
  std::string frame;                       ///< its name in tf
  std::shared_ptr<const Machine> machine;  ///< all numbers in that frame
  std::string geometry_hash;               ///< of the machine in the frame of its root link
  Pose root;                               ///< of its root link in that frame, as tf tells it

  /// What answers in that frame are proved of.
  Premises premises(const Criterion& criterion) const;
  /// The same criterion with its zones where they are in this frame.
  Criterion seen(Criterion criterion) const;
  /// From that frame to the root link's, in floating point.
  Eigen::Isometry3d toRoot() const;
};

/// The name of a frame as tf2 knows it: without leading slashes.
std::string bare(const std::string& name);

/// The frames that a request may be made in: all that tf knows, but for those that the machine itself moves.
/// Thread-safe.
class Frames
{
public:
  /// @param machine in the frame of its root link @param root the name of that frame in tf @param moved the names of
  /// the frames that the machine moves
  Frames(const Machine& machine, const std::string& root, const std::vector<std::string>& moved);

  /// The machine in the frame of its root link.
  const FramedMachine& root() const { return root_; }
  /// The machine in a frame, as it stands there now. Waits up to a second for a frame that is not known: a worker
  /// serves others meanwhile, of whom none may wait. So what a worker's callbacks share is looked at after this call.
  /// @param name empty: the root's @param request what it says of the machine counts in place of the machine's own
  /// @throws Refusal that names the frames there are, also for those that the machine moves; std::invalid_argument for
  /// what no machine has
  FramedMachine machineIn(const std::string& name, const CriterionRequest& request = CriterionRequest()) const;

  /// A point of a frame in the frame of the root link [m], by floating point. Does not wait.
  /// @throws Refusal that names the frames there are
  Eigen::Vector3d pointInRoot(const std::string& name, const Eigen::Vector3d& point) const;

private:
  Pose rootIn(const std::string& frame, bool patiently) const;
  /// The frame that the machine moves and this one hangs at, or is; empty where there is none.
  std::string moverOf(const std::string& frame) const;
  /// @throws Refusal for a frame that the machine moves
  void requireStill(const std::string& frame) const;
  /// All that a request may name, in order.
  std::string known() const;

  FramedMachine root_;
  std::set<std::string> moved_;
  tf2_ros::Buffer buffer_;
  tf2_ros::TransformListener listener_;
};
}  // namespace pkm_workspace
