// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/ros/hypotheses_panel.h"

#include <visualization_msgs/MarkerArray.h>

#include <algorithm>

#include "scene.h"

namespace pkm_workspace
{
namespace
{
constexpr double SIZE = 0.75;         ///< of the letters
constexpr double ROW = 64.0;          ///< from one line of the legend to the next
constexpr double SWATCH_SIZE = 3.0;   ///< of the hyphens that show a colour
constexpr double SWATCH_RISE = 20.0;  ///< to the middle of the words, as a hyphen is below the middle of its line

/// rviz turns nothing but texts towards whoever looks: a colour is shown by a hyphen on either side of its words, in
/// large letters, with blanks between them that are as wide as a capital letter.
std::string swatchesAround(std::size_t letters)
{
  return '-' + std::string(letters / 4 + 1, ' ') + '-';
}

void addRow(const LegendRow& row, std::size_t letters, const Eigen::Vector3d& place, Scene& scene)
{
  const Eigen::Vector3d raised = place + SWATCH_RISE * scene.unit() * Eigen::Vector3d::UnitZ();
  scene.addText("legend", raised, swatchesAround(letters), SWATCH_SIZE, row.color);
  scene.addText("legend", place, row.text, SIZE);
}
}  // namespace

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

void HypothesesPanel::tell(const std::string& picture, const std::string& caption, const Legend& legend)
{
  const std::lock_guard<std::mutex> lock(mutex_);
  told_[picture] = { caption, legend };
  show();
}

/// Each row once, whatever pictures it is of.
Legend HypothesesPanel::legend() const
{
  Legend all;
  for (const auto& [picture, told] : told_)
    for (const LegendRow& row : told.legend)
      if (std::none_of(all.begin(), all.end(), [&row](const LegendRow& other) { return other.text == row.text; }))
        all.push_back(row);
  return all;
}

void HypothesesPanel::show() const
{
  if (told_.empty())
    return;
  std::string text;
  std::string machine;
  for (const auto& [picture, told] : told_)
  {
    const std::size_t end = told.caption.find('\n');
    if (told.caption.substr(0, end) != machine)
      text += (machine = told.caption.substr(0, end)) + '\n';
    text += picture + ": " + told.caption.substr(end + 1) + '\n';
  }
  text.pop_back();
  std_msgs::Header header;
  header.frame_id = frame_;
  Scene scene(header, unit_, text);
  scene.addText("hypotheses", place_, text, SIZE);
  const Legend rows = legend();
  std::size_t letters = 0;
  for (const LegendRow& row : rows)
    letters = std::max(letters, row.text.size());
  Eigen::Vector3d place = place_;
  place.z() -= 0.5 * scene.lineHeight(SIZE) * static_cast<double>(std::count(text.begin(), text.end(), '\n') + 1);
  for (const LegendRow& row : rows)
  {
    place.z() -= unit_ * ROW;
    addRow(row, letters, place, scene);
  }
  publisher_.publish(scene.array());
}
}  // namespace pkm_workspace
