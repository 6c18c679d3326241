// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <std_msgs/ColorRGBA.h>
#include <visualization_msgs/MarkerArray.h>

#include <Eigen/Core>
#include <limits>
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
  /// @param holds_for its text: what the picture holds for
  Scene(const std_msgs::Header& header, double unit, const std::string& holds_for = "");

  /// What widths of lines and letters are multiples of [m].
  double unit() const { return unit_; }
  visualization_msgs::Marker& add(const std::string& ns, int type, const Color& color);
  /// @param size of the letters, 1 for a label
  void addText(const std::string& ns, const Eigen::Vector3d& place, const std::string& text, double size = 1.0);

  const visualization_msgs::MarkerArray& array() const { return array_; }

private:
  double unit_;
  std::map<std::string, int> ids_;
  visualization_msgs::MarkerArray array_;
};

/// Adds the surface of a paving's boxes, as coarsely as it takes for about 20000 boxes: a list of triangles for what is
/// inside, one for what is undecided.
/// @param inside, undecided namespaces; empty: these boxes are left out
/// @param ceiling boxes that reach above it are left out [m]; flat ones that do not change along z are lowered to it
void addPaving(const BoxTree& tree, const std::string& inside, const std::string& undecided, Scene& scene,
               double ceiling = std::numeric_limits<double>::infinity());

/// A bound as people write it, 0.3: exactly where that is short, else in a few digits, rounded to the side on which it
/// holds.
std::string digits(double value, std::string (*rounded)(double, int));
}  // namespace pkm_workspace
