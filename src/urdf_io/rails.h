// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <string>
#include <vector>

#include "model.h"
#include "pkm_workspace/common/problems.h"

namespace pkm_workspace
{
namespace urdf_io
{
/// One actuated joint of the machine, seen from the root link.
struct Rail
{
  const urdf::Joint* joint;
  Frame slider;         ///< frame of its child link at joint value 0
  IntervalVector axis;  ///< unit direction
  int direction;        ///< as in Leg
};

/// Finds the three rails: those named, or the only prismatic joints there are. Rails that are proved to be parallel
/// share a direction, and no others do.
/// @throws std::invalid_argument when there are other than three, or what carries them moves
std::array<Rail, 3> findRails(const Model& model, const std::vector<std::string>& names);
}  // namespace urdf_io
}  // namespace pkm_workspace
