// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <sstream>

#include "pkm_workspace/dexterity/defaults.h"
#include "pkm_workspace/region/region_wish.h"
#include "pkm_workspace/ros/box_marker.h"
#include "pkm_workspace/ros/conversions.h"
#include "pkm_workspace/ros/markers.h"
#include "pkm_workspace/urdf_io/urdf_reader.h"

namespace pkm_workspace
{
namespace test
{
namespace
{
using Eigen::Vector2d;
using Eigen::Vector3d;

const std::string ROOT = std::string(PKM_WORKSPACE_SOURCE_DIR) + '/';
constexpr double PITCH = 0.42;    // of the views of rviz/ [rad]
constexpr double DISTANCE = 3.5;  // of the camera [L]

/// A text as it is seen, or a rail.
struct Seen
{
  std::string name;
  Vector2d center;
  Vector2d half;
};

/// The picture of a camera that looks at a point from some direction around it.
class Camera
{
public:
  Camera(const Vector3d& focus, double distance, double yaw) : focus_(focus), distance_(distance)
  {
    const Vector3d away(std::cos(yaw) * std::cos(PITCH), std::sin(yaw) * std::cos(PITCH), std::sin(PITCH));
    right_ = Vector3d(-std::sin(yaw), std::cos(yaw), 0.0);
    away_ = away;
    up_ = away.cross(right_);
  }

  Vector2d operator()(const Vector3d& point) const
  {
    const Vector3d offset = point - focus_;
    return Vector2d(right_.dot(offset), up_.dot(offset)) / depthOf(point);
  }
  double depthOf(const Vector3d& point) const { return distance_ - away_.dot(point - focus_); }

  /// Letters are about half as wide as high.
  Seen text(const std::string& text, const Vector3d& place, double height) const
  {
    std::istringstream lines(text);
    double width = 0.0;
    double rows = 0.0;
    for (std::string line; std::getline(lines, line); rows += 1.2)
      width = std::max(width, 0.55 * static_cast<double>(line.size()));
    return { text, (*this)(place), 0.5 * height * Vector2d(width, rows) / depthOf(place) };
  }

private:
  Vector3d focus_;
  double distance_;
  Vector3d right_;
  Vector3d up_;
  Vector3d away_;
};

bool overlap(const Seen& one, const Seen& other)
{
  return ((one.center - other.center).cwiseAbs().array() < (one.half + other.half).array()).all();
}

struct Drawn
{
  UrdfMachine urdf;
  Region region;
  visualization_msgs::MarkerArray array;
};

Drawn drawn(const std::string& file, const std::string& shape)
{
  UrdfMachine urdf = readUrdfFile(ROOT + file);
  RegionQuery query;
  query.criterion = defaultCriterion();
  setShape({ shape, {}, {} }, query);
  query.accuracy = 0.01 * urdf.machine.scale();
  const FramedMachine in{ "root", std::make_shared<const Machine>(urdf.machine), urdf.machine.geometryHash(), Pose() };
  const Region region = toMessage(Answer{ { query, in }, findLargestRegion(urdf.machine, query) }, ros::Time());
  const auto array = markersOf(region, in.premises(query.criterion), urdf.machine, urdf.drawn_rails, nullptr);
  return { urdf, region, array };
}

/// Points along a rail as it is drawn.
std::vector<Seen> railOf(const Drawn& scene, int i, const Camera& camera)
{
  const Interval& rail = scene.urdf.drawn_rails[static_cast<std::size_t>(i)];
  std::vector<Seen> seen;
  for (int k = 0; k <= 20; ++k)
  {
    const Vector3d point =
        drivenPoint(scene.urdf.machine.leg(i), rail.lower() + 0.05 * k * (rail.upper() - rail.lower()));
    const double half = 0.01 * scene.urdf.machine.scale() / camera.depthOf(point);
    seen.push_back({ scene.urdf.machine.leg(i).joint + " itself", camera(point), { half, half } });
  }
  return seen;
}

std::vector<Seen> labelsOf(const Drawn& scene, const Camera& camera)
{
  std::vector<Seen> seen;
  for (const visualization_msgs::Marker& marker : scene.array.markers)
    if (marker.type == visualization_msgs::Marker::TEXT_VIEW_FACING)
      seen.push_back(camera.text(marker.text, fromMessage(marker.pose.position), marker.scale.z));
  const Vector3d place = placeOfHypotheses(scene.region, scene.urdf.machine, scene.urdf.drawn_rails);
  const std::string hypotheses = scene.array.markers.front().text;
  seen.push_back(camera.text("region: " + hypotheses, place, 0.045 * scene.urdf.machine.scale()));
  return seen;
}

void expectApart(const Drawn& scene, double yaw)
{
  const Vector3d focus = 0.5 * (scene.urdf.machine.zero() + drivenPoint(scene.urdf.machine.leg(0), 0.0));
  const Camera camera(focus, DISTANCE * scene.urdf.machine.scale(), yaw);
  const std::vector<Seen> labels = labelsOf(scene, camera);
  ASSERT_EQ(5U, labels.size());
  for (std::size_t i = 0; i < labels.size(); ++i)
  {
    for (std::size_t k = 0; k < i; ++k)
      EXPECT_FALSE(overlap(labels[i], labels[k])) << labels[i].name << " lies on " << labels[k].name << ", yaw " << yaw;
    for (int leg = 0; leg < 3; ++leg)
      for (const Seen& part : railOf(scene, leg, camera))
        EXPECT_FALSE(overlap(labels[i], part)) << labels[i].name << " lies on " << part.name << ", yaw " << yaw;
  }
}
}  // namespace

/// From where rviz opens, and nearly so.
TEST(Labels, coverNeitherEachOtherNorTheRails)
{
  struct Case
  {
    const char* file;
    const char* shape;
    double yaw;
  };
  for (const Case& each :
       { Case{ "urdf/orthoglide.urdf", "cube", 0.92 }, Case{ "urdf/orthoglide_prototype.urdf", "cube", 0.92 },
         Case{ "urdf/uranesx.urdf", "square", M_PI / 3.0 }, Case{ "test/data/delta_cnc.urdf", "cube", 1.307 },
         Case{ "test/data/triaglide.urdf", "square", 0.92 } })
  {
    SCOPED_TRACE(each.file);
    const Drawn scene = drawn(each.file, each.shape);
    for (const double turn : { -0.1, 0.0, 0.1 })
      expectApart(scene, each.yaw + turn);
  }
}

/// Above the box on an Orthoglide, whose struts come from below and beside; below it under the carriages of a delta.
TEST(Labels, ofABoxStandWhereNoStrutsAre)
{
  for (const auto& [file, side] :
       { std::make_pair("urdf/orthoglide.urdf", 1.0), std::make_pair("urdf/uranesx.urdf", -1.0),
         std::make_pair("test/data/delta_cnc.urdf", -1.0) })
  {
    const Machine machine = readUrdfFile(ROOT + file).machine;
    const Vector3d half = Vector3d::Constant(0.1 * machine.scale());
    const Box box{ machine.zero() - half, machine.zero() + half };
    const visualization_msgs::MarkerArray array =
        boxMarkers(box, ContainmentResult(), PointEvaluator(machine, defaultCriterion()), "base_link");
    int lines = 0;
    for (const visualization_msgs::Marker& marker : array.markers)
      if (marker.ns == "verdict")
      {
        ++lines;
        EXPECT_GT(side * (marker.pose.position.z - machine.zero().z()), half.z()) << file;
      }
    EXPECT_GT(lines, 0);
  }
}

TEST(Labels, standBeyondWhatIsDrawnOfARail)
{
  const UrdfMachine urdf = readUrdfFile(ROOT + "test/data/delta_cnc.urdf");
  for (std::size_t i = 0; i < 3; ++i)
  {
    // 0.45 m around 0.174722 m or so above the slider at joint value 0
    EXPECT_NEAR(-0.05, urdf.drawn_rails[i].lower(), 1e-3);
    EXPECT_NEAR(0.4, urdf.drawn_rails[i].upper(), 1e-3);
  }
}
}  // namespace test
}  // namespace pkm_workspace
