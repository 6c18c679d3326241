// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pkm_workspace/BoxList.h>
#include <pkm_workspace/PavingRequest.h>
#include <pkm_workspace/Workspace.h>

#include "pkm_workspace/certificate/certificate_file.h"
#include "pkm_workspace/dexterity/unbounded.h"
#include "pkm_workspace/ros/frames.h"
#include "pkm_workspace/ros/parameters.h"
#include "pkm_workspace/tasks/connection.h"
#include "pkm_workspace/tasks/paving.h"

namespace pkm_workspace
{
/// What the fields of a PavingRequest can do about what has no bounded answer.
const Remedy PAVING_REMEDY{ "joint_limits = ON", "a box by use_box" };

/// What is asked, and of which machine.
struct PavingQuestion
{
  PavingQuery query;
  FramedMachine in;
  std::int64_t max_listed = 0;  ///< boxes in the message
  VolumeQuery volume;           ///< how closely its volume is wanted
  bool components = false;      ///< whether they are asked for
  /// Two points that it is asked of whether they are connected [m], or none.
  std::vector<Eigen::Vector3d> connect = {};
  std::shared_ptr<CertificateFile> certificate = {};
};

/// @param criterion what fields without a value stand for @param parameters other defaults and ceilings
/// @param longest the most that may be asked for as a time limit [s]
/// @throws std::invalid_argument naming every field that is out of range, with its value, unit and range
PavingQuestion fromMessage(const PavingRequest& request, const FramedMachine& in, const Criterion& criterion,
                           const Parameters& parameters, double longest);

/// @param stamp of the message
Workspace toMessage(const PavingQuestion& question, const PavingReport& report, const ros::Time& stamp);

/// What is known of the two points.
void fill(const ConnectionReport& found, Workspace& message);

/// One line for people: what is asked for.
std::string describe(const PavingQuery& query);
}  // namespace pkm_workspace
