// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/node_handle.h>

#include <Eigen/Core>
#include <map>
#include <mutex>
#include <string>

#include "pkm_workspace/ros/legend.h"

namespace pkm_workspace
{
/// One text in rviz for what its pictures hold for, ~hypotheses_markers, latched: below the machine, so that it covers
/// nothing, and the display of its own can be switched off; below it the legend of their colours. Thread-safe.
class HypothesesPanel
{
public:
  /// Advertises. @param frame of the root link @param unit a thousandth of the machine's size [m]
  HypothesesPanel(ros::NodeHandle private_node, const std::string& frame, double unit);

  /// @param place in the frame of the root link [m]
  void moveTo(const Eigen::Vector3d& place);
  /// @param picture "region", "set"
  /// @param caption what it holds for now: a line about the machine, then one about the criterion
  /// @param legend what its colours stand for
  void tell(const std::string& picture, const std::string& caption, const Legend& legend = {});

private:
  void show() const;

  std::string frame_;
  double unit_;
  ros::Publisher publisher_;
  std::mutex mutex_;
  Eigen::Vector3d place_ = Eigen::Vector3d::Zero();
  struct Told
  {
    std::string caption;
    Legend legend;
  };
  Legend legend() const;
  std::map<std::string, Told> told_;
};
}  // namespace pkm_workspace
