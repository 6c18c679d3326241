// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <geometry_msgs/Point.h>
#include <geometry_msgs/Pose.h>
#include <geometry_msgs/Vector3.h>
#include <pkm_workspace/JointRanges.h>
#include <pkm_workspace/Region.h>
#include <pkm_workspace/RegionRequest.h>

#include <memory>
#include <optional>
#include <string>

#include "pkm_workspace/certificate/certificate_file.h"
#include "pkm_workspace/dexterity/unbounded.h"
#include "pkm_workspace/region/largest_region.h"
#include "pkm_workspace/ros/frames.h"
#include "pkm_workspace/ros/parameters.h"

namespace pkm_workspace
{
/// The only place where messages are made from values of the library, and values from messages.

geometry_msgs::Point toMessage(const Eigen::Vector3d& point);
geometry_msgs::Vector3 asVector(const Eigen::Vector3d& v);
geometry_msgs::Quaternion toMessage(const Eigen::Quaterniond& turn);
geometry_msgs::Pose toMessage(const Pose& pose);
Eigen::Vector3d fromMessage(const geometry_msgs::Point& point);
Pose fromMessage(const geometry_msgs::Pose& pose);

/// What the fields of a RegionRequest can do about what has no bounded answer.
const Remedy REGION_REMEDY{ "joint_limits = ON", "a search box by use_search_box" };

/// @param defaults what fields without a value stand for
/// @param own the shape and place that the node has @param longest the most that may be asked for as a time limit [s]
/// @throws std::invalid_argument naming every field that is out of range, with its value, unit and range
RegionQuery fromMessage(const RegionRequest& request, const Machine& machine, const RegionQuery& defaults,
                        const Parameters& own, double longest);

/// What is asked, and of which machine.
struct RegionQuestion
{
  RegionQuery query;
  FramedMachine in;
  std::shared_ptr<CertificateFile> certificate = {};  ///< that follows the search, or none
};

/// A computation that has ended: what was asked, and the answer.
struct Answer
{
  RegionQuestion question;
  LargestRegion region;
};

/// @param stamp of the message
Region toMessage(const Answer& answer, const ros::Time& stamp);

/// The header of what is known in the machine's frame.
std_msgs::Header headerOf(const FramedMachine& in, const ros::Time& stamp);

/// The part of a region's message that is published for those who choose drives.
JointRanges jointRangesOf(const Region& region);

/// One line for people: what is asked for.
std::string describe(const RegionQuery& query);
/// One line for people: size and its bound with their unit, center, effort.
std::string summary(const Answer& answer);
}  // namespace pkm_workspace
