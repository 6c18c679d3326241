// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/ros/hypotheses_panel.h"

#include <visualization_msgs/MarkerArray.h>

#include "scene.h"

namespace pkm_workspace
{
HypothesesPanel::HypothesesPanel(ros::NodeHandle private_node, const std::string& frame, double unit)
  : frame_(frame)
  , unit_(unit)
  , publisher_(private_node.advertise<visualization_msgs::MarkerArray>("hypotheses_markers", 1, true))
{}

void HypothesesPanel::moveTo(const Eigen::Vector3d& place)
{
  const std::lock_guard<std::mutex> lock(mutex_);
  place_ = place;
  show();
}

void HypothesesPanel::tell(const std::string& picture, const std::string& caption)
{
  const std::lock_guard<std::mutex> lock(mutex_);
  captions_[picture] = caption;
  show();
}

void HypothesesPanel::show() const
{
  if (captions_.empty())
    return;
  std::string text;
  std::string machine;
  for (const auto& [picture, caption] : captions_)
  {
    const std::size_t end = caption.find('\n');
    if (caption.substr(0, end) != machine)
      text += (machine = caption.substr(0, end)) + '\n';
    text += picture + ": " + caption.substr(end + 1) + '\n';
  }
  text.pop_back();
  std_msgs::Header header;
  header.frame_id = frame_;
  Scene scene(header, unit_, text);
  scene.addText("hypotheses", place_, text, 0.75);
  publisher_.publish(scene.array());
}
}  // namespace pkm_workspace
