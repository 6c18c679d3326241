// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <std_msgs/ColorRGBA.h>
#include <visualization_msgs/MarkerArray.h>

#include <Eigen/Core>
#include <map>
#include <string>

#include "pkm_workspace/machine/machine.h"
#include "pkm_workspace/paving/box_tree.h"

namespace pkm_workspace
{
struct Color
{
  float r, g, b, a;
};

std_msgs::ColorRGBA toMessage(const Color& color);

/// Collects markers that share a header; ids count up in each namespace.
class Scene
{
public:
  /// Begins with a marker that clears what was there before. @param unit a thousandth of the machine's size [m]
  Scene(const std_msgs::Header& header, double unit);

  /// What widths of lines and letters are multiples of [m].
  double unit() const { return unit_; }
  visualization_msgs::Marker& add(const std::string& ns, int type, const Color& color);
  void addText(const std::string& ns, const Eigen::Vector3d& place, const std::string& text);

  /// Adds what the picture holds for: in small letters, and with the marker that clears.
  void addCaption(const Eigen::Vector3d& place, const std::string& text);

  const visualization_msgs::MarkerArray& array() const { return array_; }

private:
  double unit_;
  std::map<std::string, int> ids_;
  visualization_msgs::MarkerArray array_;
};

/// Adds the boxes of a paving, as coarsely as it takes for about 20000 of them: more than that rviz does not draw
/// smoothly. One list for each size, because a list has one scale.
/// @param inside, undecided namespaces; empty: these boxes are left out
void addPaving(const BoxTree& tree, const std::string& inside, const std::string& undecided, Scene& scene);

/// A few digits of a bound, rounded to the side on which it holds, without zeros at the end.
std::string digits(double value, std::string (*rounded)(double, int));
}  // namespace pkm_workspace
