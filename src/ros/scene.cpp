// SPDX-License-Identifier: BSD-3-Clause
#include "scene.h"

#include <algorithm>
#include <sstream>

#include "pkm_workspace/interval/decimal.h"
#include "pkm_workspace/ros/conversions.h"

namespace pkm_workspace
{
namespace
{
using visualization_msgs::Marker;

constexpr double LETTER = 60.0;  ///< height of letters, in units
constexpr double GAP = 0.01;     ///< that rviz puts between lines, whatever the height of their letters [m]
constexpr double SMALL = 0.008;  ///< letters that are no higher would stand too far apart [m]
constexpr int PIECES_OF_ARC = 24;

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

double Scene::lineHeight(double size) const
{
  const double height = LETTER * size * unit_;
  return height < SMALL ? 1.2 * height : height + GAP;
}

void Scene::addText(const std::string& ns, const Eigen::Vector3d& place, const std::string& text, double size,
                    const Color& color)
{
  const double height = LETTER * size * unit_;
  const auto lines = std::count(text.begin(), text.end(), '\n') + 1;
  if (lines > 1 && height < SMALL)
  {
    std::istringstream rest(text);
    double above = 0.5 * lineHeight(size) * static_cast<double>(lines - 1);
    for (std::string line; std::getline(rest, line); above -= lineHeight(size))
      addText(ns, place + above * Eigen::Vector3d::UnitZ(), line, size, color);
    return;
  }
  Marker& marker = add(ns, Marker::TEXT_VIEW_FACING, color);
  marker.pose.position = toMessage(place);
  marker.scale.z = height;
  marker.text = text;
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

Eigen::Vector3d movedPoint(const Leg& leg, double joint, const Eigen::Vector3d& tool)
{
  const Eigen::Vector3d place = drivenPoint(leg, joint);
  const auto* const strut = std::get_if<TelescopicStrut>(&leg.kind);
  if (strut == nullptr)
    return place;
  return place + (strut->length.mid() + joint) * (tool + mid(strut->platform) - place).normalized();
}

void addWay(const Leg& leg, double lower, double upper, const Eigen::Vector3d& tool,
            std::vector<geometry_msgs::Point>& lines)
{
  const int pieces = hasAngle(leg) ? PIECES_OF_ARC : 1;
  for (int k = 0; k < pieces; ++k)
    for (const int end : { k, k + 1 })
    {
      const double share = static_cast<double>(end) / pieces;
      lines.push_back(toMessage(movedPoint(leg, (1.0 - share) * lower + share * upper, tool)));
    }
}
}  // namespace pkm_workspace
