// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/ros/box_marker.h"

#include <algorithm>

#include "handles.h"
#include "pkm_workspace/interval/decimal.h"
#include "pkm_workspace/interval/text_stream.h"
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
constexpr Color GREEN = { 0.2F, 0.8F, 0.3F, 0.45F };
constexpr Color YELLOW = { 0.95F, 0.8F, 0.1F, 0.45F };
constexpr Color RED = { 0.9F, 0.1F, 0.1F, 0.45F };
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

std::string textOf(const ContainmentResult& result)
{
  if (result.verdict == Containment::INSIDE)
    return "box inside: proved for every point";
  if (result.verdict == Containment::UNDECIDED)
    return "box undecided: the border of the set is too near";
  TextStream text;
  const Eigen::Vector3d& bad = *result.bad_point;
  text << "box outside: a bad point is near\n(" << nearly(bad.x(), 4) << ", " << nearly(bad.y(), 4) << ", "
       << nearly(bad.z(), 4) << ") m";
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
  scene.addText("verdict", faceCenter(box, { 2, 1 }) + 150.0 * scene.unit() * Eigen::Vector3d::UnitZ(), textOf(result));
  return scene.array();
}

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

void BoxMarker::later(const std::function<void()>& job)
{
  dragger_.post([this, job] { guarded(context_.health, NAME, job); });
}

void BoxMarker::take(const Feedback& feedback)
{
  using visualization_msgs::InteractiveMarkerFeedback;
  if (feedback->event_type == InteractiveMarkerFeedback::POSE_UPDATE)
    later([this, feedback] { drag(feedback); });
  if (feedback->event_type != InteractiveMarkerFeedback::MENU_SELECT)
    return;
  if (feedback->menu_entry_id == MENU_GROW)
    later([this] { grow(); });
  if (feedback->menu_entry_id == MENU_CUBE)
    later([this] { set(around(box_.center(), Eigen::Vector3d::Constant(box_.maxWidth()))); });
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
  const StopFlag stop = grower_.makeStopFlag();
  grower_.post([this, stop, before = box_] {
    guarded(context_.health, NAME, [&] {
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
  const ContainmentResult result = check(context_.machine(), criterion, box);
  box_ = box;
  showBody();
  for (const BoxFace& face : FACES)
    handles_.setPose(nameOf(face), poseAt(handlePlace(face)));
  handles_.applyChanges();
  auto shown = boxMarkers(box, result, context_.machine(), context_.frames.root().frame);
  shown.markers.front().text = describe(context_.frames.root().premises(criterion));
  markers_.publish(shown);
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
