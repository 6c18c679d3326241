// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/ros/frames.h"

#include "pkm_workspace/ros/reply.h"

namespace pkm_workspace
{
Frames::Frames(const Machine& machine, const std::string& root)
  : root_{ root, std::make_shared<const Machine>(machine), Eigen::Isometry3d::Identity() }
{}

FramedMachine Frames::machineIn(const std::string& name) const
{
  if (!name.empty() && name != root_.frame && name != "/" + root_.frame)
    throw Refusal(ErrorCode::UNKNOWN_FRAME, "header.frame_id = '" + name + "' must be empty or '" + root_.frame + "'");
  return root_;
}
}  // namespace pkm_workspace
