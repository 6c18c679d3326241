// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/ros/box_marker.h"

#include <algorithm>
#include <cmath>

#include "handles.h"
#include "pkm_workspace/dexterity/point_evaluation.h"
#include "pkm_workspace/region/largest_region.h"
#include "pkm_workspace/ros/conversions.h"
#include "pkm_workspace/ros/criterion_message.h"
#include "pkm_workspace/ros/reply.h"
#include "pkm_workspace/ros/solid_message.h"

namespace pkm_workspace
{
struct BoxFace
{
  int axis;
  int side;  ///< 0: of the least coordinate, 1: of the largest
};

namespace
{
using visualization_msgs::Marker;

constexpr const char* NAME = "box";
constexpr std::int64_t LOOKS = 20000;    ///< boxes for one verdict: what is dragged is not kept waiting
constexpr double LEAST_SIDE = 1e-3;      ///< of a box that is scaled [L]
constexpr double GROWTH_SECONDS = 10.0;  ///< a limit for the search at one center

constexpr unsigned MENU_GROW = 1;
constexpr unsigned MENU_CUBE = 2;
constexpr double FIRST_SIDE = 0.12;                   ///< of the box at first [L]
const Eigen::Vector3d FIRST_PLACE(-0.17, 0.17, 0.2);  ///< of its center, beside the handle of the tool [L]
constexpr double BALL = 0.05;  ///< diameter of what is dragged at each face, and its distance from the face [L]
constexpr double GRIP = 1.01;  ///< of the box that is dragged to the one that is shown

constexpr BoxFace FACES[] = { { 0, 0 }, { 0, 1 }, { 1, 0 }, { 1, 1 }, { 2, 0 }, { 2, 1 } };

/// "box_x0": the face of the least x.
std::string nameOf(const BoxFace& face)
{
  return std::string(NAME) + "_" + "xyz"[face.axis] + "01"[face.side];
}

Eigen::Vector3d outwards(const BoxFace& face)
{
  return (face.side == 0 ? -1.0 : 1.0) * Eigen::Vector3d::Unit(face.axis);
}

Eigen::Vector3d faceCenter(const Box& box, const BoxFace& face)
{
  Eigen::Vector3d place = box.center();
  place[face.axis] = face.side == 0 ? box.lower[face.axis] : box.upper[face.axis];
  return place;
}

Box around(const Eigen::Vector3d& center, const Eigen::Vector3d& sides)
{
  return { center - 0.5 * sides, center + 0.5 * sides };
}

/// The box between two corners of doubles: the same with a center and sides that hold all of it.
ContainmentResult check(const BoxTest& test, const Box& box)
{
  const Eigen::Vector3d center = box.center();
  return checkContainment(test, *makeBox(2.0 * box.halfWidths()), center, 1.0, LOOKS);
}

/// Half the sides of a box along the axes within one that is turned about its center.
Eigen::Vector3d heldByTurned(const Eigen::Vector3d& half_sides, double angle)
{
  const double s = std::abs(std::sin(angle));
  const double c = std::abs(std::cos(angle));
  const double share = std::min(half_sides.x(), half_sides.y()) / (s + c);
  return s == 0.0 ? half_sides : Eigen::Vector3d(share, share, half_sides.z());
}

/// Half the sides of a box that the region holds around its center; 0 along an axis across which the region is flat.
Eigen::Vector3d heldBy(const Region& region)
{
  const std::vector<double>& dimensions = region.solid.dimensions;
  if (region.solid.type == shape_msgs::SolidPrimitive::BOX)
    return heldByTurned(0.5 * Eigen::Vector3d(dimensions[0], dimensions[1], dimensions[2]), region.angle);
  if (dimensions.size() == 1)
    return Eigen::Vector3d::Constant(dimensions[0] / std::sqrt(3.0));
  return { dimensions[1] / std::sqrt(2.0), dimensions[1] / std::sqrt(2.0), 0.5 * dimensions[0] };
}
}  // namespace

BoxMarker::BoxMarker(NodeContext& context, interactive_markers::InteractiveMarkerServer& handles)
  : context_(context)
  , dragger_(context.addWorker())
  , grower_(context.addWorker())
  , handles_(handles)
  , markers_(context.private_node.advertise<visualization_msgs::MarkerArray>("box_markers", 1, true))
  , box_(around(context.machine().zero() + context.machine().scale() * FIRST_PLACE,
                Eigen::Vector3d::Constant(FIRST_SIDE * context.machine().scale())))
{
  for (const BoxFace& face : FACES)
  {
    Handle ball{ nameOf(face), context.frames.root().frame, handlePlace(face) };
    ball.size.setConstant(BALL * context.machine().scale());
    ball.axis = face.axis;
    insert(ball);
  }
  set(box_);
}

void BoxMarker::refresh()
{
  later([this] { set(box_); });
}

void BoxMarker::placeIn(const Region& region)
{
  const double scale = context_.machine().scale();
  const Eigen::Vector3d room = heldBy(region);
  Eigen::Vector3d sides;
  Eigen::Vector3d center = fromMessage(region.center);
  for (int axis = 0; axis < 3; ++axis)
  {
    const bool is_flat = room[axis] == 0.0;
    sides[axis] = std::min(FIRST_SIDE * scale, is_flat ? 0.5 * room.maxCoeff() : 0.5 * room[axis]);
    if (!is_flat)  // where the tool is not
      center[axis] += std::clamp(FIRST_PLACE[axis] * scale, -0.7 * room[axis], 0.7 * room[axis]);
  }
  later([this, center, sides] {
    if (!is_led_)
      set(around(center, sides));
  });
}

Eigen::Vector3d BoxMarker::lowestPoint() const
{
  const std::lock_guard<std::mutex> lock(mutex_);
  return faceCenter(box_, { 2, 0 }) - 1.6 * BALL * context_.machine().scale() * Eigen::Vector3d::UnitZ();
}

void BoxMarker::later(const std::function<void()>& job)
{
  dragger_.post([this, job] { guarded(context_.health, NAME, job); });
}

void BoxMarker::take(const Feedback& feedback)
{
  using visualization_msgs::InteractiveMarkerFeedback;
  if (feedback->event_type == InteractiveMarkerFeedback::POSE_UPDATE)
    later([this, feedback] {
      is_led_ = true;
      drag(feedback);
    });
  if (feedback->event_type != InteractiveMarkerFeedback::MENU_SELECT)
    return;
  if (feedback->menu_entry_id == MENU_GROW)
    later([this] { grow(); });
  if (feedback->menu_entry_id == MENU_CUBE)
    later([this] {
      is_led_ = true;
      set(around(box_.center(), Eigen::Vector3d::Constant(box_.maxWidth())));
    });
}

void BoxMarker::drag(const Feedback& feedback)
{
  Eigen::Vector3d place = context_.frames.pointInRoot(feedback->header.frame_id, fromMessage(feedback->pose.position));
  Problems problems;
  requireFinite("place", place, problems);
  throwProblems(problems);
  if (feedback->marker_name == NAME)
    return set(around(place, box_.upper - box_.lower));
  Box box = box_;
  const double least = LEAST_SIDE * context_.machine().scale();
  for (const BoxFace& face : FACES)
    if (feedback->marker_name == nameOf(face))
    {
      place -= BALL * context_.machine().scale() * outwards(face);
      if (face.side == 0)
        box.lower[face.axis] = std::min(place[face.axis], box.upper[face.axis] - least);
      else
        box.upper[face.axis] = std::max(place[face.axis], box.lower[face.axis] + least);
    }
  set(box);
}

void BoxMarker::grow()
{
  is_led_ = true;
  const StopFlag stop = grower_.makeStopFlag();
  grower_.post([this, stop, before = box_] {
    guarded(context_.health, NAME, [&] {
      RegionQuery query = context_.query();
      query.shape = makeBox(before.upper - before.lower);
      query.ratio.reset();
      query.angles = 0.0;
      query.search_box.reset();
      query.budget.time_limit = std::min(query.budget.time_limit, GROWTH_SECONDS);
      query.budget.stop = stop.get();
      const LargestRegion region = largestRegionAt(context_.machine(), query, before.center());
      if (!(region.size > 0.0))
        throw Refusal(ErrorCode::INVALID_REQUEST, "no box of these proportions is proved at this center");
      const std::vector<double> sides = region.shape->dimensions(region.size);
      const Box grown = around(region.center, { sides[0], sides[1], sides[2] });
      later([this, before, grown] {
        if (box_.lower == before.lower && box_.upper == before.upper)  // else it was dragged on meanwhile
          set(grown);
      });
    });
  });
}

void BoxMarker::set(const Box& box)
{
  // first what refuses a box that makes no sense
  const Criterion criterion = context_.query().criterion;
  const PointEvaluator evaluate(context_.machine(), criterion);
  const ContainmentResult result = check(evaluate.test(), box);
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    box_ = box;
  }
  showBody();
  for (const BoxFace& face : FACES)
    handles_.setPose(nameOf(face), poseAt(handlePlace(face)));
  handles_.applyChanges();
  auto shown = boxMarkers(box, result, evaluate, context_.frames.root().frame);
  shown.markers.front().text = describe(context_.frames.root().premises(criterion));
  markers_.publish(shown);
  if (moved_)
    moved_();
}

void BoxMarker::insert(const Handle& handle)
{
  handles_.insert(toMessage(handle), [this](const Feedback& feedback) { take(feedback); });
}

void BoxMarker::showBody()
{
  const Eigen::Vector3d sides = box_.upper - box_.lower;
  if (sides.isApprox(shown_sides_, 1e-9))
  {
    handles_.setPose(NAME, poseAt(box_.center()));  // what is dragged would be lost if it were inserted again
    return;
  }
  Handle body{ NAME, context_.frames.root().frame, box_.center() };
  body.type = Marker::CUBE;
  body.size = GRIP * sides;
  body.color = BARELY_VISIBLE;
  body.menu = { "Grow to the largest here", "Make it a cube" };
  insert(body);
  shown_sides_ = sides;
}

Eigen::Vector3d BoxMarker::handlePlace(const BoxFace& face) const
{
  return faceCenter(box_, face) + BALL * context_.machine().scale() * outwards(face);
}
}  // namespace pkm_workspace
