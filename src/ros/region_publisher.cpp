// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/ros/region_publisher.h"

#include <pkm_workspace/JointRanges.h>
#include <ros/console.h>
#include <visualization_msgs/MarkerArray.h>

#include "pkm_workspace/region/center_space.h"
#include "pkm_workspace/ros/conversions.h"
#include "pkm_workspace/ros/markers.h"

namespace pkm_workspace
{
namespace
{
constexpr double SECONDS = 5.0;          // a picture is not worth more
constexpr std::int64_t BOXES = 2000000;  // nor can rviz draw much more

bool isSame(const PavingQuery& a, const PavingQuery& b)
{
  return a.criterion == b.criterion && a.box->lower == b.box->lower && a.box->upper == b.box->upper;
}
}  // namespace

RegionPublisher::RegionPublisher(ros::NodeHandle& node, ros::NodeHandle& private_node, const Parameters& parameters,
                                 const UrdfMachine& urdf, const std::atomic<bool>& stop)
  : parameters_(parameters)
  , urdf_(urdf)
  , stop_(stop)
  , region_(private_node.advertise<Region>("region", 1, true))
  , joint_ranges_(private_node.advertise<JointRanges>("joint_ranges", 1, true))
  , markers_(private_node.advertise<visualization_msgs::MarkerArray>("markers", 1, true))
{
  if (parameters.publish_joint_states)
    joint_states_.emplace(node, urdf);
}

void RegionPublisher::publish(const Region& region)
{
  region_.publish(region);
  joint_ranges_.publish(jointRangesOf(region));
  if (joint_states_ && region.size > 0.0)
    moveMachine(region);
}

void RegionPublisher::moveMachine(const Region& region)
{
  try
  {
    joint_states_->moveTo(fromMessage(region.center));
  }
  catch (const std::invalid_argument& error)
  {
    ROS_WARN_STREAM_NAMED("joint_states", "the model stays where it is: " << error.what());
  }
}

void RegionPublisher::publishMarkers(const RegionQuery& query, const Region& region)
{
  markers_.publish(markersOf(region, urdf_.machine, pavingFor(query), parameters_.show_boundary));
}

PavingQuery RegionPublisher::pavingQuery(const RegionQuery& query) const
{
  RegionQuery everywhere = query;
  everywhere.search_box.reset();
  PavingQuery wanted;
  wanted.criterion = query.criterion;
  wanted.box = centerSpace(urdf_.machine, everywhere).centers;
  const bool flat = wanted.box->maxWidth() > 0.0 && ((wanted.box->upper - wanted.box->lower).array() == 0.0).any();
  wanted.resolution = parameters_.paving_resolution;
  if (wanted.resolution == 0.0)
    wanted.resolution = urdf_.machine.scale() / (flat ? 40.0 : 10.0);
  wanted.budget.time_limit = SECONDS;
  wanted.budget.max_boxes = BOXES;
  wanted.budget.threads = query.budget.threads;
  wanted.budget.stop = &stop_;
  return wanted;
}

const Paving* RegionPublisher::pavingFor(const RegionQuery& query)
{
  if (!parameters_.show_paving)
    return nullptr;
  try
  {
    const PavingQuery wanted = pavingQuery(query);
    if (!paved_ || !isSame(*paved_, wanted))
    {
      paving_ = pave(urdf_.machine, wanted);
      paved_ = wanted;
      ROS_INFO_NAMED("paving", "set at resolution %g m: %ld boxes inside, %ld at its border; %.3g s", wanted.resolution,
                     static_cast<long>(paving_->tree.count(CellState::INSIDE)),
                     static_cast<long>(paving_->boxes - paving_->tree.count(CellState::INSIDE)), paving_->seconds);
    }
    return &*paving_;
  }
  catch (const std::invalid_argument& error)
  {
    ROS_WARN_STREAM_NAMED("paving", "the markers come without the set around the region: " << error.what());
    return nullptr;
  }
}
}  // namespace pkm_workspace
