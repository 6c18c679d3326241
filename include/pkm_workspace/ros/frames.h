// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <memory>
#include <string>

#include "pkm_workspace/machine/machine.h"

namespace pkm_workspace
{
/// A machine as it stands in a frame: what is asked for in that frame is computed for this machine.
struct FramedMachine
{
  std::string frame;                       ///< its name in tf
  std::shared_ptr<const Machine> machine;  ///< all numbers in that frame
  Eigen::Isometry3d to_root;               ///< from that frame to the machine's root link, in floating point
};

/// The frames that a request may be made in.
class Frames
{
public:
  /// @param machine in the frame of its root link @param root the name of that frame in tf
  Frames(const Machine& machine, const std::string& root);

  /// The machine in the frame of its root link.
  const FramedMachine& root() const { return root_; }
  /// The machine in a frame. @param name empty: the root's
  /// @throws Refusal that names the frames there are
  FramedMachine machineIn(const std::string& name) const;

private:
  FramedMachine root_;
};
}  // namespace pkm_workspace
