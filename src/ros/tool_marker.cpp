// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/ros/tool_marker.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "handles.h"
#include "pkm_workspace/dexterity/point_evaluation.h"
#include "pkm_workspace/report/binding_limit.h"
#include "pkm_workspace/ros/conversions.h"
#include "pkm_workspace/ros/criterion_message.h"
#include "pkm_workspace/ros/reply.h"

namespace pkm_workspace
{
namespace
{
using visualization_msgs::Marker;

constexpr const char* TOOL_NAME = "tool";
constexpr Color TOOL_RED = { 0.9F, 0.1F, 0.1F, 0.7F };
constexpr Color RAIL = { 0.6F, 0.6F, 0.65F, 1.0F };
constexpr Color SLIDER = { 0.95F, 0.45F, 0.05F, 1.0F };
constexpr double SPEED = 0.1;         ///< of the joints [m/s]
constexpr double COMFORT = 0.3;       ///< margin from which on it is all green
constexpr double LONGEST_AXIS = 8.0;  ///< beyond that near a parallel singularity the ellipsoid is cut off
/// Diameter [L] of the ball that can be grabbed: around the ellipsoid, which would be in the way of the mouse.
constexpr double TOOL_GRIP = 0.42;

/// From yellow at the border to green.
Color colorOf(double margin)
{
  const auto share = static_cast<float>(std::clamp(margin / COMFORT, 0.0, 1.0));
  return { 0.95F - 0.75F * share, 0.8F, 0.1F + 0.2F * share, 0.7F };
}

void addEllipsoid(const Jacobians& jacobians, const Eigen::Vector3d& point, const Color& color, Scene& scene)
{
  if (!jacobians.j.allFinite())  // at a parallel singularity
  {
    Marker& ball = scene.add("ellipsoid", Marker::SPHERE, TOOL_RED);
    ball.pose.position = toMessage(point);
    ball.scale.x = ball.scale.y = ball.scale.z = 2.0 * SPEED * 1000.0 * scene.unit();
    return;
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> squares(jacobians.j * jacobians.j.transpose());
  Eigen::Matrix3d axes = squares.eigenvectors();
  if (axes.determinant() < 0.0)
    axes.col(2) *= -1.0;
  const Eigen::Quaterniond turn(axes);
  const Eigen::Vector3d sizes =
      2.0 * SPEED * squares.eigenvalues().cwiseMax(0.0).cwiseSqrt().cwiseMin(LONGEST_AXIS) * 1000.0 * scene.unit();
  Marker& marker = scene.add("ellipsoid", Marker::SPHERE, color);
  marker.pose.position = toMessage(point);
  marker.pose.orientation = toMessage(turn);
  marker.scale.x = sizes.x();
  marker.scale.y = sizes.y();
  marker.scale.z = sizes.z();
}

/// As far as its limits let the point go that a joint moves, and no farther than @p reach [m].
void addTravel(const Leg& leg, double rho, double reach, const Eigen::Vector3d& tool, Scene& scene)
{
  const auto* const crank = std::get_if<Crank>(&leg.kind);
  const double most = crank ? std::min(M_PI, reach / crank->radius.mid()) : reach;
  const double lower = std::max(leg.limits.lower(), rho - most);
  const double upper = std::min(leg.limits.upper(), rho + most);
  Marker& rail = scene.add("travel", Marker::LINE_LIST, RAIL);
  rail.scale.x = 8.0 * scene.unit();
  addWay(leg, lower, upper, tool, rail.points);
  Marker& slider = scene.add("travel", Marker::SPHERE, SLIDER);
  slider.pose.position = toMessage(movedPoint(leg, rho, tool));
  slider.scale.x = slider.scale.y = slider.scale.z = 45.0 * scene.unit();
}

}  // namespace

visualization_msgs::MarkerArray toolMarkers(const Machine& machine, const Criterion& criterion, const ToolState& tool,
                                            const std::string& frame)
{
  std_msgs::Header header;
  header.frame_id = frame;
  Scene scene(header, machine.scale() / 1000.0);
  const PointEvaluator evaluate(machine, criterion);
  const PointEvaluation there = evaluate(tool.point);
  const bool good = tool.objection.empty() && there.verdict == BoxVerdict::INSIDE;
  if (const auto matrices = jacobians(machine, tool.point))
    addEllipsoid(*matrices, tool.point, good ? colorOf(evaluate.test().margin(tool.point)) : TOOL_RED, scene);
  if (const auto rho = inverseKinematics(machine, tool.point))
    for (int i = 0; i < 3; ++i)
      addTravel(machine.leg(i), (*rho)[i], 0.6 * machine.scale(), tool.point, scene);
  const Eigen::Vector3d below = tool.point - 400.0 * scene.unit() * Eigen::Vector3d::UnitZ();
  if (good)
    scene.addText("nearest", below, "nearest limit: " + brief(there.binding(), machine), 0.75);
  else
    scene.addText("reason", below, tool.objection.empty() ? describe(there.binding(), machine) : tool.objection, 0.75);
  return scene.array();
}

ToolMarker::ToolMarker(NodeContext& context, Tool& tool, interactive_markers::InteractiveMarkerServer& handles)
  : context_(context)
  , tool_(tool)
  , handles_(handles)
  , markers_(context.private_node.advertise<visualization_msgs::MarkerArray>("tool_markers", 1, true))
{
  Handle handle{ TOOL_NAME, context.frames.root().frame, tool.state().point };
  handle.size.setConstant(TOOL_GRIP * context.machine().scale());
  handle.color = BARELY_VISIBLE;
  handle.arrows = TOOL_GRIP * context.machine().scale();
  handles_.insert(toMessage(handle), [this](const auto& feedback) {
    if (feedback->event_type == visualization_msgs::InteractiveMarkerFeedback::POSE_UPDATE)
      guarded(context_.health, TOOL_NAME, [&] {
        tool_.lead(context_.frames.pointInRoot(feedback->header.frame_id, fromMessage(feedback->pose.position)));
      });
  });
  handles_.applyChanges();
  tool.onMove([this] { show(); });
  show();
}

void ToolMarker::show()
{
  handles_.setPose(TOOL_NAME, poseAt(tool_.state().point));
  handles_.applyChanges();
  const std::lock_guard<std::mutex> lock(mutex_);  // the last one to publish has the newest state
  const Criterion criterion = context_.query().criterion;
  auto shown = toolMarkers(context_.machine(), criterion, tool_.state(), context_.frames.root().frame);
  shown.markers.front().text = describe(context_.frames.root().premises(criterion));
  markers_.publish(shown);
  if (moved_)
    moved_();
}

Eigen::Vector3d ToolMarker::lowestPoint() const
{
  return tool_.state().point - 0.5 * TOOL_GRIP * context_.machine().scale() * Eigen::Vector3d::UnitZ();
}
}  // namespace pkm_workspace
