// SPDX-License-Identifier: BSD-3-Clause
#include <pkm_workspace/JointRanges.h>
#include <sensor_msgs/JointState.h>
#include <visualization_msgs/MarkerArray.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "node_client.h"

namespace pkm_workspace
{
namespace test
{
namespace
{
/// Messages without their number on the topic, which only the publisher knows.
template <class Message>
Message unnumbered(Message message)
{
  message.header.seq = 0;
  return message;
}

/// The value of a joint, or nothing like a length when it is not there.
double position(const sensor_msgs::JointState& state, const std::string& joint)
{
  const auto name = std::find(state.name.begin(), state.name.end(), joint);
  return name == state.name.end() ? 1e9 : state.position[static_cast<std::size_t>(name - state.name.begin())];
}
}  // namespace

TEST(Topics, latchTheLastRegionAndItsJointRanges)
{
  const Region computed = compute(RegionRequest()).region;
  const auto region = receive<Region>(NODE + "/region");
  EXPECT_EQ(computed, unnumbered(*region));
  const auto ranges = receive<JointRanges>(NODE + "/joint_ranges");
  EXPECT_EQ(computed.header, unnumbered(*ranges).header);
  EXPECT_EQ(computed.hypotheses, ranges->hypotheses);
  EXPECT_EQ(computed.solid, ranges->solid);
  EXPECT_EQ(computed.center, ranges->center);
  EXPECT_EQ(computed.joint_ranges, ranges->rails);
}

TEST(Topics, latchMarkersOfTheRegion)
{
  compute(RegionRequest());
  const auto array = receive<visualization_msgs::MarkerArray>(NODE + "/markers");
  ASSERT_FALSE(array->markers.empty());
  EXPECT_EQ(visualization_msgs::Marker::DELETEALL, array->markers.front().action);
  std::set<std::string> namespaces;
  for (auto marker = array->markers.begin() + 1; marker != array->markers.end(); ++marker)
  {
    EXPECT_EQ("base_link", marker->header.frame_id);
    namespaces.insert(marker->ns);
  }
  EXPECT_EQ((std::set<std::string>{ "region", "paving_inside", "joint_ranges" }), namespaces);
}

TEST(Topics, tellInOnePanelWhatThePicturesHoldFor)
{
  const Region region = compute(RegionRequest()).region;
  const auto text = [] {
    return receive<visualization_msgs::MarkerArray>(NODE + "/hypotheses_markers")->markers[1].text;
  };
  const ros::Time deadline = ros::Time::now() + PATIENCE;
  std::string panel = text();
  while (panel.find("region: dextrous with psi in [0.5, 2]") == std::string::npos && ros::Time::now() < deadline)
    panel = text();
  EXPECT_EQ(0U, panel.find(region.hypotheses.machine + ", geometry " + region.hypotheses.geometry_hash.substr(0, 8)));
  EXPECT_NE(std::string::npos, panel.find("region: dextrous with psi in [0.5, 2]")) << panel;
}

/// Hyphens in the colour, then words.
TEST(Topics, tellInThePanelWhatTheColorsOfTheSetStandFor)
{
  compute(RegionRequest());
  const auto array = receive<visualization_msgs::MarkerArray>(NODE + "/hypotheses_markers");
  std::map<std::string, std_msgs::ColorRGBA> legend;
  for (std::size_t k = 1; k + 1 < array->markers.size(); ++k)
    if (array->markers[k].ns == "legend" && array->markers[k].text.front() == '-')
      legend[array->markers[k + 1].text] = array->markers[k].color;
  ASSERT_EQ(2U, legend.size());
  ASSERT_EQ(1U, legend.count("psi at least 0.5"));
  ASSERT_EQ(1U, legend.count("psi at most 2"));
  std::set<std::string> drawn;
  for (const visualization_msgs::Marker& marker : receive<visualization_msgs::MarkerArray>(NODE + "/markers")->markers)
    if (marker.ns == "paving_inside")
      for (const std_msgs::ColorRGBA& color : marker.colors)
        for (const auto& [text, full] : legend)
          if (std::abs(color.r * full.g - color.g * full.r) + std::abs(color.g * full.b - color.b * full.g) < 1e-4)
            drawn.insert(text);
  EXPECT_EQ(2U, drawn.size());
}

TEST(Topics, showTheMachineAtTheCenterOfTheRegion)
{
  const Region region = compute(RegionRequest()).region;
  const auto isThere = [&region](const sensor_msgs::JointState& state) {
    return std::all_of(region.joint_ranges.begin(), region.joint_ranges.end(), [&state](const RailRange& range) {
      const double rho = position(state, range.joint);
      return range.lower <= rho && rho <= range.upper && rho != 0.0;
    });
  };
  const ros::Time deadline = ros::Time::now() + PATIENCE;
  auto state = receive<sensor_msgs::JointState>("/joint_states");
  while (!isThere(*state) && ros::Time::now() < deadline)
    state = receive<sensor_msgs::JointState>("/joint_states");
  EXPECT_TRUE(isThere(*state)) << *state;
  EXPECT_EQ(state->name.size(), state->position.size());
  EXPECT_GT(state->name.size(), 3U) << "passive joints are missing";
  EXPECT_FALSE(state->header.stamp.isZero());
}
}  // namespace test
}  // namespace pkm_workspace
