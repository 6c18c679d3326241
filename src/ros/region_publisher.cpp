// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/ros/region_publisher.h"

#include <pkm_workspace/JointRanges.h>
#include <ros/console.h>
#include <visualization_msgs/MarkerArray.h>

#include "pkm_workspace/dexterity/defaults.h"
#include "pkm_workspace/dexterity/workspace_bounds.h"
#include "pkm_workspace/region/center_space.h"
#include "pkm_workspace/ros/conversions.h"
#include "pkm_workspace/ros/markers.h"
#include "pkm_workspace/ros/paving_message.h"
#include "pkm_workspace/ros/set_surface.h"

namespace pkm_workspace
{
namespace
{
constexpr double SECONDS = 5.0;          // a picture is not worth more
constexpr std::int64_t BOXES = 2000000;  // nor can rviz draw much more
}  // namespace

RegionPublisher::RegionPublisher(NodeContext& context, Tool* tool, Interaction& interaction)
  : context_(context)
  , tool_(tool)
  , interaction_(interaction)
  , region_(context.private_node.advertise<Region>("region", 1, true))
  , joint_ranges_(context.private_node.advertise<JointRanges>("joint_ranges", 1, true))
  , markers_(context.private_node.advertise<visualization_msgs::MarkerArray>("markers", 1, true))
  , surfaces_(context)
{}

void RegionPublisher::publish(const RegionQuestion& question, const Region& region)
{
  region_.publish(region);
  joint_ranges_.publish(jointRangesOf(region));
  if (tool_ && region.size > 0.0)
    moveMachine(question, region);
  const bool holds_box = region.size > 0.0 && region.vertices.empty();  // of a polytope the center may be a corner
  if (holds_box && question.in.frame == context_.frames.root().frame)
    interaction_.placeBox(region);
}

void RegionPublisher::moveMachine(const RegionQuestion& question, const Region& region)
{
  const ToolState moved = tool_->moveTo(question.in.toRoot() * fromMessage(region.center));
  if (!moved.objection.empty())
    ROS_WARN_STREAM_NAMED("joint_states", "the model cannot go to the center of the region: " << moved.objection);
}

void RegionPublisher::publishMarkers(const RegionQuestion& question, const Region& region, const StopFlag& stop)
{
  const auto set = setFor(question, region, stop);
  draw(question, region, set.get());
  draw_again_ = [this, question, region] { draw(question, region, set_.get()); };
  if (!set)
    draw_again_ = nullptr;
}

void RegionPublisher::draw(const RegionQuestion& question, const Region& region, const SetPicture* set)
{
  const Premises premises = question.in.premises(question.query.criterion);
  const Machine& machine = *question.in.machine;
  const DrawnRails& rails = context_.urdf.drawn_rails;
  const auto shown = markersOf(region, premises, machine, rails, set);
  markers_.publish(inRoot(shown, question.in, context_.frames.root().frame));
  context_.panel.moveTo(question.in.toRoot() * placeOfHypotheses(region, machine, rails));
  context_.panel.tell("region", shown.markers.front().text, set ? set->legend() : Legend());
}

/// Across parallel rails, of a flat region or where nothing ends the set along them, the plane of the region's center.
Box RegionPublisher::pavedBox(const RegionQuestion& question, const Region& region)
{
  const Machine& machine = *question.in.machine;
  if (machine.hasParallelRails())
  {
    const Box all = boundsOfSet(machine, question.query.criterion);
    const bool is_flat = question.query.shape->volume(1.0).upper() == 0.0;
    if (!is_flat && (all.upper - all.lower).allFinite())
      return all;
    const int axis = mainAxisOfRails(machine);
    const Eigen::Vector3d center = region.size > 0.0 ? fromMessage(region.center) : machine.zero();
    return boundsAcrossRails(machine, question.query.criterion, axis, center[axis]);
  }
  RegionQuery everywhere = question.query;
  everywhere.search_box.reset();
  return centerSpace(machine, everywhere).centers;
}

PavingQuery RegionPublisher::pavingQuery(const RegionQuestion& question, const Region& region) const
{
  const Machine& machine = *question.in.machine;
  PavingQuery wanted;
  wanted.criterion = question.query.criterion;
  wanted.box = pavedBox(question, region);
  wanted.resolution = context_.parameters.paving_resolution;
  if (wanted.resolution == 0.0)
    wanted.resolution = defaultResolution(machine, *wanted.box);
  wanted.budget.time_limit = SECONDS;
  wanted.budget.max_boxes = BOXES;
  wanted.budget.threads = question.query.budget.threads;
  wanted.budget.max_memory = question.query.budget.max_memory;
  return wanted;
}

std::shared_ptr<const SetPicture> RegionPublisher::setFor(const RegionQuestion& question, const Region& region,
                                                          const StopFlag& stop)
{
  if (!context_.parameters.show_paving)
    return nullptr;
  try
  {
    PavingQuery wanted = pavingQuery(question, region);
    if ((wanted.box->lower.array() > wanted.box->upper.array()).any())
      return nullptr;  // no point satisfies the criterion
    Problems differences;
    if (paving_)
      validateEarlier(*question.in.machine, wanted, *paving_, differences);
    if (paving_ && differences.empty())
      return set_;
    wanted.budget.stop = stop.get();
    paving_ = std::make_shared<const Paving>(pave(*question.in.machine, wanted));
    const BoxTree& tree = paving_->tree;
    ROS_INFO_NAMED("paving", "set at resolution %g m: %ld boxes inside, %ld at its border; %.3g s", wanted.resolution,
                   static_cast<long>(tree.count(CellState::INSIDE)),
                   static_cast<long>(tree.count(CellState::BOUNDARY) + tree.count(CellState::PENDING)),
                   paving_->seconds);
    if (*stop)
    {
      paving_.reset();  // it is not what was asked for
      return nullptr;
    }
    const bool with_boundary = context_.parameters.show_boundary;
    set_ = std::make_shared<const SetSurface>(*paving_, *question.in.machine, context_.parameters.set_colors,
                                              with_boundary);
    surfaces_.make(question.in, paving_, with_boundary, [this](const std::shared_ptr<const SetPicture>& surface) {
      set_ = surface;
      if (draw_again_)
        draw_again_();
    });
    return set_;
  }
  catch (const std::invalid_argument& error)
  {
    ROS_WARN_STREAM_NAMED("paving", "the markers come without the set around the region: " << error.what());
    return nullptr;
  }
}
}  // namespace pkm_workspace
