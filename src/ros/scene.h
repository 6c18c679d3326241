// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <std_msgs/ColorRGBA.h>
#include <visualization_msgs/MarkerArray.h>

#include <Eigen/Core>
#include <map>
#include <string>

#include "pkm_workspace/machine/machine.h"
#include "pkm_workspace/ros/legend.h"

namespace pkm_workspace
{
constexpr Color TEXT = { 0.1F, 0.1F, 0.1F, 1.0F };

std_msgs::ColorRGBA toMessage(const Color& color);

/// Collects markers that share a header; ids count up in each namespace.
class Scene
{
public:
  /// Begins with a marker that clears what was there before. @param unit a thousandth of the machine's size [m]
  /// @param holds_for its text: what the picture holds for
  Scene(const std_msgs::Header& header, double unit, const std::string& holds_for = "");

  /// What widths of lines and letters are multiples of [m].
  double unit() const { return unit_; }
  visualization_msgs::Marker& add(const std::string& ns, int type, const Color& color);
  /// @param size of the letters, 1 for a label
  /// From one line of letters to the next, as rviz has them [m].
  double lineHeight(double size = 1.0) const;
  void addText(const std::string& ns, const Eigen::Vector3d& place, const std::string& text, double size = 1.0,
               const Color& color = TEXT);

  const visualization_msgs::MarkerArray& array() const { return array_; }

private:
  double unit_;
  std::map<std::string, int> ids_;
  visualization_msgs::MarkerArray array_;
};

/// What shows where a leg's joint is, with the tool at @p tool [m]: the slider, the tip of a crank, or of a strut of
/// variable length the end of one that points to the platform and is as long.
Eigen::Vector3d movedPoint(const Leg& leg, double joint, const Eigen::Vector3d& tool);

/// Adds the way of that point while the joint goes through these values, as a list of lines: one along a rail or strut,
/// an arc of some for a crank.
void addWay(const Leg& leg, double lower, double upper, const Eigen::Vector3d& tool,
            std::vector<geometry_msgs::Point>& lines);

/// A bound as people write it, 0.3: exactly where that is short, else in a few digits, rounded to the side on which it
/// holds.
std::string digits(double value, std::string (*rounded)(double, int));
}  // namespace pkm_workspace
