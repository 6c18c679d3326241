// SPDX-License-Identifier: BSD-3-Clause
#include "labels.h"
#include "pkm_workspace/interval/decimal.h"
#include "pkm_workspace/ros/box_marker.h"
#include "pkm_workspace/ros/conversions.h"
#include "scene.h"

namespace pkm_workspace
{
namespace
{
using visualization_msgs::Marker;

constexpr Color BOX_GREEN = { 0.2F, 0.8F, 0.3F, 0.45F };
constexpr Color BOX_YELLOW = { 0.95F, 0.8F, 0.1F, 0.45F };
constexpr Color BOX_RED = { 0.9F, 0.1F, 0.1F, 0.45F };

/// The condition that is violated most at the bad point, or that is nearest to be at any corner: "psi_max".
std::string bindingOf(const Box& box, const ContainmentResult& result, const PointEvaluator& evaluate)
{
  Eigen::Vector3d place = result.bad_point.value_or(box.center());
  if (!result.bad_point)
    for (const double x : { box.lower.x(), box.upper.x() })
      for (const double y : { box.lower.y(), box.upper.y() })
        for (const double z : { box.lower.z(), box.upper.z() })
          if (const Eigen::Vector3d corner(x, y, z); evaluate.test().margin(corner) < evaluate.test().margin(place))
            place = corner;
  const PointEvaluation there = evaluate(place);
  const Limit& limit = there.binding();
  return name(limit.kind) + (limit.leg < 0 ? "" : " of " + evaluate.machine().leg(limit.leg).joint) +
         (limit.zone.empty() ? "" : " of " + limit.zone);
}

/// Its size, the verdict, and what binds.
std::string textOf(const Box& box, const ContainmentResult& result, const PointEvaluator& evaluate)
{
  constexpr int DIGITS = 4;
  const auto side = [&box](int axis) { return nearly(box.width(axis), DIGITS); };
  const std::string size = side(0) + " x " + side(1) + " x " + side(2) + " m\n";
  const std::string binds = bindingOf(box, result, evaluate);
  if (result.verdict == Containment::INSIDE)
    return size + "box inside: proved for every point" + "\nnearest limit: " + binds;
  if (result.verdict == Containment::OUTSIDE)
    return size + "box outside: a bad point is near\nwhich breaks " + binds;
  return size + "box undecided: the border of the set is too near\nnearest limit: " + binds;
}
}  // namespace

visualization_msgs::MarkerArray boxMarkers(const Box& box, const ContainmentResult& result,
                                           const PointEvaluator& evaluate, const std::string& frame)
{
  std_msgs::Header header;
  header.frame_id = frame;
  Scene scene(header, evaluate.machine().scale() / 1000.0);
  const Color color = result.verdict == Containment::INSIDE    ? BOX_GREEN
                      : result.verdict == Containment::OUTSIDE ? BOX_RED
                                                               : BOX_YELLOW;
  Marker& cube = scene.add("box", Marker::CUBE, color);
  cube.pose.position = toMessage(box.center());
  cube.scale.x = box.width(0);
  cube.scale.y = box.width(1);
  cube.scale.z = box.width(2);
  if (result.bad_point)
  {
    Marker& ball = scene.add("bad_point", Marker::SPHERE, { BOX_RED.r, BOX_RED.g, BOX_RED.b, 1.0F });
    ball.pose.position = toMessage(*result.bad_point);
    ball.scale.x = ball.scale.y = ball.scale.z = 30.0 * scene.unit();
  }
  scene.addText("verdict", labelOf(box, evaluate.machine(), scene.unit()), textOf(box, result, evaluate), 0.75);
  return scene.array();
}
}  // namespace pkm_workspace
