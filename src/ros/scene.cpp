// SPDX-License-Identifier: BSD-3-Clause
#include "scene.h"

#include <algorithm>
#include <array>
#include <sstream>
#include <utility>

#include "pkm_workspace/interval/decimal.h"
#include "pkm_workspace/ros/conversions.h"
#include "shell.h"

namespace pkm_workspace
{
namespace
{
using visualization_msgs::Marker;

constexpr Color TEXT = { 0.1F, 0.1F, 0.1F, 1.0F };
constexpr Color INSIDE = { 0.15F, 0.85F, 0.30F, 0.20F };
constexpr Color BOUNDARY = { 1.0F, 0.70F, 0.0F, 0.14F };
constexpr std::int64_t MOST_BOXES = 20000;

/// All that have one of these states. Flat ones (their set does not change along the rails, and the region lies in
/// their plane) get a little thickness, just below it.
std::vector<Box> boxesOf(const BoxTree& tree, const std::vector<CellState>& states, double unit, double ceiling)
{
  const Box& whole = tree.bisection().root();
  const Eigen::Vector3d thickness = unit * ((whole.upper - whole.lower).array() == 0.0).cast<double>().matrix();
  const double lowered = thickness.z() > 0.0 ? std::min(0.0, ceiling - whole.upper.z()) : 0.0;
  const Eigen::Vector3d shift(0.0, 0.0, lowered);
  std::vector<Box> found;
  for (const CellState state : states)
    for (const std::vector<Box>& boxes : tree.boxes(state))
      for (const Box& box : boxes)
        if (box.upper.z() + lowered <= ceiling)
          found.push_back({ box.lower + shift - 2.5 * thickness, box.upper + shift - 1.5 * thickness });
  return found;
}

/// Two triangles that are seen from both sides.
void addPatch(const Patch& patch, std::vector<geometry_msgs::Point>& points)
{
  const int u = (patch.axis + 1) % 3;
  std::array<Eigen::Vector3d, 4> corners{ patch.box.lower, patch.box.lower, patch.box.upper, patch.box.upper };
  corners[1][u] = patch.box.upper[u];
  corners[3][u] = patch.box.lower[u];
  if (!patch.is_upper)
    std::swap(corners[1], corners[3]);
  for (const std::size_t k : { 0U, 1U, 2U, 0U, 2U, 3U })
    points.push_back(toMessage(corners[k]));
}

/// By colours of its own: rviz then leaves its lamp out, which would make most faces dark.
void addShell(const std::string& ns, const Color& color, const std::vector<Box>& boxes, const std::vector<Box>& others,
              Scene& scene)
{
  constexpr float SHADES[] = { 0.92F, 0.84F, 1.0F };
  if (ns.empty() || boxes.empty())
    return;
  Marker& surface = scene.add(ns, Marker::TRIANGLE_LIST, color);
  for (const Patch& patch : shellOf(boxes, others))
  {
    addPatch(patch, surface.points);
    const float shade = SHADES[patch.axis];
    surface.colors.resize(surface.points.size(),
                          toMessage(Color{ shade * color.r, shade * color.g, shade * color.b, color.a }));
  }
}
}  // namespace

std_msgs::ColorRGBA toMessage(const Color& color)
{
  std_msgs::ColorRGBA message;
  message.r = color.r;
  message.g = color.g;
  message.b = color.b;
  message.a = color.a;
  return message;
}

Scene::Scene(const std_msgs::Header& header, double unit, const std::string& holds_for) : unit_(unit)
{
  Marker clear;
  clear.header = header;
  // the newest transform there is: markers are latched, and may be older than all that tf remembers
  clear.header.stamp = ros::Time();
  clear.action = Marker::DELETEALL;
  clear.pose.orientation.w = 1.0;
  clear.text = holds_for;
  array_.markers.push_back(clear);
}

Marker& Scene::add(const std::string& ns, int type, const Color& color)
{
  Marker marker = array_.markers.front();
  marker.action = Marker::ADD;
  marker.text.clear();
  marker.ns = ns;
  marker.id = ids_[ns]++;
  marker.type = type;
  marker.frame_locked = true;
  marker.color = toMessage(color);
  marker.scale.x = marker.scale.y = marker.scale.z = 1.0;
  array_.markers.push_back(marker);
  return array_.markers.back();
}

void Scene::addText(const std::string& ns, const Eigen::Vector3d& place, const std::string& text, double size)
{
  // rviz puts 0.01 m between lines, whatever the height of their letters
  constexpr double SMALL = 0.008;
  const double height = 60.0 * size * unit_;
  const auto lines = std::count(text.begin(), text.end(), '\n') + 1;
  if (lines > 1 && height < SMALL)
  {
    std::istringstream rest(text);
    double above = 0.6 * height * static_cast<double>(lines - 1);
    for (std::string line; std::getline(rest, line); above -= 1.2 * height)
      addText(ns, place + above * Eigen::Vector3d::UnitZ(), line, size);
    return;
  }
  Marker& marker = add(ns, Marker::TEXT_VIEW_FACING, TEXT);
  marker.pose.position = toMessage(place);
  marker.scale.z = height;
  marker.text = text;
}

void addPaving(const BoxTree& tree, const std::string& inside, const std::string& undecided, Scene& scene,
               double ceiling)
{
  const BoxTree coarse = tree.coarsened(MOST_BOXES);
  const std::vector<Box> good = boxesOf(coarse, { CellState::INSIDE }, scene.unit(), ceiling);
  const std::vector<Box> open = boxesOf(coarse, { CellState::BOUNDARY, CellState::PENDING }, scene.unit(), ceiling);
  const float layers = tree.bisection().dimension() < 3 ? 2.2F : 1.0F;  // of a solid four are seen through each other
  addShell(inside, { INSIDE.r, INSIDE.g, INSIDE.b, layers * INSIDE.a }, good, {}, scene);
  addShell(undecided, { BOUNDARY.r, BOUNDARY.g, BOUNDARY.b, layers * BOUNDARY.a }, open, good, scene);
}

std::string digits(double value, std::string (*rounded)(double, int))
{
  constexpr std::size_t SHORT = 6;
  constexpr int FEWER = 5;  // than the nine significant ones of decimalsFor()
  std::string text = exact(value);
  if (text.size() <= SHORT)
    return text;
  text = rounded(value, std::max(0, decimalsFor(value, value) - FEWER));
  if (text.find('.') != std::string::npos)
    text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.')
    text.pop_back();
  return text;
}
}  // namespace pkm_workspace
