// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <geometry_msgs/Point.h>
#include <pkm_workspace/JointRanges.h>
#include <pkm_workspace/Region.h>
#include <pkm_workspace/RegionRequest.h>

#include <optional>
#include <string>

#include "pkm_workspace/region/largest_region.h"

namespace pkm_workspace
{
/// The only place where messages are made from values of the library, and values from messages.

geometry_msgs::Point toMessage(const Eigen::Vector3d& point);
Eigen::Vector3d fromMessage(const geometry_msgs::Point& point);

/// @param defaults what fields without a value stand for; its time limit is the most that a request may ask for
/// @throws std::invalid_argument naming every field that is out of range, with its value, unit and range
RegionQuery fromMessage(const RegionRequest& request, const RegionQuery& defaults);

/// A computation that has ended: what was asked, and the answer.
struct Answer
{
  RegionQuery query;
  LargestRegion region;
};

/// @param header of the message: when and in which frame
Region toMessage(const Answer& answer, const Machine& machine, const std_msgs::Header& header);

/// The part of a region's message that is published for those who choose drives.
JointRanges jointRangesOf(const Region& region);

/// One line for people: size and its bound with their unit, center, effort.
std::string summary(const Answer& answer);
}  // namespace pkm_workspace
