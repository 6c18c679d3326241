// SPDX-License-Identifier: BSD-3-Clause
#include "scene.h"

#include <algorithm>

#include "pkm_workspace/interval/decimal.h"
#include "pkm_workspace/ros/conversions.h"

namespace pkm_workspace
{
namespace
{
using visualization_msgs::Marker;

constexpr Color TEXT = { 0.1F, 0.1F, 0.1F, 1.0F };
constexpr Color INSIDE = { 0.15F, 0.85F, 0.30F, 0.10F };
constexpr Color BOUNDARY = { 1.0F, 0.70F, 0.0F, 0.08F };
constexpr std::int64_t MOST_BOXES = 20000;

/// Flat boxes (their set does not change along the rails, and the region lies in their plane) are drawn with a little
/// thickness, just below it.
void addBoxes(const std::string& ns, const Color& color, const BoxTree& tree, CellState state, Scene& scene)
{
  const Box& whole = tree.bisection().root();
  const Eigen::Vector3d thickness = scene.unit() * ((whole.upper - whole.lower).array() == 0.0).cast<double>().matrix();
  const Color layer = { color.r, color.g, color.b, thickness.isZero() ? color.a : 5.0F * color.a };
  for (const std::vector<Box>& boxes : tree.boxes(state))
  {
    if (boxes.empty())
      continue;
    Marker& list = scene.add(ns, Marker::CUBE_LIST, layer);
    const Eigen::Vector3d scale = boxes.front().upper - boxes.front().lower + thickness;
    list.scale.x = scale.x();
    list.scale.y = scale.y();
    list.scale.z = scale.z();
    for (const Box& box : boxes)
      list.points.push_back(toMessage(box.center() - 2.0 * thickness));
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

Scene::Scene(const std_msgs::Header& header, double unit) : unit_(unit)
{
  Marker clear;
  clear.header = header;
  // the newest transform there is: markers are latched, and may be older than all that tf remembers
  clear.header.stamp = ros::Time();
  clear.action = Marker::DELETEALL;
  clear.pose.orientation.w = 1.0;
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

void Scene::addText(const std::string& ns, const Eigen::Vector3d& place, const std::string& text)
{
  Marker& marker = add(ns, Marker::TEXT_VIEW_FACING, TEXT);
  marker.pose.position = toMessage(place);
  marker.scale.z = 70.0 * unit_;
  marker.text = text;
}

void Scene::addCaption(const Eigen::Vector3d& place, const std::string& text)
{
  addText("hypotheses", place, text);
  array_.markers.back().scale.z *= 0.5;
  array_.markers.front().text = text;
}

void addPaving(const BoxTree& tree, const std::string& inside, const std::string& undecided, Scene& scene)
{
  const BoxTree coarse = tree.coarsened(MOST_BOXES);
  if (!inside.empty())
    addBoxes(inside, INSIDE, coarse, CellState::INSIDE, scene);
  if (undecided.empty())
    return;
  addBoxes(undecided, BOUNDARY, coarse, CellState::BOUNDARY, scene);
  addBoxes(undecided, BOUNDARY, coarse, CellState::PENDING, scene);
}

std::string digits(double value, std::string (*rounded)(double, int))
{
  constexpr int FEWER = 4;  // than the nine significant ones of decimalsFor()
  std::string text = rounded(value, std::max(0, decimalsFor(value, value) - FEWER));
  if (text.find('.') != std::string::npos)
    text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.')
    text.pop_back();
  return text;
}
}  // namespace pkm_workspace
