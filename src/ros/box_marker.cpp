// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/ros/box_marker.h"

#include <algorithm>
#include <sstream>

#include "handles.h"
#include "pkm_workspace/region/largest_region.h"
#include "pkm_workspace/ros/conversions.h"
#include "pkm_workspace/ros/reply.h"

namespace pkm_workspace
{
namespace
{
using visualization_msgs::Marker;

constexpr const char* NAME = "box";
constexpr Color GREEN = { 0.2F, 0.8F, 0.3F, 0.45F };
constexpr Color YELLOW = { 0.95F, 0.8F, 0.1F, 0.45F };
constexpr Color RED = { 0.9F, 0.1F, 0.1F, 0.45F };
constexpr std::int64_t LOOKS = 20000;    ///< boxes for one verdict: what is dragged is not kept waiting
constexpr double LEAST_SIDE = 1e-3;      ///< of a box that is scaled [L]
constexpr double GROWTH_SECONDS = 10.0;  ///< a limit for the search at one center

/// "box_x0": the face of the least x.
std::string faceName(int axis, int side)
{
  return std::string(NAME) + "_" + "xyz"[axis] + "01"[side];
}

Eigen::Vector3d faceCenter(const Box& box, int axis, int side)
{
  Eigen::Vector3d place = box.center();
  place[axis] = side == 0 ? box.lower[axis] : box.upper[axis];
  return place;
}

Box around(const Eigen::Vector3d& center, const Eigen::Vector3d& sides)
{
  return { center - 0.5 * sides, center + 0.5 * sides };
}

std::string textOf(const ContainmentResult& result)
{
  if (result.verdict == Containment::INSIDE)
    return "inside: proved for every point";
  if (result.verdict == Containment::UNDECIDED)
    return "undecided: its border is too near";
  std::ostringstream text;
  text.precision(4);
  text << "outside: (" << result.bad_point->x() << ", " << result.bad_point->y() << ", " << result.bad_point->z()
       << ") m is bad";
  return text.str();
}

/// The box between two corners of doubles: the same with a center and sides that hold all of it.
ContainmentResult check(const Machine& machine, const Criterion& criterion, const Box& box)
{
  const Eigen::Vector3d center = box.center();
  return checkContainment(BoxTest(machine, criterion), *makeBox(2.0 * box.halfWidths()), center, 1.0, LOOKS);
}
}  // namespace

visualization_msgs::MarkerArray boxMarkers(const Box& box, const ContainmentResult& result, const Machine& machine,
                                           const std::string& frame)
{
  std_msgs::Header header;
  header.frame_id = frame;
  Scene scene(header, machine.scale() / 1000.0);
  const Color color = result.verdict == Containment::INSIDE    ? GREEN
                      : result.verdict == Containment::OUTSIDE ? RED
                                                               : YELLOW;
  Marker& cube = scene.add("box", Marker::CUBE, color);
  cube.pose.position = toMessage(box.center());
  cube.scale.x = box.width(0);
  cube.scale.y = box.width(1);
  cube.scale.z = box.width(2);
  if (result.bad_point)
  {
    Marker& ball = scene.add("bad_point", Marker::SPHERE, { RED.r, RED.g, RED.b, 1.0F });
    ball.pose.position = toMessage(*result.bad_point);
    ball.scale.x = ball.scale.y = ball.scale.z = 30.0 * scene.unit();
  }
  scene.addText("verdict", faceCenter(box, 2, 1) + 100.0 * scene.unit() * Eigen::Vector3d::UnitZ(), textOf(result));
  return scene.array();
}

BoxMarker::BoxMarker(NodeContext& context, interactive_markers::InteractiveMarkerServer& handles)
  : context_(context)
  , handles_(handles)
  , markers_(context.private_node.advertise<visualization_msgs::MarkerArray>("box_markers", 1, true))
  , box_(around(context.machine().zero(), Eigen::Vector3d::Constant(0.3 * context.machine().scale())))
{
  menu_.insert("Grow to the largest here", [this](const Feedback&) { grow(); });
  menu_.insert("Make it a cube", [this](const Feedback&) { makeCube(); });
  insertHandles();
  set(box());
}

void BoxMarker::insertHandles()
{
  const auto on_drag = [this](const Feedback& feedback) {
    if (feedback->event_type == visualization_msgs::InteractiveMarkerFeedback::POSE_UPDATE)
      guarded(context_.health, NAME, [&] { drag(feedback); });
  };
  Handle handle{ NAME, context_.frames.root().frame, box_.center(), 0.04 * context_.machine().scale() };
  handle.is_free = true;
  handles_.insert(toMessage(handle), on_drag);
  menu_.apply(handles_, NAME);
  for (int axis = 0; axis < 3; ++axis)
    for (const int side : { 0, 1 })
    {
      Handle face{ faceName(axis, side), handle.frame, faceCenter(box_, axis, side), 0.7 * handle.size };
      face.axes = { axis };
      handles_.insert(toMessage(face), on_drag);
    }
  handles_.applyChanges();
}

void BoxMarker::drag(const Feedback& feedback)
{
  const Eigen::Vector3d place =
      context_.frames.pointInRoot(feedback->header.frame_id, fromMessage(feedback->pose.position));
  Box box = this->box();
  if (feedback->marker_name == NAME)
    return set(around(place, box.upper - box.lower));
  const double least = LEAST_SIDE * context_.machine().scale();
  for (int axis = 0; axis < 3; ++axis)
  {
    if (feedback->marker_name == faceName(axis, 0))
      box.lower[axis] = std::min(place[axis], box.upper[axis] - least);
    if (feedback->marker_name == faceName(axis, 1))
      box.upper[axis] = std::max(place[axis], box.lower[axis] + least);
  }
  set(box);
}

void BoxMarker::grow()
{
  const StopFlag stop = context_.worker.makeStopFlag();
  context_.worker.post([this, stop] {
    guarded(context_.health, NAME, [&] {
      const Box before = box();
      RegionQuery query = context_.query();
      query.shape = makeBox(before.upper - before.lower);
      query.ratio.reset();
      query.search_box.reset();
      query.budget.time_limit = std::min(query.budget.time_limit, GROWTH_SECONDS);
      query.budget.stop = stop.get();
      const LargestRegion region = largestRegionAt(context_.machine(), query, before.center());
      if (!(region.size > 0.0))
        throw Refusal(ErrorCode::INVALID_REQUEST, "no box of these proportions is proved at this center");
      const std::vector<double> sides = region.shape->dimensions(region.size);
      set(around(region.center, { sides[0], sides[1], sides[2] }));
    });
  });
}

void BoxMarker::makeCube()
{
  const Box before = box();
  set(around(before.center(), Eigen::Vector3d::Constant(before.maxWidth())));
}

void BoxMarker::set(const Box& box)
{
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    box_ = box;
  }
  handles_.setPose(NAME, poseAt(box.center()));
  for (int axis = 0; axis < 3; ++axis)
    for (const int side : { 0, 1 })
      handles_.setPose(faceName(axis, side), poseAt(faceCenter(box, axis, side)));
  handles_.applyChanges();
  const ContainmentResult result = check(context_.machine(), context_.query().criterion, box);
  markers_.publish(boxMarkers(box, result, context_.machine(), context_.frames.root().frame));
}

Box BoxMarker::box() const
{
  const std::lock_guard<std::mutex> lock(mutex_);
  return box_;
}
}  // namespace pkm_workspace
